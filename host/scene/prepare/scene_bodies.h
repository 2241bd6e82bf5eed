#pragma once

#include <vector>

#include "host/scene/model/scene.h"
#include "host/world/world.h"

namespace offing::scene {

/// Which mesh a body moves: the first one if the body names none. Throws Error(bad_input) that names the
/// place in the scene for a mesh that it does not have.
std::size_t mesh_of_body(const Scene& scene, std::size_t body);

/// The bodies of a scene; `meshes` are those of prepare_meshes(). Throws Error(bad_input) that names the
/// place in the scene for a mesh that it does not have, two bodies of one mesh, one that is no hull, one that
/// sinks, bodies without a sea, and meshes aboard of none.
std::vector<world::BodySettings> prepare_bodies(const Scene& scene,
                                                const std::vector<world::MeshParameters>& meshes);

/// How long bodies come to lie in the water before their start: long enough for their wakes.
double run_up_s(const Scene& scene);

/// Which body a wake follows. Throws Error(bad_input) for a name that no body has, or a scene without bodies.
std::size_t followed_body(const Scene& scene, std::size_t wake);

/// Puts the bodies of a scene that has changed on the water of a world that has its meshes. Those with
/// another start, hull or load begin anew now; all others go on from where they are. Throws what
/// prepare_bodies() throws, and has changed nothing then.
void edit_bodies(world::World& world, const Scene& before, const Scene& after);

}  // namespace offing::scene

#pragma once

#include <memory>
#include <vector>

#include "host/base/rgba_image.h"
#include "host/highlights/tracks/highlight_tracker.h"
#include "host/scene/model/scene.h"
#include "host/world/world.h"

namespace offing::scene {

/// The meshes of a scene, as they are at its start: their files are read, their shapes made. Throws what
/// mesh_data() and mesh_rules_at() throw.
std::vector<world::MeshParameters> prepare_meshes(const Scene& scene);

/// What the texture of highlights is made of, each file once. Throws Error(bad_input) that names the place in
/// the scene for a file that is missing or no PNG, and for a texture that needs one and has none.
std::vector<std::shared_ptr<const RgbaImage>> prepare_images(const Scene& scene);

// At one time, whatever was asked before. All throw Error(bad_input) for a time beyond 1e8 s.

/// One a mesh.
std::vector<world::MeshMaterial> mesh_materials_at(const Scene& scene, double time_s);
/// Those of each mesh, with their lights and pictures by index. The sun is the light behind all lights.
/// Throws Error(bad_input) that names the place in the scene for a light that it does not have.
std::vector<std::vector<highlights::HighlightRule>> mesh_rules_at(const Scene& scene, double time_s);
/// The lights beside the sun.
std::vector<world::Light> lights_at(const Scene& scene, double time_s);

/// Gives a world the lights, materials and rules that its scene has at a time.
void set_meshes_at(world::World& world, const Scene& scene, double time_s);

/// Eye, lights and, while it is up, the sun of a scene at any time, in the world's axes, in the order of
/// World::lighting(). Its own copy of what it needs: the scene may go; a ground, on which an eye on foot
/// stands, must stay.
highlights::LightingAt lighting_of(const Scene& scene, const world::WorldTerrain* terrain = nullptr);

/// Whether meshes differ in more than their looks.
bool are_other_meshes(const Scene& before, const Scene& after);

/// Makes the meshes of a world, which are those of `before`, those of `after`: anew only where more than
/// their looks and their rules have changed. Throws what prepare_meshes() throws, and has changed nothing
/// then.
void edit_meshes(world::World& world, const Scene& before, const Scene& after);

/// Puts a camera south of the meshes, where it sees all of them as they are at a time.
void look_at_meshes(const std::vector<world::MeshParameters>& meshes, double time_s, Camera& camera);

}  // namespace offing::scene

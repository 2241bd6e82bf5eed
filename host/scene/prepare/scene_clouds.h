#pragma once

#include <optional>

#include "host/scene/model/scene.h"
#include "host/scene/prepare/cloud_shapes.h"
#include "host/world/world.h"
#include "host/world/world_clouds.h"

namespace offing::scene {

/// One cloud of [[cloud]] with what its genus fills in, but for a shape in place of balls. Throws
/// Error(bad_input) for values that do not fit each other.
clouds::CloudParameters cloud_parameters_of(const Scene& scene, std::size_t index);

/// The clouds of a scene: those of [[cloud]] in their order, then those of the layers. Files are read.
/// Nothing for a scene without any. Throws Error(bad_input) that names the place in the scene for a file that
/// is missing or wrong, and for values that do not fit each other.
std::optional<world::CloudSkyParameters> prepare_clouds(const Scene& scene);
/// The same with shapes that are kept from one call to the next.
std::optional<world::CloudSkyParameters> prepare_clouds(const Scene& scene, CloudShapes& shapes);

/// Makes all that a scene says of its clouds what another one says.
void copy_clouds(const Scene& from, Scene& to);

/// Whether scenes say other things of their clouds.
bool are_other_clouds(const Scene& before, const Scene& after);

/// Gives a world whose clouds are those of `before` those of `after`: anew only where they differ. Throws
/// what prepare_clouds() throws, and has changed nothing then.
void edit_clouds(world::World& world, const Scene& before, const Scene& after);

}  // namespace offing::scene

#pragma once

#include <optional>

#include "host/ocl/device.h"
#include "host/scene/ocean_scene.h"
#include "host/world/clouds_view.h"
#include "host/world/world.h"

namespace offing::scene {

/// The clouds of a scene: those of [[cloud]] in their order, then those of the layers. Files are read
/// (cloud_shape.h). Nothing for a scene without any. Throws Error(bad_input) that names the place in the
/// scene for a file that is missing or wrong, and for values that do not fit each other.
std::optional<world::CloudSkyParameters> prepare_clouds(const OceanScene& scene);

/// Gives a world whose clouds are those of `before` those of `after`: anew only where they differ. Throws
/// what prepare_clouds() throws, and has changed nothing then.
void edit_clouds(world::World& world, const OceanScene& before, const OceanScene& after);

}  // namespace offing::scene

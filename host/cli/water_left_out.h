#pragma once

#include "host/scene/ocean_scene.h"

namespace offing::cli {

/// Warns of each part of a scene that moves the water of its world and not the sea alone: wakes, bodies, and
/// ground that waves run up. `results` are what lack it, such as "frames".
void warn_of_water_left_out(const scene::OceanScene& scene, const char* results);

}  // namespace offing::cli

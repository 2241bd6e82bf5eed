#pragma once

#include "host/scene/model/scene.h"

namespace offing::cli {

/// Warns of each part of a scene whose effect on the water is not in the maps of the sea: wakes, bodies and
/// shores. `results` names what leaves it out, such as "frames".
void warn_of_water_left_out(const scene::Scene& scene, const char* results);

}  // namespace offing::cli

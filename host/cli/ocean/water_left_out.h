#pragma once

#include <string>
#include <vector>

#include "host/scene/model/scene.h"

namespace offing::cli {

struct LeftOut {
  std::string part;  ///< "[[ocean.wake]] 1"
  const char* what;  ///< "its water"
};

/// Each part of a scene whose effect on the water is not in the maps of the sea: wakes, bodies and shores.
std::vector<LeftOut> water_left_out(const scene::Scene& scene);

/// Warns of these parts. `results` names what leaves them out, such as "frames".
void warn_of_water_left_out(const scene::Scene& scene, const char* results);

}  // namespace offing::cli

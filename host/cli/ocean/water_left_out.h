#pragma once

#include <string>
#include <vector>

#include "host/scene/model/scene.h"

namespace offing::cli {

struct LeftOut {
  std::string part;  ///< "[[ocean.wake]] 1"
  const char* what;  ///< "its water"
};

/// Whether results have wake windows, and in them the water that bodies move.
enum class WakeUse { left_out, included };

/// Each part of a scene whose effect on the water is not in results: wakes, bodies and shores.
std::vector<LeftOut> water_left_out(const scene::Scene& scene, WakeUse wakes);

/// Warns of these parts. `results` names what leaves them out, such as "frames".
void warn_of_water_left_out(const scene::Scene& scene, const char* results, WakeUse wakes);

}  // namespace offing::cli

// What moves water in a scene but is left out of results.
#include "host/cli/ocean/water_left_out.h"

#include <cstddef>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

namespace offing::cli {

std::vector<LeftOut> water_left_out(const scene::Scene& scene, WakeUse wakes) {
  std::vector<LeftOut> parts;
  if (wakes == WakeUse::left_out) {
    for (std::size_t i = 0; i < scene.ocean.wakes.size(); ++i) {
      parts.push_back({fmt::format("[[ocean.wake]] {}", i + 1), "its water"});
    }
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
      const std::string& name = scene.bodies[i].name;
      parts.push_back(
          {name.empty() ? fmt::format("[[body]] {}", i + 1) : fmt::format("[[body]] \"{}\"", name),
           "the water that it moves"});
    }
  }
  if (scene.terrain.is_given && scene.ocean.shoaling == scene::Shoaling::on) {
    parts.push_back({"[terrain]", "the effect of shores on the waves"});
  }
  return parts;
}

void warn_of_water_left_out(const scene::Scene& scene, const char* results, WakeUse wakes) {
  for (const auto& [part, what] : water_left_out(scene, wakes)) {
    spdlog::warn("{}: {} leave out {}; offing-view and worlds of the C interface include it", part, results,
                 what);
  }
}

}  // namespace offing::cli

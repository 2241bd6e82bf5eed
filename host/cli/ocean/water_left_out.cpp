// The warning of what moves water in a scene but is left out of results.
#include "host/cli/ocean/water_left_out.h"

#include <cstddef>
#include <string>

#include <spdlog/spdlog.h>

namespace offing::cli {

void warn_of_water_left_out(const scene::Scene& scene, const char* results) {
  const auto warn = [&](const std::string& part, const char* what) {
    spdlog::warn("{}: {} leave out {}; offing-view and worlds of the C interface include it", part, results,
                 what);
  };
  for (std::size_t i = 0; i < scene.ocean.wakes.size(); ++i) {
    warn(fmt::format("[[ocean.wake]] {}", i + 1), "its water");
  }
  for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
    const std::string& name = scene.bodies[i].name;
    warn(fmt::format("[[body]] {}", name.empty() ? fmt::format("{}", i + 1) : fmt::format("\"{}\"", name)),
         "the water that it moves");
  }
  if (scene.terrain.is_given && scene.ocean.shoaling == scene::Shoaling::on) {
    warn("[terrain]", "the effect of shores on the waves");
  }
}

}  // namespace offing::cli

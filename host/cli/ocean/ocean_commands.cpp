#include "host/cli/ocean/ocean_commands.h"

#include <string>

#include <spdlog/spdlog.h>

namespace offing::cli {

void add_ocean_command(CLI::App& app, GlobalOptions& options) {
  CLI::App* ocean =
      app.add_subcommand("ocean", "a sea: bake its maps, certify it, ask for its water, look at spectra");
  ocean->require_subcommand(1);
  add_bake_command(*ocean, options);
  add_stats_command(*ocean, options);
  add_query_command(*ocean, options);
  add_spectrum_command(*ocean, options);
}

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

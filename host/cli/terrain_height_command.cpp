#include "host/cli/terrain_height_command.h"

#include <memory>

#include <fmt/format.h>

#include "host/base/argument.h"
#include "host/cli/terrain_input.h"
#include "host/cli/terrain_place.h"

namespace offing::cli {

namespace {

struct TerrainHeightArguments {
  TerrainInput input;
  std::string at;
  bool json = false;
};

void run(const TerrainHeightArguments& arguments) {
  const auto place = read_numbers("--at", arguments.at, 2, "X,Z", "1200,350.5");
  const HeightMapFile file = arguments.input.read();
  const terrain::GroundPoint ground = ground_under("--at", file.map, place[0], place[1]);
  if (arguments.json) {
    print_json({{"height_m", ground.height_m},
                {"normal", to_json(ground.normal)},
                {"slope_deg", slope_deg(ground.normal)}});
  } else {
    fmt::print("height {:.3f} m, slope {:.2f} degrees, normal ({:.4f}, {:.4f}, {:.4f})\n", ground.height_m,
               slope_deg(ground.normal), ground.normal.x, ground.normal.y, ground.normal.z);
  }
}

}  // namespace

void add_terrain_height_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainHeightArguments>();
  CLI::App* command = terrain.add_subcommand("height", "height, normal and slope of the ground at a point");
  arguments->input.add_to(*command);
  command->add_option("--at", arguments->at, "where, m")->type_name("X,Z")->required();
  command->add_flag("--json", arguments->json, "results for scripts");
  add_global_options(*command, options, DeviceUse::none);
  command->footer(fmt::format("\n{}\n\nExample:\n  offing terrain height S33W071.tif --at 47000,55000 --json",
                              place_footer));
  command->callback([arguments] { run(*arguments); });
}

}  // namespace offing::cli

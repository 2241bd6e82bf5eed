#include "host/cli/terrain_los_command.h"

#include <algorithm>
#include <memory>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/argument.h"
#include "host/cli/device_choice.h"
#include "host/cli/terrain_input.h"
#include "host/cli/terrain_place.h"

namespace offing::cli {

namespace {

// A target on the ground is not hidden by the ground that it lies on: hits are right to 1e-3 cells and 2^-23.
constexpr double slack_cells = 2e-3, slack_share = 2e-7;

struct TerrainLosArguments {
  TerrainInput input;
  std::string from, to;
  bool json = false;
};

glm::dvec3 read_eye(const char* flag, const std::string& text, const HeightMap& map) {
  const auto numbers = read_numbers(flag, text, 3, "X,Z,H", "1200,350,1.7");
  if (numbers[2] < 0.0) throw bad_argument(flag, "a height above ground of 0 or more", text, "1200,350,1.7");
  return {numbers[0], ground_under(flag, map, numbers[0], numbers[1]).height_m + numbers[2], numbers[1]};
}

void run(const TerrainLosArguments& arguments, const GlobalOptions& options) {
  const HeightMapFile file = arguments.input.read();
  const HeightMap& map = file.map;
  const glm::dvec3 from = read_eye("--from", arguments.from, map), to = read_eye("--to", arguments.to, map);
  const double distance_m = glm::length(to - from);
  const double slack_m = slack_cells * std::max(map.spacing_x_m, map.spacing_z_m) + slack_share * distance_m;
  if (distance_m <= 2.0 * slack_m) {
    throw bad_argument("--to", "another place than --from", arguments.to, "1200,350,1.7");
  }
  // From one slack to the other: both ends may lie on the ground.
  const glm::dvec3 way = (to - from) / distance_m;
  const terrain::Ray ray{
      .origin_m = from + slack_m * way, .direction = way, .limit_m = distance_m - 2.0 * slack_m};
  terrain::HeightField field = make_field(map, ocl::Device::open(choose_one_device(options.device)));
  const TerrainHit hit = field.cast(std::span(&ray, 1))[0];
  const bool is_visible = hit.kind == TERRAIN_MISS;
  const double hidden_at_m = slack_m + static_cast<double>(hit.distance_m);
  if (arguments.json) {
    nlohmann::ordered_json json = {{"visible", is_visible}, {"distance_m", distance_m}};
    if (!is_visible) {
      json["hidden_at_m"] = hidden_at_m;
      json["hidden_by_m"] = to_json(from + hidden_at_m * way);
    }
    print_json(json);
  } else if (is_visible) {
    fmt::print("visible, {:.1f} m away\n", distance_m);
  } else {
    const glm::dvec3 by_m = from + hidden_at_m * way;
    fmt::print("hidden: ground at ({:.1f}, {:.1f}, {:.1f}), {:.1f} m of {:.1f} m\n", by_m.x, by_m.y, by_m.z,
               hidden_at_m, distance_m);
  }
}

}  // namespace

void add_terrain_los_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainLosArguments>();
  CLI::App* command = terrain.add_subcommand("los", "line of sight: whether two points see each other");
  arguments->input.add_to(*command);
  command->add_option("--from", arguments->from, "one end, m")->type_name("X,Z,H")->required();
  command->add_option("--to", arguments->to, "the other end, m")->type_name("X,Z,H")->required();
  command->add_flag("--json", arguments->json, "results for scripts");
  add_global_options(*command, options, DeviceUse::one);
  command->footer(
      fmt::format("\n{}\nThe Earth is taken as flat.\n\n"
                  "Example:\n  offing terrain los S33W071.tif --from 47000,80000,1.7 --to 47000,20000,30",
                  place_footer));
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include <fmt/format.h>

#include "host/base/argument.h"
#include "host/cli/terrain/earth_curve_flags.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/cli/terrain/terrain_source.h"
#include "host/command_line/new_output.h"
#include "host/command_line/setting_options.h"
#include "host/io/atomic_file.h"

namespace offing::cli {

namespace {

constexpr double most_points = 1e7;

struct ProfileSettings {
  std::optional<double> step_m;
};

struct TerrainProfileArguments {
  TerrainInput input;
  EarthCurveFlags curve;
  std::string from, to, output;
  SettingOptions<ProfileSettings> settings;
  Existing existing = Existing::keep;
};

void run(const TerrainProfileArguments& arguments) {
  const auto from = read_numbers("--from", arguments.from, 2, "X,Z", "0,0");
  const auto to = read_numbers("--to", arguments.to, 2, "X,Z", "1200,350");
  const bool prints = arguments.output.empty() || is_standard_output(arguments.output);
  if (!prints)
    require_new(arguments.output, arguments.existing, {{arguments.input.file()}, arguments.input.trust()});
  const terrain::EarthCurve curve = arguments.curve.read();
  const bool is_curved = arguments.curve.are_given();
  const TerrainSource of(arguments.input, {});
  const terrain::TerrainPosts& posts = of.posts();
  // Both ends are on the map, so that all between them is.
  terrain_under("--from", posts, from[0], from[1]);
  terrain_under("--to", posts, to[0], to[1]);
  const double length_m = std::hypot(to[0] - from[0], to[1] - from[1]);
  const double step_m =
      arguments.settings.read().step_m.value_or(std::min(posts.spacing_x_m, posts.spacing_z_m));
  const double steps = std::max(1.0, std::ceil(length_m / step_m));
  if (steps > most_points) {
    throw bad_argument("--step-m", fmt::format("a step of at least {:g} m here", length_m / most_points),
                       fmt::format("{:g}", step_m), "10");
  }
  std::string text =
      fmt::format("distance_m,x_m,z_m,height_m,measured{}\n", is_curved ? ",fallen_height_m" : "");
  for (double step = 0.0; step <= steps; ++step) {
    const double share = step / steps;
    const double x_m = std::lerp(from[0], to[0], share), z_m = std::lerp(from[1], to[1], share);
    const double height_m = terrain_under("--to", posts, x_m, z_m).height_m;
    const double distance_m = share * length_m;
    text += fmt::format("{:.9g},{:.9g},{:.9g},{:.7g},{}", distance_m, x_m, z_m, height_m,
                        *terrain::is_measured_at(posts, x_m, z_m) ? 1 : 0);
    if (is_curved) text += fmt::format(",{:.7g}", height_m - curve.bend_perm() * distance_m * distance_m);
    text += '\n';
  }
  if (prints) {
    fmt::print("{}", text);
  } else {
    write_file_atomically(arguments.output, text, arguments.existing);
  }
}

}  // namespace

void add_terrain_profile_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainProfileArguments>();
  CLI::App* command = terrain.add_subcommand("profile", "print heights along a line as CSV");
  arguments->input.add_to(*command);
  command->add_option("--from", arguments->from, "start of the line, in m")->type_name("X,Z")->required();
  command->add_option("--to", arguments->to, "end of the line, in m")->type_name("X,Z")->required();
  arguments->settings.add_to(*command, {{&ProfileSettings::step_m,
                                         {.key = "step_m",
                                          .unit = "m",
                                          .low = 1e-3,
                                          .high = 1e6,
                                          .help = "largest distance between heights",
                                          .example = "10",
                                          .absent = "the spacing of the posts"}}});
  arguments->curve.add_to(*command);
  command->add_option("-o,--output", arguments->output, "CSV file to write (- or default: standard output)")
      ->type_name("FILE");
  add_force_flag(*command, arguments->existing);
  add_global_options(*command, options, DeviceUse::none);
  command->footer(fmt::format(
      "\n{}\nIn the CSV, measured is 0 where the map has a void, which is filled in. With --curvature, "
      "fallen_height_m is\nthe height of the ground above a level line from the start of the profile.\n\n"
      "Example:\n  offing terrain profile S33W071.tif --from 0,55000 --to 90000,55000 --step-m 100",
      place_footer));
  command->callback([arguments] { run(*arguments); });
}

}  // namespace offing::cli

#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <glm/vec2.hpp>

#include "host/base/argument.h"
#include "host/cli/terrain/earth_curve_flags.h"
#include "host/cli/terrain/place_system.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/cli/terrain/terrain_source.h"
#include "host/command_line/new_output.h"
#include "host/command_line/setting_options.h"
#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"

namespace offing::cli {

namespace {

constexpr double most_points = 1e7;

struct ProfileSettings {
  std::optional<double> step_m;
};

struct TerrainProfileArguments {
  TerrainInput input;
  EarthCurveFlags curve;
  PlaceFlags places;
  std::string from, to, output;
  SettingOptions<ProfileSettings> settings;
  Existing existing = Existing::keep;
};

void run(const TerrainProfileArguments& arguments) {
  const std::string crs = arguments.places.system();
  const GivenPlace given_from = read_place("--from", arguments.from, PlaceForm::plan, crs, "0,0");
  const GivenPlace given_to = read_place("--to", arguments.to, PlaceForm::plan, crs, "1200,350");
  const bool prints = arguments.output.empty() || is_standard_output(arguments.output);
  refuse_vector_name(arguments.output, {".csv"});
  if (!prints)
    require_new(arguments.output, arguments.existing, {{arguments.input.file()}, arguments.input.trust()});
  const terrain::EarthCurve curve = arguments.curve.read();
  const bool is_curved = arguments.curve.are_given();
  const TerrainSource of(arguments.input, {});
  const terrain::TerrainPosts& posts = of.posts();
  const PlaceSystem system(of.frame(), crs);
  const glm::dvec2 from = system.within_map("--from", given_from.place),
                   to = system.within_map("--to", given_to.place);
  // Both ends are on the map, so that all between them is.
  terrain_under("--from", posts, from.x, from.y);
  terrain_under("--to", posts, to.x, to.y);
  const double length_m = std::hypot(to.x - from.x, to.y - from.y);
  const double step_m =
      arguments.settings.read().step_m.value_or(std::min(posts.spacing_x_m, posts.spacing_z_m));
  const double steps = std::max(1.0, std::ceil(length_m / step_m));
  if (steps > most_points) {
    throw bad_argument("--step-m", fmt::format("a step of at least {:g} m here", length_m / most_points),
                       fmt::format("{:g}", step_m), "10");
  }
  std::vector<glm::dvec2> line_m;
  for (double step = 0.0; step <= steps; ++step) {
    const double share = step / steps;
    line_m.emplace_back(std::lerp(from.x, to.x, share), std::lerp(from.y, to.y, share));
  }
  const std::vector<glm::dvec2> line = system.of_map(line_m);
  const int digits = system.is_local() ? 9 : 14;
  std::string text = fmt::format("distance_m,{},{},height_m,measured{}\n", system.first(), system.second(),
                                 is_curved ? ",fallen_height_m" : "");
  for (std::size_t i = 0; i < line.size(); ++i) {
    const double x_m = line_m[i].x, z_m = line_m[i].y;
    const double height_m = terrain_under("--to", posts, x_m, z_m).height_m;
    const double distance_m = static_cast<double>(i) / steps * length_m;
    text += fmt::format("{:.9g},{:.{}g},{:.{}g},{:.7g},{}", distance_m, line[i].x, digits, line[i].y, digits,
                        height_m, *terrain::is_measured_at(posts, x_m, z_m) ? 1 : 0);
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
  command->add_option("--from", arguments->from, "start of the line: m, or coordinates of --crs")
      ->type_name("X,Z")
      ->required();
  command->add_option("--to", arguments->to, "end of the line, as --from")->type_name("X,Z")->required();
  arguments->places.add_to(*command);
  arguments->settings.add_to(*command,
                             {{&ProfileSettings::step_m,
                               {.key = "step_m",
                                .unit = "m",
                                .low = 1e-3,
                                .high = 1e6,
                                .help = "largest distance between heights, which are equally spaced",
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

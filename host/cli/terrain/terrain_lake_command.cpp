#include <cmath>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "host/base/work.h"
#include "host/cli/terrain/place_system.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/cli/terrain/terrain_source.h"
#include "host/command_line/new_output.h"
#include "host/command_line/print_results.h"
#include "host/command_line/setting_options.h"
#include "host/io/atomic_file.h"
#include "host/io/file_extension.h"
#include "host/terrain/lakes/lake.h"

namespace offing::cli {

namespace {

struct LakeSettingsOfCommand {
  std::optional<double> level_m;
};

struct TerrainLakeArguments {
  TerrainInput input;
  PlaceFlags places;
  std::string at, output;
  SettingOptions<LakeSettingsOfCommand> settings;
  bool json = false;
  Existing existing = Existing::keep;
};

/// To a millimetre.
double rounded(double value_m) {
  return std::round(1e3 * value_m) / 1e3;
}

nlohmann::ordered_json measures_of(const terrain::Lake& lake) {
  return {{"level_m", lake.level_m},
          {"spill_level_m", lake.spill_level_m},
          {"area_m2", lake.area_m2},
          {"volume_m3", lake.volume_m3},
          {"greatest_depth_m", lake.greatest_depth_m}};
}

/// One feature: a polygon with the islands as holes.
nlohmann::ordered_json outline_json(const terrain::Lake& lake, const terrain::TerrainPosts& posts,
                                    const PlaceSystem& system) {
  nlohmann::ordered_json rings = nlohmann::ordered_json::array();
  for (const std::vector<glm::dvec2>& ring_m : terrain::outline_of(lake, posts)) {
    nlohmann::ordered_json ring = nlohmann::ordered_json::array();
    for (const glm::dvec2& place : system.of_map(ring_m)) ring.push_back({place.x, place.y});
    rings.push_back(std::move(ring));
  }
  const nlohmann::ordered_json feature = {{"type", "Feature"},
                                          {"properties", measures_of(lake)},
                                          {"geometry", {{"type", "Polygon"}, {"coordinates", rings}}}};
  return {{"type", "FeatureCollection"}, {"features", {feature}}};
}

void run(const TerrainLakeArguments& arguments, const CancelToken& cancel) {
  const std::string crs = arguments.places.system();
  const GivenPlace given = read_place("--at", arguments.at, PlaceForm::plan, crs, "1200,350.5");
  if (!arguments.output.empty()) {
    require_extension(arguments.output, {".geojson", ".json"});
    require_new(arguments.output, arguments.existing, {{arguments.input.file()}, arguments.input.trust()});
  }
  const TerrainSource of(arguments.input, {});
  const PlaceSystem system(of.frame(), crs);
  const glm::dvec2 place_m = system.within_map("--at", given.place);
  const terrain::Lake lake = terrain::fill_lake(of.posts(), place_m.x, place_m.y,
                                                arguments.settings.read().level_m, "--at", Work(cancel));
  if (!arguments.output.empty()) {
    write_file_atomically(arguments.output, outline_json(lake, of.posts(), system).dump() + "\n",
                          arguments.existing);
  }
  if (arguments.json) {
    nlohmann::ordered_json json = measures_of(lake);
    json["spill_m"] = {lake.spill_m.x, lake.spill_m.y};
    if (!system.is_local()) json["spill"] = system.to_json(lake.spill_m);
    print_json(json);
  } else {
    fmt::print("level {:.3f} m, area {:.6g} m2, volume {:.6g} m3, greatest depth {:.3f} m\n", lake.level_m,
               lake.area_m2, lake.volume_m3, lake.greatest_depth_m);
    fmt::print("spill level {:.3f} m, at {}\n", lake.spill_level_m,
               system.text({rounded(lake.spill_m.x), rounded(lake.spill_m.y)}, rounded(lake.spill_level_m)));
  }
}

}  // namespace

void add_terrain_lake_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainLakeArguments>();
  CLI::App* command =
      terrain.add_subcommand("lake", "fill a basin with water: level, area, volume and outline");
  arguments->input.add_to(*command);
  command->add_option("--at", arguments->at, "a place in the lake: m, or coordinates of --crs")
      ->type_name("X,Z")
      ->required();
  arguments->settings.add_to(*command,
                             {{&LakeSettingsOfCommand::level_m, like_scene("lake.level_m", "--level-m")}});
  arguments->places.add_to(*command);
  command
      ->add_option("-o,--output", arguments->output,
                   "GeoJSON of the outline to write, in the system of --crs")
      ->type_name("FILE");
  command->add_flag("--json", arguments->json, "print the results as JSON");
  add_force_flag(*command, arguments->existing);
  add_global_options(*command, options, DeviceUse::none);
  command->footer(fmt::format(
      "\n{}\nThe lake covers all ground below the level that is connected to the place. Above the spill "
      "level, water\nwould run off the map.\n\nExamples:\n"
      "  offing terrain lake S33W071.tif --at 47000,55000\n"
      "  offing terrain lake S33W071.tif --crs lonlat --at -70.3,-32.8 --level-m 2700 -o lake.geojson",
      place_footer));
  command->callback([arguments, &options] { run(*arguments, options.cancel); });
}

}  // namespace offing::cli

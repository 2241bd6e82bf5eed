#include <cstdint>
#include <memory>

#include <fmt/format.h>

#include "host/cli/terrain/place_system.h"
#include "host/cli/terrain/terrain_batch.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/cli/terrain/terrain_source.h"
#include "host/command_line/print_results.h"

namespace offing::cli {

namespace {

struct TerrainHeightArguments {
  TerrainInput input;
  TerrainBatch batch;
  PlaceFlags places;
  bool smooth_normals = false;
  std::string at;
  bool json = false;
};

struct Answer {
  terrain::TerrainPoint terrain;
  bool is_measured;
};

/// `place` names where the question comes from.
Answer answer_to(const TerrainHeightArguments& arguments, const std::string& place,
                 const terrain::TerrainPosts& posts, double x_m, double z_m) {
  terrain::TerrainPoint terrain = terrain_under(place, posts, x_m, z_m);
  if (arguments.smooth_normals) terrain.normal = *terrain::smooth_normal_at(posts, x_m, z_m);
  return {terrain, *terrain::is_measured_at(posts, x_m, z_m)};
}

void answer_one(const TerrainHeightArguments& arguments, const terrain::TerrainPosts& posts,
                const PlaceSystem& system, const glm::dvec2& place) {
  const glm::dvec2 place_m = system.within_map("--at", place);
  const auto [terrain, is_measured] = answer_to(arguments, "--at", posts, place_m.x, place_m.y);
  if (arguments.json) {
    nlohmann::ordered_json json = {{"height_m", terrain.height_m},
                                   {"normal", to_json(terrain.normal)},
                                   {"slope_deg", slope_deg(terrain.normal)},
                                   {"measured", is_measured}};
    if (!system.is_local()) json["place"] = system.to_json(place_m);
    print_json(json);
  } else {
    fmt::print("height {:.3f} m, slope {:.2f} degrees, normal ({:.4f}, {:.4f}, {:.4f}){}\n", terrain.height_m,
               slope_deg(terrain.normal), terrain.normal.x, terrain.normal.y, terrain.normal.z,
               is_measured ? "" : "; not measured: the map has a void here, which was filled in");
  }
}

void run(const TerrainHeightArguments& arguments, const GlobalOptions& options) {
  arguments.batch.require_question(arguments.at, arguments.input);
  const std::string crs = arguments.places.system();
  GivenPlace place;
  if (!arguments.batch.is_asked())
    place = read_place("--at", arguments.at, PlaceForm::plan, crs, "1200,350.5");
  const TerrainSource of(arguments.input, {});
  if (!arguments.batch.is_asked())
    return answer_one(arguments, of.posts(), PlaceSystem(of.frame(), crs), place.place);
  arguments.batch.answer(
      *arguments.batch.open(of.frame(), crs), of.frame(),
      {{"height_m", 9},
       {"normal_x", 7},
       {"normal_y", 7},
       {"normal_z", 7},
       {"slope_deg", 7},
       {"measured", 0, AttributeKind::whole}},
      [&](const QuestionBlock& block, std::vector<AttributeValue>& values) {
        for (std::size_t i = 0; i < block.rows.size(); i += 2) {
          const auto [terrain, is_measured] =
              answer_to(arguments, block.place_of(i / 2), of.posts(), block.rows[i], block.rows[i + 1]);
          values.insert(values.end(), {terrain.height_m, terrain.normal.x, terrain.normal.y, terrain.normal.z,
                                       slope_deg(terrain.normal), std::int64_t{is_measured ? 1 : 0}});
        }
      },
      options);
}

}  // namespace

void add_terrain_height_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainHeightArguments>();
  CLI::App* command =
      terrain.add_subcommand("height", "print height, normal and slope of the ground at a point");
  arguments->input.add_to(*command);
  command->add_option("--at", arguments->at, "the point: m, or coordinates of --crs")->type_name("X,Z");
  arguments->places.add_to(*command);
  command->add_flag(
      "--smooth-normals", arguments->smooth_normals,
      "smooth normal and slope, from the posts around the patch (default: from the patch alone)");
  command->add_flag("--json", arguments->json, "print the results as JSON");
  arguments->batch.add_to(
      *command,
      {{.names = {"x_m", "z_m"}, .meaning = "for each point, its x and z in m", .example = "1200,350.5"},
       {{.prefix = "", .x = 0, .z = 1}}},
      "--at");
  add_global_options(*command, options, DeviceUse::none);
  command->footer(
      fmt::format("\n{}\nmeasured is 1 if the map has a height there, 0 in a filled "
                  "void.\n\nExamples:\n  offing terrain height S33W071.tif --at 47000,55000 --json\n"
                  "  offing terrain height S33W071.tif --crs lonlat --at -70.5,-32.6\n"
                  "  offing terrain height S33W071.tif --points wells.csv -o heights.csv\n"
                  "  offing terrain height S33W071.tif --points wells.gpkg -o heights.gpkg",
                  place_footer));
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli

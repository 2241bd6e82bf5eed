#include <array>
#include <cstdint>
#include <memory>
#include <span>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "host/cli/common/device_choice.h"
#include "host/cli/terrain/earth_curve_flags.h"
#include "host/cli/terrain/place_system.h"
#include "host/cli/terrain/store_flags.h"
#include "host/cli/terrain/terrain_batch.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/cli/terrain/terrain_source.h"
#include "host/command_line/print_results.h"
#include "host/terrain/analysis/line_of_sight.h"

namespace offing::cli {

namespace {

using terrain::LineOfSight;

struct TerrainLosArguments {
  TerrainInput input;
  CacheFlags cache;
  TerrainBatch batch;
  EarthCurveFlags curve;
  PlaceFlags places;
  std::string from, to;
  bool json = false;
};

/// Between two points, each as x, z and the height above ground. Errors name the place of a bad one.
LineOfSight sight_between(const terrain::TerrainPosts& posts, const terrain::EarthCurve& curve,
                          const std::string& from_place, std::span<const double> from,
                          const std::string& to_place, std::span<const double> to) {
  const auto end = [&](const std::string& place, std::span<const double> point) {
    terrain_under(place, posts, point[0], point[1]);  // with the hint of commands
    return terrain::SightEnd{place, point[0], point[1], point[2]};
  };
  return {posts, curve, end(from_place, from), end(to_place, to)};
}

void answer_one(const LineOfSight& sight, const terrain::RayHit& hit, const PlaceSystem& system,
                bool is_json) {
  const bool is_visible = hit.kind == TERRAIN_MISS;
  const glm::dvec3 by_m = hit.rounded_m(sight.point_m(sight.hidden_at_m(hit)));
  if (is_json) {
    nlohmann::ordered_json json = {{"visible", is_visible}, {"distance_m", sight.distance_m()}};
    if (!is_visible) {
      json["hidden_at_m"] = sight.hidden_at_m(hit);
      json["hidden_by_m"] = to_json(by_m);
      if (!system.is_local()) json["hidden_by"] = system.to_json({by_m.x, by_m.z}, &by_m.y);
    }
    print_json(json);
  } else if (is_visible) {
    fmt::print("visible, {:.9g} m away\n", sight.distance_m());
  } else {
    fmt::print("hidden: ground at ({}, {}, {}), {} m of {:.9g} m\n", by_m.x, by_m.y, by_m.z,
               sight.hidden_at_m(hit), sight.distance_m());
  }
}

void answer_all(const TerrainLosArguments& arguments, TerrainSource& terrain, QuestionFile& questions,
                const GlobalOptions& options) {
  const terrain::EarthCurve curve = arguments.curve.read();
  arguments.batch.answer(
      questions, terrain.frame(), {{"visible", 0, AttributeKind::whole}, {"distance_m", 9}, {"hidden_at_m"}},
      [&](const QuestionBlock& block, std::vector<AttributeValue>& values) {
        std::vector<LineOfSight> sights;
        std::vector<terrain::Ray> rays;
        for (std::size_t i = 0; i < block.rows.size(); i += 6) {
          const std::string place = block.place_of(i / 6);
          const std::span<const double> row = std::span(block.rows).subspan(i, 6);
          sights.push_back(sight_between(terrain.posts(), curve, place, row.first(3), place, row.subspan(3)));
          rays.push_back(sights.back().ray());
        }
        const std::vector<terrain::RayHit> hits = terrain.cast(rays, curve);
        for (std::size_t i = 0; i < hits.size(); ++i) {
          const bool is_visible = hits[i].kind == TERRAIN_MISS;
          values.insert(values.end(),
                        {std::int64_t{is_visible ? 1 : 0}, sights[i].distance_m(),
                         is_visible ? AttributeValue() : AttributeValue(sights[i].hidden_at_m(hits[i]))});
        }
      },
      options);
}

void run(const TerrainLosArguments& arguments, const GlobalOptions& options) {
  arguments.batch.require_question(arguments.from, arguments.input);
  const std::string crs = arguments.places.system();
  if (arguments.batch.is_asked()) {
    TerrainSource terrain(arguments.input, arguments.cache);
    const std::unique_ptr<QuestionFile> questions = arguments.batch.open(terrain.frame(), crs);
    terrain.open(ocl::Device::open(choose_one_device(options.device)));
    return answer_all(arguments, terrain, *questions, options);
  }
  const terrain::EarthCurve curve = arguments.curve.read();
  const GivenPlace from = read_place("--from", arguments.from, PlaceForm::above_ground, crs, "1200,350,1.7");
  const GivenPlace to = read_place("--to", arguments.to, PlaceForm::above_ground, crs, "1200,350,1.7");
  TerrainSource terrain(arguments.input, arguments.cache);
  const PlaceSystem system(terrain.frame(), crs);
  const auto end = [&](const char* flag, const GivenPlace& given) {
    const glm::dvec2 place_m = system.within_map(flag, given.place);
    return std::array{place_m.x, place_m.y, given.height_m};
  };
  const LineOfSight sight =
      sight_between(terrain.posts(), curve, "--from", end("--from", from), "--to", end("--to", to));
  terrain.open(ocl::Device::open(choose_one_device(options.device)));
  const terrain::Ray ray = sight.ray();
  answer_one(sight, terrain.cast(std::span(&ray, 1), curve)[0], system, arguments.json);
}

}  // namespace

void add_terrain_los_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainLosArguments>();
  CLI::App* command = terrain.add_subcommand("los", "test the line of sight between two points");
  arguments->input.add_to(*command);
  arguments->cache.add_to(*command);
  command->add_option("--from", arguments->from, "one end, in m, or in the system of --crs")
      ->type_name("X,Z,H");
  command->add_option("--to", arguments->to, "the other end, in m")->type_name("X,Z,H")->needs("--from");
  arguments->places.add_to(*command);
  arguments->curve.add_to(*command);
  command->add_flag("--json", arguments->json, "print the results as JSON");
  arguments->batch.add_to(
      *command,
      {{.names = {"from_x_m", "from_z_m", "from_height_m", "to_x_m", "to_z_m", "to_height_m"},
        .meaning = "for each pair, x, z and height above ground of both in m",
        .example = "47000,80000,1.7,47000,20000,30"},
       {{.prefix = "from_", .x = 0, .z = 1}, {.prefix = "to_", .x = 3, .z = 4}}},
      "--from");
  add_global_options(*command, options, DeviceUse::one);
  command->footer(
      fmt::format("\n{}\n\n"
                  "Examples:\n  offing terrain los S33W071.tif --from 47000,80000,1.7 --to 47000,20000,30\n"
                  "  offing terrain los S33W071.tif --crs lonlat --from -70.5,-32.6,1.7 --to -70.4,-32.5,30\n"
                  "  offing terrain los S33W071.tif --points masts.csv -o seen.csv",
                  place_footer));
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli

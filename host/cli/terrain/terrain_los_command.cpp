#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

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
#include "host/command_line/setting_options.h"
#include "host/terrain/analysis/line_of_sight.h"
#include "host/terrain/analysis/sight_clearance.h"

namespace offing::cli {

namespace {

using terrain::LineOfSight;

constexpr double hertz_a_megahertz = 1e6;

struct ClearanceSettings {
  std::optional<double> frequency_mhz;
};

struct TerrainLosArguments {
  TerrainInput input;
  CacheFlags cache;
  TerrainBatch batch;
  EarthCurveFlags curve;
  PlaceFlags places;
  std::string from, to;
  SettingOptions<ClearanceSettings> settings;
  bool clearance = false, json = false;
};

/// What is asked beside visibility.
struct AskedClearance {
  bool is_asked = false;
  std::optional<double> frequency_hz;
};

AskedClearance read_clearance(const TerrainLosArguments& arguments) {
  const std::optional<double> frequency_mhz = arguments.settings.read().frequency_mhz;
  return {arguments.clearance || frequency_mhz,
          frequency_mhz ? std::optional(*frequency_mhz * hertz_a_megahertz) : std::nullopt};
}

/// An end as x, z and the height above ground. Errors name the place of a bad one.
terrain::SightEnd end_of(const terrain::TerrainPosts& posts, std::string_view place,
                         std::span<const double> point) {
  terrain_under(place, posts, point[0], point[1]);  // with the hint of commands
  return {place, point[0], point[1], point[2]};
}

void answer_one(const LineOfSight& sight, const terrain::RayHit& hit, const PlaceSystem& system,
                const std::optional<terrain::SightClearance>& clearance,
                const std::optional<terrain::FresnelClearance>& fresnel, bool is_json) {
  const bool is_visible = hit.kind == TERRAIN_MISS;
  const glm::dvec3 by_m = hit.rounded_m(sight.point_m(sight.hidden_at_m(hit)));
  if (is_json) {
    nlohmann::ordered_json json = {{"visible", is_visible}, {"distance_m", sight.distance_m()}};
    if (!is_visible) {
      json["hidden_at_m"] = sight.hidden_at_m(hit);
      json["hidden_by_m"] = to_json(by_m);
      if (!system.is_local()) json["hidden_by"] = system.to_json({by_m.x, by_m.z}, &by_m.y);
    }
    if (clearance) {
      json["clearance_m"] = clearance->clearance_m;
      json["clearance_at_m"] = clearance->at_m;
      json["clearance_ground_m"] = {clearance->x_m, clearance->ground_m, clearance->z_m};
      if (!system.is_local())
        json["clearance_ground"] = system.to_json({clearance->x_m, clearance->z_m}, &clearance->ground_m);
    }
    if (fresnel) {
      json["fresnel_share"] = fresnel->share;
      json["fresnel_at_m"] = fresnel->at_m;
      json["fresnel_radius_m"] = fresnel->radius_m;
    }
    print_json(json);
    return;
  }
  if (is_visible) {
    fmt::print("visible, {:.9g} m away\n", sight.distance_m());
  } else {
    fmt::print("hidden: ground at {}, {} m of {:.9g} m\n", system.text({by_m.x, by_m.z}, by_m.y),
               sight.hidden_at_m(hit), sight.distance_m());
  }
  if (clearance) {
    const auto millimetres = [](double value_m) { return std::round(1e3 * value_m) / 1e3; };
    fmt::print("smallest clearance {:.3f} m, at {:.3f} m: above ground at {}\n", clearance->clearance_m,
               clearance->at_m,
               system.text({millimetres(clearance->x_m), millimetres(clearance->z_m)},
                           millimetres(clearance->ground_m)));
  }
  if (fresnel) {
    fmt::print("smallest share of the first Fresnel zone {:.4f}, at {:.3f} m, where its radius is {:.3f} m\n",
               fresnel->share, fresnel->at_m, fresnel->radius_m);
  }
}

std::vector<AnswerColumn> answer_columns(const AskedClearance& asked) {
  std::vector<AnswerColumn> columns{{"visible", 0, AttributeKind::whole}, {"distance_m", 9}, {"hidden_at_m"}};
  if (asked.is_asked) columns.insert(columns.end(), {{"clearance_m", 7}, {"clearance_at_m", 9}});
  if (asked.frequency_hz) columns.insert(columns.end(), {{"fresnel_share", 6}, {"fresnel_at_m", 9}});
  return columns;
}

void answer_all(const TerrainLosArguments& arguments, TerrainSource& terrain, QuestionFile& questions,
                const GlobalOptions& options) {
  const terrain::EarthCurve curve = arguments.curve.read();
  const AskedClearance asked = read_clearance(arguments);
  arguments.batch.answer(
      questions, terrain.frame(), answer_columns(asked),
      [&](const QuestionBlock& block, std::vector<AttributeValue>& values) {
        const terrain::TerrainPosts& posts = terrain.posts();
        const auto ends_of_row = [&](std::size_t row, const std::string& place) {
          const std::span<const double> numbers = std::span(block.rows).subspan(6 * row, 6);
          return std::pair(end_of(posts, place, numbers.first(3)), end_of(posts, place, numbers.subspan(3)));
        };
        std::vector<LineOfSight> sights;
        std::vector<terrain::Ray> rays;
        for (std::size_t i = 0; i < block.count; ++i) {
          const std::string place = block.place_of(i);
          const auto [from, to] = ends_of_row(i, place);
          sights.emplace_back(posts, curve, from, to);
          rays.push_back(sights.back().ray());
        }
        const std::vector<terrain::RayHit> hits = terrain.cast(rays, curve);
        for (std::size_t i = 0; i < hits.size(); ++i) {
          const bool is_visible = hits[i].kind == TERRAIN_MISS;
          values.insert(values.end(),
                        {std::int64_t{is_visible ? 1 : 0}, sights[i].distance_m(),
                         is_visible ? AttributeValue() : AttributeValue(sights[i].hidden_at_m(hits[i]))});
          if (!asked.is_asked) continue;
          const auto [from, to] = ends_of_row(i, {});
          const terrain::SightClearance clearance = terrain::sight_clearance(posts, curve, from, to);
          values.insert(values.end(), {clearance.clearance_m, clearance.at_m});
          if (!asked.frequency_hz) continue;
          const terrain::FresnelClearance fresnel =
              terrain::fresnel_clearance(posts, curve, from, to, *asked.frequency_hz);
          values.insert(values.end(), {fresnel.share, fresnel.at_m});
        }
      },
      options);
}

void run(const TerrainLosArguments& arguments, const GlobalOptions& options) {
  arguments.batch.require_question(arguments.from, arguments.input);
  const std::string crs = arguments.places.system();
  const AskedClearance asked = read_clearance(arguments);
  if (arguments.batch.is_asked()) {
    TerrainSource terrain(arguments.input, arguments.cache);
    const std::unique_ptr<QuestionFile> questions = arguments.batch.open(terrain.frame(), crs);
    terrain.open(ocl::Device::open(choose_one_device(options.device)));
    return answer_all(arguments, terrain, *questions, options);
  }
  const terrain::EarthCurve curve = arguments.curve.read();
  const GivenPlace given_from =
      read_place("--from", arguments.from, PlaceForm::above_ground, crs, "1200,350,1.7");
  const GivenPlace given_to = read_place("--to", arguments.to, PlaceForm::above_ground, crs, "1200,350,1.7");
  TerrainSource terrain(arguments.input, arguments.cache);
  const terrain::TerrainPosts& posts = terrain.posts();
  const PlaceSystem system(terrain.frame(), crs);
  const auto end = [&](const char* flag, const GivenPlace& given) {
    const glm::dvec2 place_m = system.within_map(flag, given.place);
    return end_of(posts, flag, std::array{place_m.x, place_m.y, given.height_m});
  };
  const terrain::SightEnd from = end("--from", given_from), to = end("--to", given_to);
  const LineOfSight sight(posts, curve, from, to);
  std::optional<terrain::SightClearance> clearance;
  std::optional<terrain::FresnelClearance> fresnel;
  if (asked.is_asked) clearance = terrain::sight_clearance(posts, curve, from, to);
  if (asked.frequency_hz) fresnel = terrain::fresnel_clearance(posts, curve, from, to, *asked.frequency_hz);
  terrain.open(ocl::Device::open(choose_one_device(options.device)));
  const terrain::Ray ray = sight.ray();
  answer_one(sight, terrain.cast(std::span(&ray, 1), curve)[0], system, clearance, fresnel, arguments.json);
}

}  // namespace

void add_terrain_los_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainLosArguments>();
  CLI::App* command = terrain.add_subcommand("los", "test the line of sight between two points");
  arguments->input.add_to(*command);
  arguments->cache.add_to(*command);
  command
      ->add_option("--from", arguments->from,
                   "one end: m, or coordinates of --crs, and then the height above ground")
      ->type_name("X,Z,H");
  command->add_option("--to", arguments->to, "the other end, as --from")->type_name("X,Z,H")->needs("--from");
  arguments->places.add_to(*command);
  arguments->curve.add_to(*command);
  command->add_flag("--clearance", arguments->clearance,
                    "also print how near the line comes to the ground, and where");
  arguments->settings.add_to(
      *command,
      {{&ClearanceSettings::frequency_mhz,
        {.key = "frequency_mhz",
         .unit = "MHz",
         .low = 1.0,
         .high = 1e6,
         .help = "also print the smallest clearance as a share of the first Fresnel zone's radius, at "
                 "this frequency; implies --clearance",
         .example = "2400",
         .absent = "none"}}});
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
                  "  offing terrain los S33W071.tif --from 47000,80000,30 --to 47000,20000,30 "
                  "--frequency-mhz 2400 --curvature\n"
                  "  offing terrain los S33W071.tif --points links.csv -o seen.csv",
                  place_footer));
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli

#include <cmath>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include <CLI/Option.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/argument.h"
#include "host/cli/common/device_choice.h"
#include "host/cli/terrain/earth_curve_flags.h"
#include "host/cli/terrain/place_system.h"
#include "host/cli/terrain/store_flags.h"
#include "host/cli/terrain/terrain_batch.h"
#include "host/cli/terrain/terrain_commands.h"
#include "host/cli/terrain/terrain_place.h"
#include "host/cli/terrain/terrain_source.h"
#include "host/command_line/print_results.h"

namespace offing::cli {

namespace {

struct TerrainRayArguments {
  TerrainInput input;
  CacheFlags cache;
  TerrainBatch batch;
  EarthCurveFlags curve;
  PlaceFlags places;
  bool smooth_normals = false;
  std::string from, to, direction;
  bool json = false;
};

glm::dvec3 read_vector(const char* flag, const std::string& text, const char* example) {
  const auto numbers = read_numbers(flag, text, 3, "X,Y,Z", example);
  return {numbers[0], numbers[1], numbers[2]};
}

/// What the flags of a single ray say.
struct GivenRay {
  GivenPlace from, to;
  glm::dvec3 direction{};
  bool has_target = false;
};

GivenRay read_given(const TerrainRayArguments& arguments, const std::string& crs) {
  GivenRay ray;
  ray.from = read_place("--from", arguments.from, PlaceForm::height, crs, "100,2500,100");
  ray.has_target = !arguments.to.empty();
  if (ray.has_target == !arguments.direction.empty()) {
    throw Error(ErrorKind::bad_usage, "terrain ray: expected one of --to and --direction",
                "write --to X,Y,Z for a point, or --direction X,Y,Z for a direction");
  }
  if (ray.has_target) {
    ray.to = read_place("--to", arguments.to, PlaceForm::height, crs, "900,1200,400");
  } else {
    ray.direction = read_vector("--direction", arguments.direction, "1,-0.2,0");
  }
  return ray;
}

terrain::Ray ray_of(const TerrainRayArguments& arguments, const GivenRay& given, const PlaceSystem& system) {
  const auto point = [&](const char* flag, const GivenPlace& place) {
    const glm::dvec2 place_m = system.on_map(flag, place.place);
    return glm::dvec3(place_m.x, place.height_m, place_m.y);
  };
  const glm::dvec3 from = point("--from", given.from);
  const glm::dvec3 way = given.has_target ? point("--to", given.to) - from : given.direction;
  const double length_m = glm::length(way);
  // Unequal coordinates may be one place, but for rounding: longitudes of -70.49 and 289.51 degrees.
  const double rounding_m = given.has_target && !system.is_local() ? 1e-6 : 0.0;
  if (length_m <= rounding_m) {
    throw bad_argument(given.has_target ? "--to" : "--direction",
                       given.has_target ? "a point other than --from" : "a direction other than 0,0,0",
                       given.has_target ? arguments.to : arguments.direction, "1,-0.2,0");
  }
  terrain::Ray ray{.origin_m = from, .direction = way / length_m};
  if (given.has_target) ray.limit_m = length_m;
  return ray;
}

const char* name_of(int kind) {
  switch (kind) {
    case TERRAIN_SURFACE:
      return "surface";
    case TERRAIN_SIDE:
      return "side";
    case TERRAIN_INSIDE:
      return "inside";
    default:
      return "miss";
  }
}

terrain::HitNormals normals_of(const TerrainRayArguments& arguments) {
  return arguments.smooth_normals ? terrain::HitNormals::smooth : terrain::HitNormals::patch;
}

/// As terrain::require_valid(); errors name the place that the ray comes from.
void require_valid(const terrain::Ray& ray, const terrain::PostGrid& grid, const std::string& place) {
  try {
    terrain::require_valid(ray, grid);
  } catch (const Error& error) {
    throw Error(error.kind(), fmt::format("{}: {}", place, error.what()), error.hint());
  }
}

/// Where the ray hit, with the decimals that its distance has; as the map has heights: the ground falls away
/// by a curve.
glm::dvec3 point_of(const terrain::Ray& ray, const terrain::RayHit& hit, const terrain::EarthCurve& curve) {
  const glm::dvec3 way_m = hit.distance_m * ray.direction;
  const double plan_m = std::hypot(way_m.x, way_m.z);
  return hit.rounded_m(ray.origin_m + way_m + glm::dvec3(0.0, curve.bend_perm() * plan_m * plan_m, 0.0));
}

void answer_one(const terrain::RayHit& hit, const glm::dvec3& point_m, const PlaceSystem& system,
                bool is_json) {
  const glm::dvec3 normal(hit.normal_x, hit.normal_y, hit.normal_z);
  const bool is_hit = hit.kind != TERRAIN_MISS;
  if (is_json) {
    nlohmann::ordered_json json = {{"hit", name_of(hit.kind)}};
    if (is_hit) {
      json["distance_m"] = hit.rounded_m(hit.distance_m);
      json["point_m"] = to_json(point_m);
      if (!system.is_local()) json["point"] = system.to_json({point_m.x, point_m.z}, &point_m.y);
      json["normal"] = to_json(normal);
      json["cell"] = {hit.cell_x, hit.cell_z};
      json["place_in_cell"] = {hit.u, hit.v};
    }
    json["steps"] = hit.steps;
    print_json(json);
  } else if (is_hit) {
    fmt::print("{} at {} m: {}, normal ({:.4f}, {:.4f}, {:.4f}), {} steps\n", name_of(hit.kind),
               hit.rounded_m(hit.distance_m), system.text({point_m.x, point_m.z}, point_m.y), normal.x,
               normal.y, normal.z, hit.steps);
  } else {
    fmt::print("miss, {} steps\n", hit.steps);
  }
}

void answer_all(const TerrainRayArguments& arguments, TerrainSource& terrain, QuestionFile& questions,
                const GlobalOptions& options) {
  const PlaceSystem& system = questions.system();
  const terrain::EarthCurve curve = arguments.curve.read();
  const std::string first = fmt::format("hit_{}", system.first()),
                    second = fmt::format("hit_{}", system.second());
  const int digits = system.is_local() ? 0 : 14;
  const AnswerColumn x{first, digits}, z{second, digits},
      height{system.is_local() ? "hit_y_m" : "hit_height_m"};
  std::vector<AnswerColumn> columns{{"hit", 0, AttributeKind::text}, {"distance_m"}};
  if (system.is_local()) {
    columns.insert(columns.end(), {x, height, z});
  } else {
    columns.insert(columns.end(), {x, z, height});
  }
  columns.insert(columns.end(), {{"normal_x", 7}, {"normal_y", 7}, {"normal_z", 7}});
  arguments.batch.answer(
      questions, terrain.frame(), columns,
      [&](const QuestionBlock& block, std::vector<AttributeValue>& values) {
        std::vector<terrain::Ray> rays;
        const std::vector<double>& rows = block.rows;
        for (std::size_t i = 0; i < rows.size(); i += 6) {
          const glm::dvec3 way(rows[i + 3], rows[i + 4], rows[i + 5]);
          const double length = glm::length(way);
          if (length == 0.0) {
            throw Error(ErrorKind::bad_input,
                        fmt::format("{}: expected a direction, found 0,0,0", block.place_of(i / 6)),
                        "give a direction of any length above 0");
          }
          rays.push_back({.origin_m = {rows[i], rows[i + 1], rows[i + 2]}, .direction = way / length});
          require_valid(rays.back(), terrain.grid(), block.place_of(i / 6));
        }
        const std::vector<terrain::RayHit> hits = terrain.cast(rays, curve, normals_of(arguments));
        std::vector<glm::dvec3> points_m;
        std::vector<glm::dvec2> plan_m;
        for (std::size_t i = 0; i < hits.size(); ++i) {
          const bool is_hit = hits[i].kind != TERRAIN_MISS;
          points_m.push_back(is_hit ? point_of(rays[i], hits[i], curve) : glm::dvec3(0.0));
          plan_m.emplace_back(points_m[i].x, points_m[i].z);
        }
        const std::vector<glm::dvec2> plan = system.of_map(plan_m);
        for (std::size_t i = 0; i < hits.size(); ++i) {
          const terrain::RayHit& hit = hits[i];
          values.emplace_back(name_of(hit.kind));
          if (hit.kind == TERRAIN_MISS) {
            values.resize(values.size() + columns.size() - 1);
            continue;
          }
          values.emplace_back(hit.rounded_m(hit.distance_m));
          const double height_m = points_m[i].y;
          values.emplace_back(plan[i].x);
          values.emplace_back(system.is_local() ? height_m : plan[i].y);
          values.emplace_back(system.is_local() ? plan[i].y : height_m);
          for (const float part : {hit.normal_x, hit.normal_y, hit.normal_z})
            values.emplace_back(static_cast<double>(part));
        }
      },
      options);
}

void run(const TerrainRayArguments& arguments, const GlobalOptions& options) {
  arguments.batch.require_question(arguments.from, arguments.input);
  const std::string crs = arguments.places.system();
  const bool is_single = !arguments.batch.is_asked();
  const GivenRay given = is_single ? read_given(arguments, crs) : GivenRay{};
  TerrainSource terrain(arguments.input, arguments.cache);
  std::unique_ptr<QuestionFile> questions;
  if (!is_single) questions = arguments.batch.open(terrain.frame(), crs);
  const PlaceSystem system(terrain.frame(), is_single ? crs : local_places);
  const terrain::Ray ray = is_single ? ray_of(arguments, given, system) : terrain::Ray{};
  terrain.open(ocl::Device::open(choose_one_device(options.device)));
  if (!is_single) return answer_all(arguments, terrain, *questions, options);
  const terrain::EarthCurve curve = arguments.curve.read();
  const terrain::RayHit hit = terrain.cast(std::span(&ray, 1), curve, normals_of(arguments))[0];
  answer_one(hit, point_of(ray, hit, curve), system, arguments.json);
}

}  // namespace

void add_terrain_ray_command(CLI::App& terrain, GlobalOptions& options) {
  const auto arguments = std::make_shared<TerrainRayArguments>();
  CLI::App* command = terrain.add_subcommand("ray", "find what a ray hits first");
  arguments->input.add_to(*command);
  arguments->cache.add_to(*command);
  command
      ->add_option("--from", arguments->from,
                   "start of the ray: m, or coordinates of --crs and then the height")
      ->type_name("X,Y,Z");
  command->add_option("--to", arguments->to, "point on the ray where it ends, as --from")
      ->type_name("X,Y,Z")
      ->needs("--from");
  command
      ->add_option("--direction", arguments->direction, "direction of a ray without end; may have any length")
      ->type_name("X,Y,Z")
      ->needs("--from");
  arguments->places.add_to(*command);
  arguments->curve.add_to(*command);
  command->add_flag(
      "--smooth-normals", arguments->smooth_normals,
      "smooth normals, from the posts around the patch that is hit (default: from the patch alone)");
  command->add_flag("--json", arguments->json, "print the results as JSON");
  arguments->batch.add_to(*command,
                          {{.names = {"x_m", "y_m", "z_m", "direction_x", "direction_y", "direction_z"},
                            .meaning = "for each ray, its start in m and its direction, of any length",
                            .example = "47000,6000,80000,0.1,-0.3,-1"},
                           {{.prefix = "", .x = 0, .z = 2, .is_on_map = false}}},
                          "--from");
  add_global_options(*command, options, DeviceUse::one);
  command->footer(fmt::format(
      "\n{}\nA hit is surface, side (the ground is solid at the map's edge) or inside (the ray starts below "
      "ground).\n\n"
      "Examples:\n  offing terrain ray S33W071.tif --from 47000,6000,80000 --direction 0.1,-0.3,-1\n"
      "  offing terrain ray S33W071.tif --points beams.csv -o hits.csv",
      place_footer));
  command->callback([arguments, &options] { run(*arguments, options); });
}

}  // namespace offing::cli

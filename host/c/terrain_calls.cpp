#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/c/arrays.h"
#include "host/c/handles.h"
#include "host/c/watched_work.h"
#include "host/io/height_maps/map_coordinates.h"
#include "host/io/height_maps/read_height_map.h"
#include "host/io/tile_store/tile_store.h"
#include "host/scene/prepare/maps/terrain_sun.h"
#include "host/terrain/analysis/horizons.h"
#include "host/terrain/analysis/line_of_sight.h"
#include "host/terrain/analysis/many_viewsheds.h"
#include "host/terrain/analysis/sight_counts.h"
#include "host/terrain/analysis/sight_limits.h"
#include "host/terrain/analysis/sky_view.h"
#include "host/terrain/analysis/viewshed.h"
#include "host/terrain/lakes/lake.h"

using offing::Error;
using offing::ErrorKind;
using offing::HeightMapFile;
using offing::c::require;
using offing::c::run;
using offing::c::Use;
using offing::c::vector_at;
using offing::c::write_values;
using offing::c::write_vector;
using offing::terrain::EarthCurve;
using offing::terrain::RayHit;

namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
constexpr double no_limit = std::numeric_limits<double>::infinity();

/// Rings one after the other, with two NaN between them.
std::vector<double> outline_values(const offing::terrain::Lake& lake,
                                   const offing::terrain::TerrainPosts& posts) {
  std::vector<double> values;
  for (const std::vector<glm::dvec2>& ring : offing::terrain::outline_of(lake, posts)) {
    if (!values.empty()) values.insert(values.end(), {nowhere, nowhere});
    for (const glm::dvec2& place_m : ring) values.insert(values.end(), {place_m.x, place_m.y});
  }
  return values;
}

/// The last lake, if it is the one that is asked for.
const offing::c::FilledLake& filled_lake(OffingTerrain& terrain, double x_m, double z_m,
                                         const std::optional<double>& level_m) {
  std::optional<offing::c::FilledLake>& last = terrain.lake;
  if (last && last->x_m == x_m && last->z_m == z_m && last->level_m == level_m) return *last;
  last.reset();
  offing::terrain::Lake lake = offing::terrain::fill_lake(terrain.posts, x_m, z_m, level_m);
  std::vector<double> outline_m = outline_values(lake, terrain.posts);
  return last.emplace(offing::c::FilledLake{x_m, z_m, level_m, std::move(lake), std::move(outline_m)});
}

std::string text_of(const char* text) {
  return text == nullptr ? std::string() : std::string(text);
}

/// A value of an enumeration of offing.h, which has `count` of them.
template <class Value, class Given>
Value choice_of(const char* name, Given given, int count) {
  const int value = static_cast<int>(given);
  if (value >= 0 && value < count) return static_cast<Value>(value);
  throw Error(ErrorKind::bad_usage, fmt::format("{}: expected 0 ... {}, got {}", name, count - 1, value),
              "use one of the names in offing.h");
}

static_assert(OFFING_HEIGHTS_PLAIN == static_cast<int>(offing::HeightEncoding::plain) &&
              OFFING_HEIGHTS_MAPBOX == static_cast<int>(offing::HeightEncoding::mapbox) &&
              OFFING_HEIGHTS_TERRARIUM == static_cast<int>(offing::HeightEncoding::terrarium));
static_assert(OFFING_UNIT_OF_FILE == static_cast<int>(offing::HorizontalUnit::of_file) &&
              OFFING_UNIT_METRE == static_cast<int>(offing::HorizontalUnit::metre) &&
              OFFING_UNIT_DEGREE == static_cast<int>(offing::HorizontalUnit::degree));
// 0 is by name.
static_assert(OFFING_RAW_UNSIGNED_16 == 1 + static_cast<int>(offing::RawType::unsigned_16) &&
              OFFING_RAW_SIGNED_16 == 1 + static_cast<int>(offing::RawType::signed_16) &&
              OFFING_RAW_FLOAT_32 == 1 + static_cast<int>(offing::RawType::float_32));

offing::HeightMapOptions map_options(const OffingTerrainOptions& given) {
  offing::HeightMapOptions options;
  if (given.spacing_x_m != 0.0) options.spacing_x_m = given.spacing_x_m;
  if (given.spacing_z_m != 0.0) options.spacing_z_m = given.spacing_z_m;
  if (given.vertical_scale != 0.0) options.vertical_scale = given.vertical_scale;
  options.offset_m = given.offset_m;
  if (given.nodata != nullptr) options.nodata = *given.nodata;
  if (given.void_height_m != nullptr) options.void_height_m = *given.void_height_m;
  options.reproject_to = text_of(given.reproject_to);
  if (given.is_untrusted != 0) options.trust.trust = offing::Trust::untrusted;
  if (given.band != 0) options.band = given.band;
  options.encoding = choice_of<offing::HeightEncoding>("encoding", given.encoding, 3);
  options.horizontal_unit = choice_of<offing::HorizontalUnit>("horizontal_unit", given.horizontal_unit, 3);
  options.exr_channel = text_of(given.exr_channel);
  options.raw_columns = given.raw_columns;
  options.raw_rows = given.raw_rows;
  const int raw_type = choice_of<int>("raw_type", given.raw_type, 4);
  if (raw_type > 0) options.raw_type = static_cast<offing::RawType>(raw_type - 1);
  if (given.is_raw_big_endian != 0) options.raw_byte_order = offing::ByteOrder::big_endian;
  return options;
}

HeightMapFile read_file(const char* file, const OffingTerrainOptions* options) {
  if (offing::is_tile_store(file)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected a height map, found a tile store", offing::one_line(file)),
                "open the map from which the store was made");
  }
  HeightMapFile found =
      offing::read_height_map(file, map_options(offing::c::read_struct(options, "options")));
  offing::warn_of_assumed_spacing(file, found.source);
  return found;
}

HeightMapFile file_of(const float* heights_m, const offing::terrain::PostGrid& grid) {
  offing::terrain::require_valid(grid);
  HeightMapFile file;
  file.map.columns = grid.columns;
  file.map.rows = grid.rows;
  file.map.spacing_x_m = grid.spacing_x_m;
  file.map.spacing_z_m = grid.spacing_z_m;
  file.map.heights_m.assign(heights_m, heights_m + static_cast<std::ptrdiff_t>(grid.columns) * grid.rows);
  file.source.spacing_source = offing::SpacingSource::options;
  return file;
}

OffingTerrainInfo info_of_terrain(const OffingTerrain& terrain) {
  const auto& [map, source] = terrain.file;
  const offing::Georeference& place = map.georeference;
  const bool is_placed = place.step_x != 0.0;
  OffingTerrainInfo info{};
  info.size = sizeof info;
  info.columns = map.columns;
  info.rows = map.rows;
  info.spacing_x_m = map.spacing_x_m;
  info.spacing_z_m = map.spacing_z_m;
  info.lowest_m = terrain.field.lowest_m();
  info.highest_m = terrain.field.highest_m();
  info.void_posts = source.void_posts;
  info.origin_x = is_placed ? place.origin_x : nowhere;
  info.origin_y = is_placed ? place.origin_y : nowhere;
  info.step_x = is_placed ? place.step_x : nowhere;
  info.step_y = is_placed ? place.step_y : nowhere;
  info.centre_latitude_deg = source.centre_latitude_deg.value_or(nowhere);
  info.centre_longitude_deg = source.centre_longitude_deg.value_or(nowhere);
  info.coordinate_system = source.coordinate_system.c_str();
  info.coordinate_system_wkt = place.coordinate_system.c_str();
  info.format = source.format.c_str();
  info.is_spacing_assumed = source.spacing_source == offing::SpacingSource::assumed ? 1 : 0;
  return info;
}

/// Pairs of coordinates, and the argument's name.
template <typename Number>
struct Pairs {
  Number* numbers;
  const char* name;
};

void write_places(OffingTerrain* terrain, const char* system, Pairs<const double> from, Pairs<double> to,
                  std::size_t count,
                  std::vector<glm::dvec2> (offing::MapCoordinates::*way)(std::span<const glm::dvec2>) const) {
  const Use use(terrain, "terrain");
  require(system, "system");
  const auto coordinates =
      offing::map_coordinates(offing::frame_of("terrain", terrain->file.map), system, "system");
  if (count == 0) return;
  require(from.numbers, from.name);
  require(to.numbers, to.name);
  std::vector<glm::dvec2> places;
  places.reserve(count);
  for (std::size_t i = 0; i < count; ++i) places.emplace_back(from.numbers[2 * i], from.numbers[2 * i + 1]);
  places = (*coordinates.*way)(places);
  for (std::size_t i = 0; i < count; ++i) {
    to.numbers[2 * i] = places[i].x;
    to.numbers[2 * i + 1] = places[i].y;
  }
}

/// Zeros of a struct that knows no limits, and of one that asks for none, mean all directions.
offing::terrain::SightLimits limits_of(const OffingViewshed& asked) {
  offing::terrain::SightLimits limits;
  if (asked.azimuth_from_rad != 0.0 || asked.azimuth_to_rad != 0.0) {
    limits.azimuth_from_rad = asked.azimuth_from_rad;
    limits.azimuth_to_rad = asked.azimuth_to_rad;
  }
  if (asked.lowest_rad != 0.0 || asked.highest_rad != 0.0) {
    limits.lowest_rad = asked.lowest_rad;
    limits.highest_rad = asked.highest_rad;
  }
  offing::terrain::require_valid(limits);
  return limits;
}

/// Flat ground for a radius of 0. Throws what require_valid() throws.
EarthCurve curve_of(double earth_radius_m, double refraction) {
  EarthCurve curve;
  if (earth_radius_m != 0.0) curve.radius_m = earth_radius_m;
  curve.refraction = refraction;
  offing::terrain::require_valid(curve);
  return curve;
}

offing::terrain::ViewshedParameters parameters_of(const OffingViewshed& asked) {
  return {.observer_x_m = asked.observer_x_m,
          .observer_z_m = asked.observer_z_m,
          .observer_height_m = asked.observer_height_m,
          .target_height_m = asked.target_height_m,
          .radius_m = asked.radius_m == 0.0 ? no_limit : asked.radius_m,
          .curve = curve_of(asked.earth_radius_m, asked.refraction)};
}

/// Errors name the observer by its index.
std::vector<offing::terrain::Observer> observers_of(const offing::terrain::PostGrid& grid,
                                                    const OffingViewshed& shared,
                                                    const OffingObservers& given) {
  if (given.count > offing::terrain::most_observers) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("observers: expected a count of at most {}, got {}",
                            offing::terrain::most_observers, given.count),
                "cut them into several calls and add the counts");
  }
  std::vector<offing::terrain::Observer> observers;
  observers.reserve(given.count);
  for (std::size_t i = 0; i < given.count; ++i) {
    OffingViewshed asked = shared;
    asked.observer_x_m = given.points_m[2 * i];
    asked.observer_z_m = given.points_m[2 * i + 1];
    if (given.observer_height_m != nullptr) asked.observer_height_m = given.observer_height_m[i];
    if (given.target_height_m != nullptr) asked.target_height_m = given.target_height_m[i];
    if (given.radius_m != nullptr) asked.radius_m = given.radius_m[i];
    if (given.azimuth_rad != nullptr) {
      asked.azimuth_from_rad = given.azimuth_rad[2 * i];
      asked.azimuth_to_rad = given.azimuth_rad[2 * i + 1];
    }
    if (given.elevation_rad != nullptr) {
      asked.lowest_rad = given.elevation_rad[2 * i];
      asked.highest_rad = given.elevation_rad[2 * i + 1];
    }
    try {
      observers.push_back({parameters_of(asked), limits_of(asked)});
      offing::terrain::require_valid(observers.back().parameters, grid);
    } catch (const Error& error) {
      throw Error(error.kind(), fmt::format("observers[{}]: {}", i, error.what()), error.hint());
    }
  }
  return observers;
}

void write_counts(const OffingSightCounts& wanted, const offing::terrain::SightCounts& found,
                  const offing::CancelToken& cancel) {
  const auto write_each = [](std::uint64_t* target, const std::vector<std::size_t>& values) {
    if (target != nullptr) std::copy(values.begin(), values.end(), target);
  };
  if (wanted.counts != nullptr) std::ranges::copy(found.counts(), wanted.counts);
  for (std::size_t post = 0; wanted.is_reached != nullptr && post < found.counts().size(); ++post)
    wanted.is_reached[post] = found.is_reached(post) ? 1 : 0;
  write_each(wanted.seen_posts, found.seen_posts());
  write_each(wanted.reached_posts, found.reached_posts());
  if (wanted.only_posts != nullptr) write_each(wanted.only_posts, found.only_posts());
  if (wanted.best_count == 0) return;
  const offing::terrain::BestObservers best =
      offing::terrain::best_observers(found.each(), wanted.best_count, cancel);
  if (wanted.best != nullptr) std::ranges::copy(best.observers, wanted.best);
  write_each(wanted.best_posts, best.seen_posts);
  if (wanted.is_best_exhaustive != nullptr) *wanted.is_best_exhaustive = best.is_exhaustive ? 1 : 0;
}

int azimuths_of(int azimuths) {
  return azimuths == 0 ? offing::terrain::usual_azimuths : azimuths;
}

/// Where the posts of a band of rows begin among all, and how many they are.
std::pair<std::size_t, std::size_t> posts_of_band(const OffingTerrain& terrain,
                                                  const offing::terrain::RowBand& band) {
  const auto columns = static_cast<std::size_t>(terrain.file.map.columns);
  return {static_cast<std::size_t>(band.first_row) * columns, static_cast<std::size_t>(band.rows) * columns};
}

offing::terrain::HitNormals normals_of(const OffingTerrainQuery& query) {
  return query.has_smooth_normals != 0 ? offing::terrain::HitNormals::smooth
                                       : offing::terrain::HitNormals::patch;
}

/// `point_m` is x and z.
void write_sample(const OffingTerrainSamples& samples, std::size_t index,
                  const offing::terrain::TerrainPosts& posts, const double* point_m, bool is_smooth) {
  const auto found = offing::terrain::terrain_at(posts, point_m[0], point_m[1]);
  if (!found) {
    write_values(samples.height_m, index, {nowhere});
    write_vector(samples.normal, index, glm::dvec3(nowhere));
    write_values(samples.is_measured, index, {std::uint8_t{0}});
    return;
  }
  write_values(samples.height_m, index, {found->height_m});
  if (samples.normal != nullptr) {
    write_vector(
        samples.normal, index,
        is_smooth ? *offing::terrain::smooth_normal_at(posts, point_m[0], point_m[1]) : found->normal);
  }
  if (samples.is_measured != nullptr) {
    const bool is_measured = *offing::terrain::is_measured_at(posts, point_m[0], point_m[1]);
    samples.is_measured[index] = is_measured ? 1 : 0;
  }
}

std::vector<RayHit> cast_rays(OffingTerrain& terrain, std::span<const offing::terrain::Ray> rays,
                              const EarthCurve& curve, offing::terrain::HitNormals normals) {
  // Rays over flat ground have a kernel of their own.
  return curve.bend_perm() == 0.0 ? terrain.field.cast(rays, offing::terrain::CastMethod::parity, normals)
                                  : terrain.field.cast(rays, curve, normals);
}

/// Errors name the ray by its index.
std::vector<offing::terrain::Ray> rays_of(const offing::terrain::PostGrid& grid, const double* origins_m,
                                          const double* directions, const double* limits_m,
                                          std::size_t count) {
  std::vector<offing::terrain::Ray> rays(count);
  for (std::size_t i = 0; i < count; ++i) {
    rays[i] = {.origin_m = vector_at(origins_m, i),
               .direction = vector_at(directions, i),
               .limit_m = limits_m == nullptr ? no_limit : limits_m[i]};
    try {
      offing::terrain::require_valid(rays[i], grid);
    } catch (const Error& error) {
      throw Error(error.kind(), fmt::format("rays[{}]: {}", i, error.what()), error.hint());
    }
  }
  return rays;
}

void write_hit(const OffingHits& hits, std::size_t index, const offing::terrain::Ray& ray, const RayHit& hit,
               const EarthCurve& curve) {
  const bool is_hit = hit.kind != TERRAIN_MISS;
  glm::dvec3 point_m(nowhere), normal(nowhere);
  if (is_hit) {
    const glm::dvec3 way_m = hit.distance_m * ray.direction;
    const double plan_m = std::hypot(way_m.x, way_m.z);
    point_m = ray.origin_m + way_m + glm::dvec3(0.0, curve.bend_perm() * plan_m * plan_m, 0.0);
    normal = {hit.normal_x, hit.normal_y, hit.normal_z};
  }
  write_values(hits.distance_m, index, {is_hit ? hit.distance_m : no_limit});
  write_values(hits.kind, index, {static_cast<std::uint8_t>(hit.kind)});
  write_vector(hits.point_m, index, point_m);
  write_vector(hits.normal, index, normal);
}
static_assert(OFFING_HIT_SURFACE == TERRAIN_SURFACE && OFFING_HIT_SIDE == TERRAIN_SIDE &&
              OFFING_HIT_INSIDE == TERRAIN_INSIDE && OFFING_HIT_NONE == TERRAIN_MISS);

std::vector<offing::terrain::LineOfSight> sight_lines(const offing::terrain::TerrainPosts& posts,
                                                      const EarthCurve& curve, const double* from_m,
                                                      const double* to_m, std::size_t count) {
  std::vector<offing::terrain::LineOfSight> lines;
  lines.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    const std::string from_name = fmt::format("from_m[{}]", i), to_name = fmt::format("to_m[{}]", i);
    const auto end = [i](const std::string& name, const double* ends_m) {
      const glm::dvec3 end_m = vector_at(ends_m, i);
      return offing::terrain::SightEnd{name, end_m.x, end_m.y, end_m.z};
    };
    lines.emplace_back(posts, curve, end(from_name, from_m), end(to_name, to_m));
  }
  return lines;
}

void write_sight_line(const OffingSightLines& lines, std::size_t index,
                      const offing::terrain::LineOfSight& line, const RayHit& hit) {
  const bool is_visible = hit.kind == TERRAIN_MISS;
  const double hidden_at_m = is_visible ? nowhere : line.hidden_at_m(hit);
  write_values(lines.is_visible, index, {static_cast<std::uint8_t>(is_visible ? 1 : 0)});
  write_values(lines.distance_m, index, {line.distance_m()});
  write_values(lines.hidden_at_m, index, {hidden_at_m});
  write_vector(lines.hidden_by_m, index, is_visible ? glm::dvec3(nowhere) : line.point_m(hidden_at_m));
}

}  // namespace

OffingStatus offing_open_terrain(const OffingDevice* device, const char* file,
                                 const OffingTerrainOptions* options, OffingTerrain** terrain) {
  return run([&] {
    require(device, "device");
    require(file, "file");
    require(terrain, "terrain");
    *terrain = new OffingTerrain(device->device, read_file(file, options));
  });
}

OffingStatus offing_make_terrain(const OffingDevice* device, const float* heights_m, int columns, int rows,
                                 double spacing_x_m, double spacing_z_m, OffingTerrain** terrain) {
  return run([&] {
    require(device, "device");
    require(heights_m, "heights_m");
    require(terrain, "terrain");
    *terrain = new OffingTerrain(
        device->device,
        file_of(heights_m,
                {.columns = columns, .rows = rows, .spacing_x_m = spacing_x_m, .spacing_z_m = spacing_z_m}));
  });
}

void offing_free_terrain(OffingTerrain* terrain) {
  delete terrain;
}

OffingStatus offing_get_terrain_info(OffingTerrain* terrain, OffingTerrainInfo* info) {
  return run([&] {
    const Use use(terrain, "terrain");
    offing::c::write_struct(info, "info", info_of_terrain(*terrain));
  });
}

OffingStatus offing_read_terrain(OffingTerrain* terrain, float* heights_m, uint8_t* is_void, size_t count) {
  return run([&] {
    const Use use(terrain, "terrain");
    offing::c::require_count("count", count, terrain->post_count());
    const offing::HeightMap& map = terrain->file.map;
    if (heights_m != nullptr) std::copy(map.heights_m.begin(), map.heights_m.end(), heights_m);
    if (is_void == nullptr) return;
    std::fill_n(is_void, count, std::uint8_t{0});
    std::copy(map.is_void.begin(), map.is_void.end(), is_void);
  });
}

OffingStatus offing_places_to_terrain(OffingTerrain* terrain, const char* system, const double* places,
                                      double* places_m, size_t count) {
  return run([&] {
    write_places(terrain, system, {places, "places"}, {places_m, "places_m"}, count,
                 &offing::MapCoordinates::to_local);
  });
}

OffingStatus offing_places_from_terrain(OffingTerrain* terrain, const char* system, const double* places_m,
                                        double* places, size_t count) {
  return run([&] {
    write_places(terrain, system, {places_m, "places_m"}, {places, "places"}, count,
                 &offing::MapCoordinates::from_local);
  });
}

OffingStatus offing_sample_terrain(OffingTerrain* terrain, const OffingTerrainQuery* query,
                                   const double* points_m, size_t count,
                                   const OffingTerrainSamples* samples) {
  return run([&] {
    const Use use(terrain, "terrain");
    if (count == 0) return;
    require(points_m, "points_m");
    require(samples, "samples");
    const OffingTerrainQuery asked = offing::c::read_struct(query, "query");
    const OffingTerrainSamples wanted = offing::c::read_struct(samples, "samples");
    for (std::size_t i = 0; i < count; ++i)
      write_sample(wanted, i, terrain->posts, points_m + 2 * i, asked.has_smooth_normals != 0);
  });
}

OffingStatus offing_cast_rays(OffingTerrain* terrain, const OffingTerrainQuery* query,
                              const double* origins_m, const double* directions, const double* limits_m,
                              size_t count, const OffingHits* hits) {
  return run([&] {
    const Use use(terrain, "terrain");
    if (count == 0) return;
    require(origins_m, "origins_m");
    require(directions, "directions");
    require(hits, "hits");
    const OffingTerrainQuery asked = offing::c::read_struct(query, "query");
    const OffingHits wanted = offing::c::read_struct(hits, "hits");
    const EarthCurve curve = curve_of(asked.earth_radius_m, asked.refraction);
    const std::vector<offing::terrain::Ray> rays =
        rays_of(terrain->field.grid(), origins_m, directions, limits_m, count);
    const std::vector<RayHit> found = cast_rays(*terrain, rays, curve, normals_of(asked));
    for (std::size_t i = 0; i < count; ++i) write_hit(wanted, i, rays[i], found[i], curve);
  });
}

OffingStatus offing_trace_sight_lines(OffingTerrain* terrain, const OffingTerrainQuery* query,
                                      const double* from_m, const double* to_m, size_t count,
                                      const OffingSightLines* lines) {
  return run([&] {
    const Use use(terrain, "terrain");
    if (count == 0) return;
    require(from_m, "from_m");
    require(to_m, "to_m");
    require(lines, "lines");
    const OffingTerrainQuery asked = offing::c::read_struct(query, "query");
    const OffingSightLines wanted = offing::c::read_struct(lines, "lines");
    const EarthCurve curve = curve_of(asked.earth_radius_m, asked.refraction);
    const std::vector<offing::terrain::LineOfSight> sights =
        sight_lines(terrain->posts, curve, from_m, to_m, count);
    std::vector<offing::terrain::Ray> rays;
    for (const offing::terrain::LineOfSight& sight : sights) rays.push_back(sight.ray());
    const std::vector<RayHit> found = cast_rays(*terrain, rays, curve, offing::terrain::HitNormals::patch);
    for (std::size_t i = 0; i < count; ++i) write_sight_line(wanted, i, sights[i], found[i]);
  });
}

OffingStatus offing_compute_viewshed(OffingTerrain* terrain, const OffingViewshed* viewshed, uint8_t* seen,
                                     size_t count) {
  return run([&] {
    const Use use(terrain, "terrain");
    require(viewshed, "viewshed");
    require(seen, "seen");
    const OffingViewshed asked = offing::c::read_struct(viewshed, "viewshed");
    offing::c::require_count("count", count, terrain->post_count());
    const offing::terrain::ViewshedParameters parameters = parameters_of(asked);
    offing::terrain::require_valid(parameters, terrain->field.grid());
    const offing::terrain::SightLimits limits = limits_of(asked);
    if (!terrain->viewshed) terrain->viewshed.emplace(terrain->device);
    offing::ocl::Buffer<std::uint8_t> found(terrain->device, count, "viewshed");
    terrain->viewshed->at(terrain->field, parameters, found);
    found.read(std::span(seen, count));
    offing::terrain::mark_outside(terrain->field.grid(), terrain->file.map.heights_m, parameters, limits, 0,
                                  std::span(seen, count));
  });
}

OffingStatus offing_count_viewsheds(OffingTerrain* terrain, const OffingViewshed* viewshed,
                                    const OffingObservers* observers, const OffingSightCounts* counts,
                                    size_t count, const OffingProgress* progress) {
  return run([&] {
    const Use use(terrain, "terrain");
    require(viewshed, "viewshed");
    require(observers, "observers");
    require(counts, "counts");
    const OffingObservers given = offing::c::read_struct(observers, "observers");
    const OffingSightCounts wanted = offing::c::read_struct(counts, "counts");
    offing::c::require_count("count", count, terrain->post_count());
    if (given.count > 0) require(given.points_m, "observers.points_m");
    if (wanted.best_count > given.count) {
      throw Error(ErrorKind::bad_usage,
                  fmt::format("counts.best_count: expected at most the {} observers, got {}", given.count,
                              wanted.best_count),
                  "ask for fewer");
    }
    const std::vector<offing::terrain::Observer> all =
        observers_of(terrain->field.grid(), offing::c::read_struct(viewshed, "viewshed"), given);
    const bool keeps_each = wanted.best_count > 0 || wanted.only_posts != nullptr;
    if (keeps_each) offing::terrain::require_room(count, all.size());
    const offing::c::WatchedWork watched(progress);
    offing::terrain::SightCounts found(count, keeps_each);
    offing::terrain::look_from_each(
        terrain->device, terrain->field, terrain->file.map.heights_m, all, offing::terrain::sight_outside,
        [&](std::size_t observer, std::span<const std::uint8_t> seen) {
          found.add(seen);
          watched.work().tell(static_cast<double>(observer + 1) / static_cast<double>(all.size()));
        });
    write_counts(wanted, found, watched.cancel());
  });
}

OffingStatus offing_fill_lake(OffingTerrain* terrain, double x_m, double z_m, const double* level_m,
                              OffingLake* lake, float* depth_m, size_t count, double* outline_m,
                              size_t outline_count) {
  return run([&] {
    const Use use(terrain, "terrain");
    if (depth_m != nullptr) offing::c::require_count("count", count, terrain->post_count());
    const offing::c::FilledLake& last =
        filled_lake(*terrain, x_m, z_m, level_m != nullptr ? std::optional(*level_m) : std::nullopt);
    const offing::terrain::Lake& filled = last.lake;
    const std::vector<double>& outline = last.outline_m;
    if (outline_m != nullptr) offing::c::require_count("outline_count", outline_count, outline.size() / 2);
    if (lake != nullptr) {
      OffingLake found{};
      found.level_m = filled.level_m;
      found.spill_level_m = filled.spill_level_m;
      found.spill_x_m = filled.spill_m.x;
      found.spill_z_m = filled.spill_m.y;
      found.area_m2 = filled.area_m2;
      found.volume_m3 = filled.volume_m3;
      found.greatest_depth_m = filled.greatest_depth_m;
      found.outline_count = outline.size() / 2;
      offing::c::write_struct(lake, "lake", found);
    }
    if (outline_m != nullptr) std::ranges::copy(outline, outline_m);
    if (depth_m == nullptr) return;
    for (std::size_t post = 0; post < count; ++post) {
      const auto columns = static_cast<std::size_t>(terrain->posts.columns);
      const bool is_wet =
          filled.is_wet_at(static_cast<int>(post % columns), static_cast<int>(post / columns));
      depth_m[post] = is_wet ? static_cast<float>(filled.level_m - terrain->file.map.heights_m[post]) : 0.0f;
    }
  });
}

OffingStatus offing_compute_sky_view(OffingTerrain* terrain, const OffingSkyView* sky, float* factors,
                                     float* rises, size_t count) {
  return run([&] {
    const Use use(terrain, "terrain");
    OffingSkyView asked{};
    if (sky != nullptr) asked = offing::c::read_struct(sky, "sky");
    offing::c::require_count("count", count, terrain->post_count());
    offing::terrain::Horizons horizons(terrain->device, terrain->field, azimuths_of(asked.azimuths), {},
                                       curve_of(asked.earth_radius_m, asked.refraction));
    offing::terrain::SkyView view(terrain->device, horizons);
    for (const offing::terrain::RowBand& band : horizons.bands()) {
      const auto [first, posts] = posts_of_band(*terrain, band);
      horizons.at(band);
      if (factors != nullptr) view.read(band, std::span(factors + first, posts));
      for (int i = 0; rises != nullptr && i < horizons.azimuths(); ++i) {
        const auto number = static_cast<std::size_t>(i);
        horizons.read(number, std::span(rises + number * count + first, posts));
      }
    }
  });
}

OffingStatus offing_compute_sun_hours(OffingTerrain* terrain, const OffingSunHours* when, float* hours,
                                      float* energy_kwh, size_t count) {
  return run([&] {
    const Use use(terrain, "terrain");
    require(when, "when");
    require(hours, "hours");
    require(energy_kwh, "energy_kwh");
    const OffingSunHours asked = offing::c::read_struct(when, "when");
    offing::c::require_count("count", count, terrain->post_count());
    offing::scene::SunSettings settings{.from_s = asked.from_s,
                                        .to_s = asked.to_s,
                                        .azimuths = azimuths_of(asked.azimuths),
                                        .curve = curve_of(asked.earth_radius_m, asked.refraction)};
    if (asked.step_s != 0) settings.step_s = asked.step_s;
    if (asked.turbidity != 0.0) settings.linke_turbidity = asked.turbidity;
    std::optional<offing::sky::GeoPosition> place;
    if (asked.has_place != 0) place = {asked.latitude_rad, asked.longitude_rad};
    offing::scene::TerrainSun sun(terrain->device, terrain->field, terrain->file.map,
                                  offing::frame_of("terrain", terrain->file.map), place, settings);
    for (const offing::terrain::RowBand& band : sun.bands()) {
      const auto [first, posts] = posts_of_band(*terrain, band);
      sun.read(band, std::span(hours + first, posts), std::span(energy_kwh + first, posts));
    }
  });
}

#include "host/scene/prepare/scene_terrain.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/host_memory.h"
#include "host/base/time_estimate.h"
#include "host/io/height_maps/read_colour_map.h"
#include "host/io/height_maps/read_height_map.h"
#include "host/io/tile_store/tile_store.h"
#include "host/ocl/disk_cache.h"
#include "host/scene/model/named_file.h"
#include "host/scene/prepare/stored_terrain.h"
#include "host/scene/schema/scene_elements.h"
#include "host/terrain/generate/fractal_terrain.h"
#include "host/terrain/lakes/lake.h"
#include "host/terrain/walk/eye_place.h"
#include "host/terrain/walk/flying_camera.h"

namespace offing::scene {
namespace {

/// A map, or one in tiles.
struct Heights {
  std::shared_ptr<const HeightMap> map = {};
  std::shared_ptr<const world::TerrainTiles> tiles = {};
  std::optional<double> latitude_deg = {};
};

// Of kept maps: those of fewer posts are made about as fast as they are read.
constexpr std::size_t least_kept_posts = 1 << 18, most_kept_posts = 1 << 24;
constexpr ocl::CacheKind made_maps{"heights", "generated terrain", 256'000'000};

// Counts changes to what the same parameters give, beside what the rows that are tried show.
constexpr int made_version = 1;

/// All that shapes generated terrain.
std::string identity_of(const terrain::FractalParameters& ground) {
  return fmt::format("{} {} {} {} {} {} {} {} {} {}", made_version, ground.posts, ground.side_m,
                     ground.relief_m, ground.mean_m, ground.longest_m, ground.roughness, ground.erosion,
                     ground.island_radius_m.value_or(0.0), ground.seed);
}

/// Heights as ocl::DiskCache keeps them, unless some rows are not what is made today.
std::optional<std::vector<float>> kept_heights(const ocl::DiskCache& cache,
                                               const terrain::FractalParameters& ground) {
  const std::optional<std::vector<std::uint8_t>> kept = cache.load(identity_of(ground));
  const auto posts = static_cast<std::size_t>(ground.posts);
  if (!kept || kept->size() != posts * posts * sizeof(float)) return std::nullopt;
  std::vector<float> heights_m(posts * posts);
  std::memcpy(heights_m.data(), kept->data(), kept->size());
  constexpr int rows_tried = 8;
  terrain::FractalTerrain maker(ground);
  std::vector<float> row_m(posts);
  for (int i = 0; i < rows_tried; ++i) {
    const int row = i * (ground.posts - 1) / (rows_tried - 1);
    maker.fill_row(row, row_m);
    const auto first = heights_m.begin() + static_cast<std::ptrdiff_t>(posts) * row;
    if (!std::equal(row_m.begin(), row_m.end(), first)) return std::nullopt;
  }
  return heights_m;
}

Heights made_heights(const TerrainScene& terrain) {
  const terrain::FractalParameters& parameters = terrain.fractal;
  const std::string what = fmt::format("terrain.posts: {0} x {0} posts", parameters.posts);
  // The map, its copy on a device that keeps its memory in the machine's, and the node maxima over that.
  constexpr double bytes_a_post = (2.0 + 1.0 / 3.0) * sizeof(float);
  require_host_memory(bytes_a_post * parameters.posts * parameters.posts, what,
                      "use fewer, or make a file with `offing terrain generate` and tile it with "
                      "`offing terrain tile`");
  HeightMap map;
  map.columns = map.rows = parameters.posts;
  map.spacing_x_m = map.spacing_z_m = parameters.side_m / (parameters.posts - 1);
  const auto posts = static_cast<std::size_t>(parameters.posts);
  const bool is_kept = posts * posts >= least_kept_posts && posts * posts <= most_kept_posts;
  const ocl::DiskCache cache(is_kept ? ocl::DiskCache::default_folder() : "", made_maps);
  if (std::optional<std::vector<float>> heights_m = kept_heights(cache, parameters)) {
    map.heights_m = std::move(*heights_m);
    return {.map = std::make_shared<const HeightMap>(std::move(map))};
  }
  terrain::RowMakers makers(parameters);
  map.heights_m.reserve(posts * posts);
  const int rounds = (parameters.posts + makers.rows_at_once() - 1) / makers.rows_at_once();
  TimeEstimate estimate(rounds, what, "use fewer terrain.posts");
  for (int first = 0; first < parameters.posts; first += makers.rows_at_once()) {
    const std::span<const float> rows = makers.make(first);
    map.heights_m.insert(map.heights_m.end(), rows.begin(), rows.end());
    estimate.step_done();
  }
  if (!cache.is_on()) return {.map = std::make_shared<const HeightMap>(std::move(map))};
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(map.heights_m.data());
  cache.store(identity_of(parameters), {bytes, bytes + map.heights_m.size() * sizeof(float)});
  return {.map = std::make_shared<const HeightMap>(std::move(map))};
}

Heights read_heights(const Scene& scene) {
  const TerrainScene& terrain = scene.terrain;
  return read_named(scene, "terrain.file", "a height map", terrain.file, [&] {
    if (is_tile_store(terrain.file)) {
      const TileStore store(terrain.file, scene.trust);
      constexpr std::size_t mebibyte = 1 << 20;
      return Heights{.tiles = std::make_shared<const world::TerrainTiles>(world::TerrainTiles{
                         .map = tiled_map(store.header()),
                         .read = tile_reader(store),
                         .cache_bytes = mebibyte * static_cast<std::size_t>(terrain.cache_mb)}),
                     .latitude_deg = store.header().centre_latitude_deg};
    }
    HeightMapOptions reading = terrain.reading;
    reading.trust = trust_in(scene, terrain.file);
    HeightMapFile file = read_height_map(terrain.file, reading);
    warn_of_assumed_spacing(terrain.file, file.source);
    return Heights{.map = std::make_shared<const HeightMap>(std::move(file.map)),
                   .latitude_deg = file.source.centre_latitude_deg};
  });
}

/// Of the ground, placed on its heights.
ColourMap read_picture(const Scene& scene, const Heights& heights, const std::string& file) {
  return heights.map ? read_colour_map(file, *heights.map, trust_in(scene, file))
                     : read_colour_map(file, place_of(TileStore(scene.terrain.file, scene.trust).header()),
                                       trust_in(scene, file));
}

std::shared_ptr<const ColourMap> read_colours(const Scene& scene, const Heights& heights) {
  const std::string& file = scene.terrain.colour;
  if (file.empty()) return nullptr;
  return read_named(scene, "terrain.colour", "a picture of the ground", file,
                    [&] { return std::make_shared<const ColourMap>(read_picture(scene, heights, file)); });
}

/// The scene's lines, else those of the map's latitude. Below a sea nothing is painted as water.
world::CoverLines cover_of(const Scene& scene, std::optional<double> latitude_deg) {
  constexpr double deepest_m = -1e6;
  constexpr double beach_m = 2.0;  // as high as waves of a common sea run up
  world::CoverLines lines = latitude_deg ? world::cover_lines(*latitude_deg) : world::CoverLines{};
  if (scene.has_sea()) {
    lines.sea_level_m = deepest_m;
    lines.beach_line_m = scene.sea_level_m() + beach_m;
  } else {
    lines.sea_level_m = scene.terrain.water_line_m;
  }
  lines.tree_line_m = scene.terrain.tree_line_m.value_or(lines.tree_line_m);
  lines.snow_line_m = scene.terrain.snow_line_m.value_or(lines.snow_line_m);
  return lines;
}

/// Those of the scene's landscape, then its own.
std::vector<terrain::Material> materials_of(const Scene& scene, const world::CoverLines& lines) {
  std::vector<terrain::Material> materials =
      terrain::materials_of(scene.terrain.landscape, world::landscape_lines(lines));
  materials.insert(materials.end(), scene.terrain.materials.begin(), scene.terrain.materials.end());
  return materials;
}

/// Its woods; the map of their cover is kept of a scene with the same, `before`.
std::optional<terrain::Canopy> woods_of(const Scene& scene, const Heights& heights,
                                        const world::CoverLines& lines,
                                        const std::optional<world::TerrainParameters>& now,
                                        const Scene* before) {
  const CanopyScene& canopy = scene.terrain.canopy;
  const bool is_same_map =
      before != nullptr && before->terrain.canopy.map == canopy.map && now && now->canopy;
  std::shared_ptr<const ColourMap> map = is_same_map ? now->canopy->map : nullptr;
  if (!canopy.map.empty() && !map) {
    map = read_named(scene, "terrain.canopy.map", "a picture of the woods", canopy.map,
                     [&] { return terrain::cover_map(read_picture(scene, heights, canopy.map)); });
  }
  return terrain::wood_of(canopy.wood, std::move(map), lines.tree_line_m);
}

/// Where a scene says where a lake is.
std::string place_of_lake(const Scene& scene, std::size_t index) {
  for (const char* key : {"lake.level_m", "lake.x_m", "lake.z_m"}) {
    const auto place = scene.set_at.find(ValueKey(key, {index, 0}));
    if (place != scene.set_at.end()) return place->second;
  }
  return fmt::format("lake {}", index + 1);
}

/// The lakes of a scene on its ground. Those of `before` are filled already: they are `known`.
std::vector<world::LakeSettings> lakes_of(const Scene& scene, const world::TerrainParameters& terrain,
                                          std::span<const LakeScene> before,
                                          const std::vector<world::LakeSettings>& known, const Work& work) {
  std::vector<world::LakeSettings> lakes;
  const terrain::TerrainPosts posts = terrain.posts();
  for (std::size_t i = 0; i < scene.lakes.size(); ++i) {
    const LakeScene& each = scene.lakes[i];
    world::LakeSettings& lake = lakes.emplace_back();
    lake.wind = {.wind_speed_mps = each.wind_speed_mps, .wind_direction_rad = each.wind_direction_rad};
    lake.water = each.water;
    for (std::size_t j = 0; j < std::min(known.size(), before.size()); ++j) {
      if (are_filled_alike(before[j], each)) lake.lake = known[j].lake;
    }
    const std::string place = place_of_lake(scene, i);
    if (!lake.lake) {
      try {
        lake.lake = std::make_shared<const terrain::Lake>(terrain::fill_lake(
            posts, each.x_m - terrain.origin_x_m, each.z_m - terrain.origin_z_m, each.level_m, place, work));
      } catch (const Error& error) {
        if (error.kind() != ErrorKind::bad_input) throw;
        throw LakeError(error, {i});
      }
    }
    if (scene.has_sea() && lake.lake->level_m <= scene.sea_level_m()) {
      throw LakeError(Error(ErrorKind::bad_input,
                            fmt::format("{}: expected a level above the sea, {:.7g} m, found {:.7g} m", place,
                                        scene.sea_level_m(), lake.lake->level_m),
                            "choose a higher level, or a lower world.sea_level_m"),
                      {i});
    }
    for (std::size_t j = 0; j < i; ++j) {
      if (!terrain::overlap(*lakes[j].lake, *lake.lake)) continue;
      throw LakeError(Error(ErrorKind::bad_input,
                            fmt::format("{}: expected no other lake there, found lake {}", place, j + 1),
                            "remove one of them"),
                      {i, j});
    }
  }
  return lakes;
}

world::TerrainParameters placed(const Scene& scene, const Heights& heights,
                                std::shared_ptr<const ColourMap> colours, const Work& work,
                                const std::optional<world::TerrainParameters>& now = {},
                                const Scene* before = nullptr) {
  world::TerrainParameters terrain{
      .map = heights.map,
      .tiles = heights.tiles,
      .latitude_deg = heights.latitude_deg,
      .lines = cover_of(scene, heights.latitude_deg),
      .colours = std::move(colours),
      .relief = scene.terrain.relief,
      .finest_detail_m = scene.terrain.finest_detail_m,
      .sees_horizons = heights.map && scene.terrain.sky_visibility == SkyVisibility::on};
  terrain.materials = materials_of(scene, terrain.lines);
  terrain.canopy = woods_of(scene, heights, terrain.lines, now, before);
  const terrain::TerrainExtent extent = terrain.extent();
  terrain.origin_x_m = scene.terrain.origin_x_m.value_or(-0.5 * extent.width_m);
  terrain.origin_z_m = scene.terrain.origin_z_m.value_or(-0.5 * extent.depth_m);
  const bool is_same_place =
      now && now->origin_x_m == terrain.origin_x_m && now->origin_z_m == terrain.origin_z_m;
  const bool are_known = is_same_place && before != nullptr;
  terrain.lakes = lakes_of(scene, terrain, are_known ? before->lakes : std::span<const LakeScene>(),
                           now ? now->lakes : std::vector<world::LakeSettings>(), work);
  return terrain;
}

}  // namespace

std::vector<world::LakeSettings> prepare_lakes(const Scene& scene, const world::TerrainParameters& terrain,
                                               std::span<const LakeScene> before, const Work& work) {
  return lakes_of(scene, terrain, before, terrain.lakes, work);
}

bool are_filled_alike(const LakeScene& one, const LakeScene& other) {
  return one.x_m == other.x_m && one.z_m == other.z_m && one.level_m == other.level_m;
}

bool is_other_ground(const Scene& before, const Scene& after) {
  return before.terrain.is_given != after.terrain.is_given ||
         before.terrain.origin_x_m != after.terrain.origin_x_m ||
         before.terrain.origin_z_m != after.terrain.origin_z_m || differ_in(Affects::heights, before, after);
}

bool has_lakes_to_fill(const Scene& before, const Scene& after) {
  if (!after.terrain.is_given || after.lakes.empty()) return false;
  return is_other_ground(before, after) || std::ranges::any_of(after.lakes, [&](const LakeScene& lake) {
           return std::ranges::none_of(before.lakes,
                                       [&](const LakeScene& old) { return are_filled_alike(old, lake); });
         });
}

std::optional<world::TerrainParameters> prepare_terrain(const Scene& scene, const Work& work) {
  if (!scene.terrain.is_given) return std::nullopt;
  const Heights heights = scene.terrain.file.empty() ? made_heights(scene.terrain) : read_heights(scene);
  return placed(scene, heights, read_colours(scene, heights), work);
}

std::optional<world::TerrainParameters> edited_terrain(const std::optional<world::TerrainParameters>& now,
                                                       const Scene& before, const Scene& after) {
  const bool are_other_heights = !now || differ_in(Affects::heights, before, after);
  if (!after.terrain.is_given || are_other_heights) return prepare_terrain(after);
  const Heights heights{.map = now->map, .tiles = now->tiles, .latitude_deg = now->latitude_deg};
  const bool are_same_colours = before.terrain.colour == after.terrain.colour;
  return placed(after, heights, are_same_colours ? now->colours : read_colours(after, heights), {}, now,
                &before);
}

void stand_on_ground(const world::WorldTerrain& terrain, ViewScene& view) {
  glm::dvec3& eye_m = view.camera.eye_m;
  const std::optional<double> below_m = terrain.surface_m(eye_m.x, eye_m.z);
  if (!below_m) return;
  if (view.mode == CameraMode::walk) {
    // On the ground as it is drawn, which may be below that of the map.
    eye_m.y = *below_m + terrain.relief_m(eye_m.x, eye_m.z) + view.walker.eye_height_m;
  } else {
    terrain::lift_out_of_terrain(eye_m, *below_m, view.walker.eye_height_m);
  }
}

std::optional<std::string> eye_warning(const world::WorldTerrain& terrain, ViewScene view, bool has_sea) {
  glm::dvec3& eye_m = view.camera.eye_m;
  const world::TerrainParameters& parameters = terrain.parameters();
  const std::optional<double> below = terrain.surface_m(eye_m.x, eye_m.z);
  if (below && view.mode != CameraMode::walk) {
    return terrain::lift_out_of_terrain(eye_m, *below, view.walker.eye_height_m);
  }
  if (below || has_sea) return std::nullopt;
  return terrain::warning_off_map(eye_m, parameters.extent(), parameters.origin_x_m, parameters.origin_z_m);
}

bool places_its_camera(const Scene& scene) {
  constexpr std::array keys{"camera.x_m", "camera.y_m", "camera.z_m", "camera.yaw_deg", "camera.pitch_deg"};
  return std::any_of(keys.begin(), keys.end(), [&](const char* key) { return scene.set_at.contains(key); });
}

void place_camera(Scene& scene, const std::optional<world::TerrainParameters>& terrain) {
  if (!terrain || places_its_camera(scene)) return;
  Camera& camera = scene.view.camera;
  const Camera placed = terrain::flying_camera(terrain->extent());
  camera.eye_m = placed.eye_m + glm::dvec3(terrain->origin_x_m, 0.0, terrain->origin_z_m);
  camera.yaw_rad = placed.yaw_rad;
  camera.pitch_rad = placed.pitch_rad;
}

}  // namespace offing::scene

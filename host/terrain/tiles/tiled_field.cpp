#include "host/terrain/tiles/tiled_field.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/ocl/program.h"
#include "host/terrain/cast/fine_cast.h"
#include "host/terrain/cast/image_rays.h"
#include "host/terrain/tiles/page_table.h"
#include "host/terrain/tiles/tile_cache.h"
#include "kernels/shared/terrain_tiles.h"

namespace offing::terrain {
namespace {

// Of the slots, those that the cut may take: the others keep tiles that were used a moment ago or will be.
constexpr double cut_share = 0.75;
// A ray from outside begins where a level has about this many nodes.
constexpr int levels_below_top = 3;
// By how much finer a tile is taken where a ray hits a coarse one: a ray that passes high above the ground
// asks for few tiles, one that hits it for two.
constexpr int levels_a_try = 4;

PostGrid grid_of(const TiledMap& map) {
  return {.columns = map.shape.columns,
          .rows = map.shape.rows,
          .spacing_x_m = map.spacing_x_m,
          .spacing_z_m = map.spacing_z_m,
          .origin_x_m = map.origin_x_m,
          .origin_z_m = map.origin_z_m};
}

CutView view_of(const TiledMap& map, const Camera& camera) {
  const glm::dvec2 extent = half_extent(camera);
  return {.eye_x_m = camera.eye_m.x,
          .eye_z_m = camera.eye_m.z,
          .above_m = std::max(0.0, camera.eye_m.y - map.highest_m),
          .pixel_rad = 2.0 * extent.y / camera.height_px};
}

}  // namespace

ocl::Defines tiles_defines(int lanes, MapEdge edge) {
  const int map_edge = edge == MapEdge::repeats   ? TERRAIN_EDGE_REPEATS
                       : edge == MapEdge::mirrors ? TERRAIN_EDGE_MIRRORS
                                                  : TERRAIN_EDGE_ENDS;
  return ocl::Defines()
      .set("LANES", lanes)
      .set("UP_RULE", TERRAIN_UP_WITH_PARENT)
      .set_flag("TILED")
      .set("MAP_EDGE", map_edge);
}

struct TiledField::State {
  ocl::Device device;
  TiledMap map;
  PostGrid grid;
  ocl::KernelTuning tuning;
  TileCache cache;
  PageTable table;
  ocl::Buffer<float> pages;
  Statistics statistics;
  std::optional<glm::dvec3> last_eye_m;
  std::optional<ocl::Kernel> distance_kernel, image_kernel, relief_kernel, ray_kernel, curved_kernel;
  HostRays host_rays;

  State(const ocl::Device& on, const TiledMap& of, TileReader read, std::size_t cache_bytes)
      : device(on),
        map(of),
        grid(grid_of(of)),
        tuning(ray_tuning(on)),
        cache(on, of, read, cache_bytes),
        table(of.shape),
        pages(on, table.pages().size(), "terrain pages") {}

  std::vector<TileKey> cut(const CutView& view) const {
    return choose_cut(map, view,
                      static_cast<std::size_t>(cut_share * static_cast<double>(cache.slot_count())));
  }

  /// The tile itself, or the nearest that is there of those that cover it.
  std::pair<TileKey, int> resident(TileKey key) {
    while (true) {
      if (const auto slot = cache.use(key)) return {key, *slot};
      key = parent_of(key);
    }
  }

  void lay(const std::vector<TileKey>& keys) {
    statistics.tiles = keys.size();
    statistics.stood_in = 0;
    for (const TileKey& key : keys) {
      const auto [there, slot] = resident(key);
      statistics.stood_in += there == key ? 0 : 1;
      table.lay(key, there, slot, cache.square_maxima_m(slot));
    }
    table.reduce_maxima();
    pages.write(table.pages());
    cache.write_head(table.maxima_m());
    statistics.loaded = cache.loaded();
    statistics.failed = cache.failed();
    statistics.slots = cache.slot_count();
    statistics.bytes = cache.bytes() + pages.size() * sizeof(float);
  }

  /// The finer tile that a hit asks for, unless it is on one of level 0.
  std::optional<TileKey> finer_tile(const RayHit& hit) const {
    if (hit.kind == TERRAIN_MISS) return std::nullopt;
    const int column = hit.cell_x / tile_cells, row = hit.cell_z / tile_cells;
    const int level = table.level_at(column, row);
    if (level == 0) return std::nullopt;
    const int finer = std::max(0, level - levels_a_try);
    return TileKey{finer, column >> finer, row >> finer};
  }

  /// Waits for these tiles, and lays them over the coarsest.
  void lay_fine(std::vector<TileKey> keys) {
    do {
      cache.begin_frame();
      for (const TileKey& key : keys) cache.use(key);
    } while (cache.want(keys) > 0 && cache.wait_and_take_in(Unreadable::refused));
    const int coarsest = map.shape.coarsest();
    for (int row = 0; row < map.shape.tiles_z(coarsest); ++row) {
      for (int column = 0; column < map.shape.tiles_x(coarsest); ++column)
        keys.push_back({coarsest, column, row});
    }
    // Coarse ones first: finer ones lie over them.
    std::sort(keys.begin(), keys.end(), std::greater<>());
    lay(keys);
  }

  /// What the camera wants where it will be.
  void add_ahead(std::vector<TileKey>& keys, const Camera& camera, double ahead_m) const {
    if (ahead_m <= 0.0 || !last_eye_m) return;
    const glm::dvec3 way = camera.eye_m - *last_eye_m;
    if (glm::length(way) == 0.0) return;
    Camera later = camera;
    later.eye_m += glm::normalize(way) * ahead_m;
    for (const TileKey& key : cut(view_of(map, later))) {
      if (keys.size() + 2 >= cache.slot_count()) break;
      if (std::find(keys.begin(), keys.end(), key) == keys.end()) keys.push_back(key);
    }
  }

  void look(const Camera& camera, double ahead_m) {
    require_valid(camera);
    cache.begin_frame();
    const std::vector<TileKey> keys = cut(view_of(map, camera));
    // Before any make room for others.
    for (const TileKey& key : keys) resident(key);
    cache.take_in();
    std::vector<TileKey> wanted = keys;
    add_ahead(wanted, camera, ahead_m);
    cache.want(wanted);
    last_eye_m = camera.eye_m;
    lay(keys);
  }

  void look_and_wait(const Camera& camera) {
    require_valid(camera);
    const std::vector<TileKey> keys = cut(view_of(map, camera));
    do {
      cache.begin_frame();
      for (const TileKey& key : keys) resident(key);
    } while (cache.want(keys) > 0 && cache.wait_and_take_in());
    last_eye_m = camera.eye_m;
    lay(keys);
  }

  TerrainField field() const {
    const PagesShape& shape = table.shape();
    return {.columns = grid.columns,
            .cells_x = grid.columns - 1,
            .cells_z = grid.rows - 1,
            .padded_x = shape.columns << TERRAIN_TILE_LOG2,
            .padded_z = shape.rows << TERRAIN_TILE_LOG2,
            .top_level = shape.top_level,
            .first_level = std::max(1, shape.top_level - levels_below_top),
            .starts_at_origin = 1,
            .highest_m = map.highest_m,
            .largest_m = std::max(std::abs(map.lowest_m), std::abs(map.highest_m)),
            .cells_per_m_x = static_cast<float>(1.0 / grid.spacing_x_m),
            .cells_per_m_z = static_cast<float>(1.0 / grid.spacing_z_m)};
  }

  ocl::Defines defines() const { return tiles_defines(tuning.lanes, map.edge); }

  /// A place brought to the copy of the map that kernels begin in.
  glm::dvec3 near_place(glm::dvec3 place_m) const {
    if (map.edge == MapEdge::ends) return place_m;
    const double copies = map.edge == MapEdge::mirrors ? 2.0 : 1.0;
    const auto bring = [](double at, double period) { return at - std::floor(at / period) * period; };
    return {map.origin_x_m + bring(place_m.x - map.origin_x_m, copies * map.width_m()), place_m.y,
            map.origin_z_m + bring(place_m.z - map.origin_z_m, copies * map.depth_m())};
  }

  TerrainView device_view(Camera camera) const {
    require_valid(camera);
    camera.eye_m = near_place(camera.eye_m);
    return terrain::device_view(camera, grid);
  }

  void require_look() const {
    if (statistics.tiles > 0) return;
    throw Error(ErrorKind::bad_usage, "tiled field: expected tiles to be chosen before rays are cast",
                "call look() first");
  }

  /// As kernels begin it: maps that go on have no box.
  RayToBox near_ray(Ray ray, double bend_perm) const {
    ray.origin_m = near_place(ray.origin_m);
    require_valid(ray, grid);
    return map.edge == MapEdge::ends ? moved_to_box(ray, grid, map.highest_m, bend_perm) : RayToBox{ray};
  }

  /// `bends` are what the kernel takes with IS_CURVED.
  template <class... Bends>
  std::vector<RayHit> cast_rays(std::optional<ocl::Kernel>& kernel, const ocl::Defines& definitions,
                                std::span<const Ray> rays, double bend_perm, Bends... bends) {
    if (rays.empty()) return {};
    std::vector<RayToBox> near;
    near.reserve(rays.size());
    for (const Ray& ray : rays) near.push_back(near_ray(ray, bend_perm));
    if (!kernel) kernel = ocl::Program::build(device, "terrain/ray_cast.cl", definitions).kernel("ray_cast");
    const auto cast = [&](const ocl::Buffer<TerrainRay>& some, std::size_t count,
                          ocl::Buffer<TerrainHit>& hits) {
      kernel->launch(ocl::launch_shape(tuning, count), cache.pool(), pages, field(), some,
                     static_cast<int>(count), hits, bends...);
    };
    return host_rays.cast(device, grid, near, cast);
  }

  /// `relief` is what the kernel takes with RELIEF.
  template <class Record, class... Relief>
  void cast_image(std::optional<ocl::Kernel>& kernel, const ocl::Defines& definitions, const Camera& camera,
                  ocl::Buffer<Record>& records, const Relief&... relief) {
    require_look();
    const TerrainView view = device_view(camera);
    require_room("picture", pixel_count(camera), records.size());
    if (!kernel) {
      kernel = ocl::Program::build(device, "terrain/quadtree_cast.cl", definitions).kernel("quadtree_cast");
    }
    kernel->launch(image_shape(camera, tuning), cache.pool(), pages, field(), view, records, relief...);
  }
};

TiledField::TiledField(const ocl::Device& device, const TiledMap& map, TileReader read,
                       std::size_t cache_bytes)
    : state_(std::make_unique<State>(device, map, std::move(read), cache_bytes)) {}
TiledField::TiledField(TiledField&&) noexcept = default;
TiledField& TiledField::operator=(TiledField&&) noexcept = default;
TiledField::~TiledField() = default;

const TiledMap& TiledField::map() const {
  return state_->map;
}
const PostGrid& TiledField::grid() const {
  return state_->grid;
}
const ocl::Buffer<float>& TiledField::pool() const {
  return state_->cache.pool();
}
const ocl::Buffer<float>& TiledField::pages() const {
  state_->require_look();
  return state_->pages;
}
const TiledField::Statistics& TiledField::statistics() const {
  return state_->statistics;
}
TerrainField TiledField::device_field() const {
  return state_->field();
}
TerrainView TiledField::device_view(const Camera& camera) const {
  return state_->device_view(camera);
}

void TiledField::look(const Camera& camera, double ahead_m) {
  state_->look(camera, ahead_m);
}

void TiledField::look_and_wait(const Camera& camera) {
  state_->look_and_wait(camera);
}

void TiledField::cast(const Camera& camera, ocl::Buffer<float>& distances_m) {
  state_->cast_image(state_->distance_kernel, state_->defines(), camera, distances_m);
}

void TiledField::cast(const Camera& camera, ocl::Buffer<TerrainHit>& hits) {
  state_->cast_image(state_->image_kernel, state_->defines().set_flag("WRITES_HITS"), camera, hits);
}

void TiledField::cast(const Camera& camera, const ReliefSurface& relief, ocl::Buffer<TerrainHit>& hits) {
  if (!relief.is_laid()) return cast(camera, hits);
  state_->cast_image(state_->relief_kernel, state_->defines().set_flag("WRITES_HITS").set_flag("RELIEF"),
                     camera, hits, relief.params(), relief.heights_m(), relief.maxima_m());
}

std::vector<RayHit> TiledField::cast(std::span<const Ray> rays) {
  state_->require_look();
  return state_->cast_rays(state_->ray_kernel, state_->defines(), rays, 0.0);
}

std::vector<RayHit> TiledField::cast_fully(std::span<const Ray> rays, const EarthCurve& curve) {
  require_valid(curve);
  if (map().edge != MapEdge::ends) {
    throw Error(ErrorKind::bad_usage, "tiled field: expected a map that ends, found one that goes on",
                "ask the map itself");
  }
  const auto bend_m = [&](double spacing_m) {
    return static_cast<float>(curve.bend_perm() * spacing_m * spacing_m);
  };
  const bool is_flat = curve.bend_perm() == 0.0;
  const auto cast = [&](std::span<const Ray> some) {
    if (is_flat) return state_->cast_rays(state_->ray_kernel, state_->defines(), some, 0.0);
    return state_->cast_rays(state_->curved_kernel, state_->defines().set_flag("IS_CURVED"), some,
                             curve.bend_perm(), bend_m(map().spacing_x_m), bend_m(map().spacing_z_m));
  };
  return cast_until_fine(rays, {.most_tiles = state_->cache.slot_count() - state_->cache.coarsest_count(),
                                .lay = [&](const std::vector<TileKey>& keys) { state_->lay_fine(keys); },
                                .finer_tile = [&](const RayHit& hit) { return state_->finer_tile(hit); },
                                .cast = cast});
}

float TiledField::coarse_height_m(double x_m, double z_m) const {
  const TiledMap& map = state_->map;
  const int level = map.shape.coarsest();
  const auto post_of = [&](double place_m, double spacing_m, int cells) {
    return std::clamp(static_cast<int>(std::lround(std::ldexp(place_m / spacing_m, -level))), 0, cells - 1);
  };
  const int x = post_of(x_m - map.origin_x_m, map.spacing_x_m, map.shape.cells_x(level)),
            z = post_of(z_m - map.origin_z_m, map.spacing_z_m, map.shape.cells_z(level));
  const std::vector<float>& heights_m = state_->cache.coarsest_m(x / tile_cells, z / tile_cells);
  return heights_m[static_cast<std::size_t>(z % tile_cells * tile_posts + x % tile_cells)];
}

}  // namespace offing::terrain

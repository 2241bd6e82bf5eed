#include "host/terrain/tiles/tile_posts.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <utility>

#include "host/base/error.h"

namespace offing::terrain {
namespace {

constexpr std::size_t most_tiles = 64;

/// Bilinear between values [side][side] at a place in their cells, which is held to them.
float between(const std::vector<float>& values, int side, double x, double z) {
  const int column = std::clamp(static_cast<int>(x), 0, side - 2),
            row = std::clamp(static_cast<int>(z), 0, side - 2);
  const double u = std::clamp(x - column, 0.0, 1.0), v = std::clamp(z - row, 0.0, 1.0);
  const auto at = [&](int right, int down) {
    return static_cast<double>(values[static_cast<std::size_t>((row + down) * side + column + right)]);
  };
  const double north = std::lerp(at(0, 0), at(1, 0), u), south = std::lerp(at(0, 1), at(1, 1), u);
  return static_cast<float>(std::lerp(north, south, v));
}

}  // namespace

TilePosts::TilePosts(const TiledMap& map, TileReader read, Unreadable unreadable)
    : map_(map), read_(std::move(read)), unreadable_(unreadable) {}

HeightTile TilePosts::read_or_stand_in(TileKey key) const {
  while (true) {
    try {
      return read_(key);
    } catch (const Error&) {
      if (unreadable_ == Unreadable::refused || key.level == map_.shape.coarsest()) throw;
    }
    key = parent_of(key);
  }
}

const HeightTile& TilePosts::tile_around(int column, int row) {
  const TileKey key{0, std::min(column / tile_cells, map_.shape.tiles_x(0) - 1),
                    std::min(row / tile_cells, map_.shape.tiles_z(0) - 1)};
  const auto found =
      std::find_if(kept_.begin(), kept_.end(), [&](const Kept& kept) { return kept.wanted == key; });
  if (found != kept_.end()) {
    kept_.splice(kept_.begin(), kept_, found);
  } else {
    kept_.push_front({key, read_or_stand_in(key)});
    if (kept_.size() > most_tiles) kept_.pop_back();
  }
  return kept_.front().tile;
}

float TilePosts::height_m(int column, int row) {
  const HeightTile& tile = tile_around(column, row);
  if (tile.key.level == 0) {
    const int x = column - tile.key.column * tile_cells, z = row - tile.key.row * tile_cells;
    return tile.highest_m[static_cast<std::size_t>(z * tile_posts + x)];
  }
  const auto in_tile = [&](int post, int first_tile) {
    return std::ldexp(post, -tile.key.level) - first_tile * tile_cells;
  };
  return between(tile.highest_m, tile_posts, in_tile(column, tile.key.column), in_tile(row, tile.key.row));
}

bool TilePosts::is_void(int column, int row) {
  const HeightTile& tile = tile_around(column, row);
  if (tile.key.level > 0 || tile.is_void.empty()) return false;
  const int x = column - tile.key.column * tile_cells, z = row - tile.key.row * tile_cells;
  return tile.is_void[static_cast<std::size_t>(z * tile_posts + x)] != 0;
}

TerrainPosts posts_of(const TiledMap& map, TileReader read, Unreadable unreadable) {
  const auto posts = std::make_shared<TilePosts>(map, std::move(read), unreadable);
  return {.columns = map.shape.columns,
          .rows = map.shape.rows,
          .spacing_x_m = map.spacing_x_m,
          .spacing_z_m = map.spacing_z_m,
          .height_m = [posts](int column, int row) { return posts->height_m(column, row); },
          .is_void = [posts](int column, int row) { return posts->is_void(column, row); }};
}

HeightMap overview_of(const TiledMap& map, const TileReader& read) {
  const TileSetShape& shape = map.shape;
  const int level = shape.coarsest();
  HeightMap overview;
  overview.columns = shape.cells_x(level) + 1;
  overview.rows = shape.cells_z(level) + 1;
  // The last cells of a level reach beyond the map.
  const double step_x = std::ldexp(shape.columns - 1.0, -level) / (overview.columns - 1),
               step_z = std::ldexp(shape.rows - 1.0, -level) / (overview.rows - 1);
  overview.spacing_x_m = map.width_m() / (overview.columns - 1);
  overview.spacing_z_m = map.depth_m() / (overview.rows - 1);
  overview.heights_m.resize(static_cast<std::size_t>(overview.columns) *
                            static_cast<std::size_t>(overview.rows));
  for (int tile_row = 0; tile_row < shape.tiles_z(level); ++tile_row) {
    for (int tile_column = 0; tile_column < shape.tiles_x(level); ++tile_column) {
      const HeightTile tile = read({level, tile_column, tile_row});
      const int first_column = tile_column * tile_cells, first_row = tile_row * tile_cells;
      for (int row = first_row; row < std::min(first_row + tile_posts, overview.rows); ++row) {
        for (int column = first_column; column < std::min(first_column + tile_posts, overview.columns);
             ++column) {
          // Means have a ring of posts around.
          const double x = column * step_x - first_column + 1.0, z = row * step_z - first_row + 1.0;
          overview.heights_m[overview.index(column, row)] = between(tile.means_m, ringed_tile_posts, x, z);
        }
      }
    }
  }
  return overview;
}

}  // namespace offing::terrain

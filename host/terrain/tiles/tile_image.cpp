#include "host/terrain/tiles/tile_image.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>

#include "kernels/shared/terrain_tiles.h"

namespace offing::terrain {
namespace {

static_assert(TERRAIN_TILE_CELLS == tile_cells && TERRAIN_TILE_POSTS == tile_posts);

using Grid = std::vector<float>;

Grid patch_maxima(const Grid& posts) {
  Grid maxima;
  maxima.reserve(tile_cells * tile_cells);
  for (int row = 0; row < tile_cells; ++row) {
    const float* north = posts.data() + row * tile_posts;
    const float* south = north + tile_posts;
    for (int i = 0; i < tile_cells; ++i) {
      maxima.push_back(std::max(std::max(north[i], north[i + 1]), std::max(south[i], south[i + 1])));
    }
  }
  return maxima;
}

/// Of 2 x 2 nodes the highest.
Grid reduced(const Grid& maxima, int side) {
  Grid higher;
  higher.reserve(static_cast<std::size_t>(side / 2) * static_cast<std::size_t>(side / 2));
  for (int row = 0; row < side; row += 2) {
    const float* north = maxima.data() + row * side;
    const float* south = north + side;
    for (int i = 0; i < side; i += 2) {
      higher.push_back(std::max(std::max(north[i], north[i + 1]), std::max(south[i], south[i + 1])));
    }
  }
  return higher;
}

std::uint32_t slope_steps(float rise_m, double run_m) {
  const double steps = std::clamp(std::nearbyint(rise_m / run_m * TERRAIN_SLOPE_STEPS), -32768.0, 32767.0);
  return static_cast<std::uint16_t>(static_cast<std::int16_t>(steps));
}

/// Central differences of the means around each post.
void append_slopes(Grid& words, const HeightTile& tile, double spacing_x_m, double spacing_z_m) {
  const double run_x_m = std::ldexp(2.0 * spacing_x_m, tile.key.level),
               run_z_m = std::ldexp(2.0 * spacing_z_m, tile.key.level);
  for (int row = 1; row <= tile_posts; ++row) {
    const float* here = tile.means_m.data() + row * ringed_tile_posts;
    for (int i = 1; i <= tile_posts; ++i) {
      const std::uint32_t x = slope_steps(here[i + 1] - here[i - 1], run_x_m);
      const std::uint32_t z = slope_steps(here[i + ringed_tile_posts] - here[i - ringed_tile_posts], run_z_m);
      words.push_back(std::bit_cast<float>(x | z << 16));
    }
  }
}

}  // namespace

TileImage tile_image(const HeightTile& tile, double spacing_x_m, double spacing_z_m) {
  TileImage image{tile.key, {}, {}, tile.highest_m};
  image.words.reserve(TERRAIN_SLOT_FLOATS);
  image.words = tile.highest_m;
  Grid maxima = patch_maxima(tile.highest_m);
  for (int level = 0, side = tile_cells; side >= 1; ++level, side /= 2) {
    if (level > 0) maxima = reduced(maxima, 2 * side);
    if (level == TERRAIN_TILE_LOG2 - tile.key.level) image.square_maxima_m = maxima;
    if (level >= 1 && level < TERRAIN_TILE_LOG2)
      image.words.insert(image.words.end(), maxima.begin(), maxima.end());
  }
  append_slopes(image.words, tile, spacing_x_m, spacing_z_m);
  return image;
}

}  // namespace offing::terrain

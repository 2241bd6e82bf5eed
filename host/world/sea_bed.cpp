#include "host/world/sea_bed.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/terrain/tiles/tile_posts.h"
#include "kernels/shared/shoal_params.h"

namespace offing::world {
namespace {

constexpr int most_cells = 1024;

int stride_of(int posts) {
  return (posts - 2) / most_cells + 1;
}

/// Posts along a side of the coarser map: the last stands at the last post of the map or beyond it.
int kept_posts(int posts, int stride) {
  return (posts - 2) / stride + 2;
}

/// The highest of the posts nearer to this one of the coarser map than its neighbours are.
float highest_around_m(const HeightMap& map, int column, int row, int stride_x, int stride_z) {
  const auto first = [](int post, int stride) { return std::max(post - stride + 1, 0); };
  const auto last = [](int post, int stride, int posts) { return std::min(post + stride - 1, posts - 1); };
  float highest_m = -std::numeric_limits<float>::infinity();
  for (int z = first(row, stride_z); z <= last(row, stride_z, map.rows); ++z) {
    for (int x = first(column, stride_x); x <= last(column, stride_x, map.columns); ++x) {
      highest_m = std::max(highest_m, map.heights_m[map.index(x, z)]);
    }
  }
  return highest_m;
}

ocean::DepthMap bed_of(const HeightMap& map, double origin_x_m, double origin_z_m, double sea_level_m) {
  const int stride_x = stride_of(map.columns), stride_z = stride_of(map.rows);
  ocean::DepthMap bed{.columns = kept_posts(map.columns, stride_x),
                      .rows = kept_posts(map.rows, stride_z),
                      .origin_x_m = origin_x_m,
                      .origin_z_m = origin_z_m,
                      .spacing_x_m = stride_x * map.spacing_x_m,
                      .spacing_z_m = stride_z * map.spacing_z_m,
                      .depths_m = {}};
  const auto driest_m = static_cast<float>(-SHOAL_STEEPEST * std::min(bed.spacing_x_m, bed.spacing_z_m));
  for (int row = 0; row < bed.rows; ++row) {
    for (int column = 0; column < bed.columns; ++column) {
      const float highest_m = highest_around_m(map, column * stride_x, row * stride_z, stride_x, stride_z);
      bed.depths_m.push_back(std::max(static_cast<float>(sea_level_m - highest_m), driest_m));
    }
  }
  ocean::limit_slopes(bed);
  return bed;
}

}  // namespace

ocean::DepthMap sea_bed(const TerrainParameters& terrain, double sea_level_m) {
  if (terrain.map) return bed_of(*terrain.map, terrain.origin_x_m, terrain.origin_z_m, sea_level_m);
  const HeightMap overview = terrain::overview_of(terrain.tiles->map, terrain.tiles->read);
  return bed_of(overview, terrain.origin_x_m, terrain.origin_z_m, sea_level_m);
}

double beach_slope(const ocean::DepthMap& bed) {
  double sum = 0.0;
  std::size_t count = 0;
  for (int row = 0; row + 1 < bed.rows; ++row) {
    for (int column = 0; column + 1 < bed.columns; ++column) {
      const auto first = static_cast<std::size_t>(row) * static_cast<std::size_t>(bed.columns) +
                         static_cast<std::size_t>(column);
      const auto depth_m = [&](std::size_t post) { return static_cast<double>(bed.depths_m[first + post]); };
      const auto below = static_cast<std::size_t>(bed.columns);
      const double d00 = depth_m(0), d10 = depth_m(1), d01 = depth_m(below), d11 = depth_m(below + 1);
      // The waterline may run along posts: then the cells on land count.
      if (std::min({d00, d10, d01, d11}) >= 0.0 || std::max({d00, d10, d01, d11}) < 0.0) continue;
      sum += 0.5 *
             std::hypot((d10 - d00 + d11 - d01) / bed.spacing_x_m, (d01 - d00 + d11 - d10) / bed.spacing_z_m);
      ++count;
    }
  }
  return count > 0 ? sum / static_cast<double>(count) : 0.0;
}

}  // namespace offing::world

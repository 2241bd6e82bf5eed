#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "host/terrain/cast/ray.h"
#include "host/terrain/field/post_grid.h"
#include "host/terrain/field/terrain_posts.h"

namespace offing::test {

/// A height map in host memory: heights_m [rows][columns].
struct HeightMap {
  std::string name;
  terrain::PostGrid grid;
  std::vector<float> heights_m;

  float at(int column, int row) const {
    return heights_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                     static_cast<std::size_t>(column)];
  }
};

/// Maps of every kind that a walk could stumble over, of sizes that are no powers of two: random, flat,
/// spiky, ramp, checkerboard, valleys.
std::vector<HeightMap> example_maps();

/// A square of so many posts a side, spaced alike; heights at metres from the first post.
HeightMap square_map(int posts_a_side, double spacing_m,
                     const std::function<double(double x_m, double z_m)>& height_m);

/// The posts of a map, which has to outlive them.
terrain::TerrainPosts posts_of(const HeightMap& map);

/// Heights from rolling hills, of any size.
HeightMap valleys(const terrain::PostGrid& grid);

/// `count` rays over a map, fixed by the seed: from inside, above and beside its box, from its faces, edges
/// and posts, in all directions, among them vertical, level, along the axes and along the diagonals.
std::vector<terrain::Ray> example_rays(const HeightMap& map, std::size_t count, std::uint32_t seed);

}  // namespace offing::test

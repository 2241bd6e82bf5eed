#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <glm/vec2.hpp>

#include "host/base/work.h"
#include "host/terrain/field/terrain_posts.h"

namespace offing::terrain {

/// Still water in a basin of the ground: it covers all ground below its level that is connected to a place.
/// The ground is the surface of bilinear patches that rays hit.
struct Lake {
  double level_m = 0.0;
  double spill_level_m = 0.0;  ///< above this level water runs off the map
  glm::dvec2 spill_m{};        ///< where it does, (x, z) from the first post
  /// A box of posts, with dry ones on all sides.
  int first_column = 0, first_row = 0, columns = 0, rows = 0;
  std::vector<std::uint8_t> is_wet = {};  ///< [rows][columns]: posts in the lake
  double area_m2 = 0.0;                   ///< of the surface
  double volume_m3 = 0.0;
  double greatest_depth_m = 0.0;

  bool is_wet_at(int column, int row) const;
  /// Whether the post or one beside it is in the lake.
  bool is_near(int column, int row) const;
};

/// Posts of a basin, which take up to some tens of bytes of memory each while it is flooded.
inline constexpr std::size_t most_basin_posts = 1 << 26;

/// The lake at (x_m, z_m) from the map's first post. Without a level it is full, up to its spill level.
/// Throws Error(bad_input), whose message begins with `name`, for a place off the map, for dry ground, for a
/// place whose water runs off the map, for a level above the spill level, and for basins of more posts;
/// and what the work's poll() throws.
Lake fill_lake(const TerrainPosts& posts, double x_m, double z_m, std::optional<double> level_m,
               std::string_view name = "lake", const Work& work = {},
               std::size_t most_posts = most_basin_posts);

/// How near the ground at (x_m, z_m) is to a lake's water: 1 in cells with water, 0 a cell farther; linear.
double nearness_to_lake(const Lake& lake, const TerrainPosts& posts, double x_m, double z_m);

/// The depth of a lake's water at (x_m, z_m); 0 outside.
double depth_of_lake(const Lake& lake, const TerrainPosts& posts, double x_m, double z_m);

/// The shore as closed rings of places (x, z) m from the first post, each first place again at the end. The
/// first ring is the outer one, with the water on its left as seen from above; then islands, with the water
/// on their left too. Places lie on the sides of cells, where they are exact.
std::vector<std::vector<glm::dvec2>> outline_of(const Lake& lake, const TerrainPosts& posts);

/// Whether two lakes share water.
bool overlap(const Lake& a, const Lake& b);

}  // namespace offing::terrain

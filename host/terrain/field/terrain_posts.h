#pragma once

#include <functional>
#include <memory>
#include <optional>

#include <glm/vec3.hpp>

#include "host/base/height_map.h"

namespace offing::terrain {

/// The posts of a map, wherever they are kept; the first is at x = z = 0. Columns and rows that are asked for
/// are within the map.
struct TerrainPosts {
  int columns = 0, rows = 0;  ///< at least 2
  double spacing_x_m = 1.0, spacing_z_m = 1.0;
  std::function<float(int column, int row)> height_m;
  std::function<bool(int column, int row)> is_void;  ///< whether nothing was measured there

  double width_m() const { return spacing_x_m * (columns - 1); }
  double depth_m() const { return spacing_z_m * (rows - 1); }
};

/// Those of a map, which must live as long, or is kept.
TerrainPosts posts_of(const HeightMap& map);
TerrainPosts posts_of(const std::shared_ptr<const HeightMap>& map);

/// The ground above or below a point of the plan.
struct TerrainPoint {
  double height_m = 0.0;
  glm::dvec3 normal{0.0, 1.0, 0.0};  ///< unit, of the point's own patch
};

/// The surface of bilinear patches at (x_m, z_m) from the map's first post, in double precision; nothing
/// beyond the map's edge. The same surface that rays hit.
std::optional<TerrainPoint> terrain_at(const TerrainPosts& posts, double x_m, double z_m);
std::optional<TerrainPoint> terrain_at(const HeightMap& map, double x_m, double z_m);

/// The unit normal at (x_m, z_m) that goes on smoothly from patch to patch, as HitNormals::smooth has it;
/// nothing beyond the map's edge.
std::optional<glm::dvec3> smooth_normal_at(const TerrainPosts& posts, double x_m, double z_m);
std::optional<glm::dvec3> smooth_normal_at(const HeightMap& map, double x_m, double z_m);

/// Whether the ground at (x_m, z_m) was measured: none of the posts that its height is made of was filled in.
/// Nothing beyond the map's edge.
std::optional<bool> is_measured_at(const TerrainPosts& posts, double x_m, double z_m);

}  // namespace offing::terrain

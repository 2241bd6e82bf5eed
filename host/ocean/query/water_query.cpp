#include "host/ocean/query/water_query.h"

#include <algorithm>

#include "host/ocean/ocean_limits.h"

namespace offing::ocean {

SurfaceQueryPoint device_point(const WaterPoint& point) {
  // The usual case costs no call; a place that is not a number is not within anything.
  if (!(std::abs(point.x_m) <= farthest_point_m && std::abs(point.z_m) <= farthest_point_m)) {
    require_within("point.x_m", point.x_m, -farthest_point_m, farthest_point_m);
    require_within("point.z_m", point.z_m, -farthest_point_m, farthest_point_m);
  }
  constexpr double tile_m = SURFACE_QUERY_TILE_M;
  const double tile_x = std::nearbyint(point.x_m / tile_m), tile_z = std::nearbyint(point.z_m / tile_m);
  return {.tile_x = static_cast<int>(tile_x),
          .tile_z = static_cast<int>(tile_z),
          .x_m = static_cast<float>(point.x_m - tile_x * tile_m),
          .z_m = static_cast<float>(point.z_m - tile_z * tile_m)};
}

void require_valid_query(const WaterQuery& query, double water_depth_m) {
  require_within("query.depth_m", query.depth_m, 0.0, std::min(deepest_m, water_depth_m));
  require_within("query.min_wavelength_m", query.min_wavelength_m, 0.0, longest_filter_m);
  require_within("query.density_kgpm3", query.density_kgpm3, 1.0, 1e5);
  require_within("query.tolerance_m", query.tolerance_m, 1e-5, 1.0);
}

}  // namespace offing::ocean

#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "host/base/camera.h"
#include "host/world/world.h"
#include "present/passes/water/water_surface.h"

namespace offing::test {

/// Heights of drawn water beside those that are queried at the same places, added up.
struct DrawnWater {
  std::size_t count = 0;
  double height_squares_m2 = 0.0, off_squares_m2 = 0.0;
  std::size_t land_count = 0;  ///< of them, where ground stands above the still water
  double over_land_m =
      0.0;  ///< how far water is drawn there from the edge of the swash at most, if land hides it or not

  DrawnWater& operator+=(const DrawnWater& other) {
    count += other.count;
    height_squares_m2 += other.height_squares_m2;
    off_squares_m2 += other.off_squares_m2;
    land_count += other.land_count;
    over_land_m = std::max(over_land_m, other.over_land_m);
    return *this;
  }
  // Root mean squares, m: of drawn heights, and of how far queries are off them.
  double height_m() const { return std::sqrt(height_squares_m2 / static_cast<double>(count)); }
  double off_m() const { return std::sqrt(off_squares_m2 / static_cast<double>(count)); }
};

/// Of the pixels of the surface's last picture, which this camera saw, that show water.
DrawnWater drawn_beside_queried(world::World& world, const present::WaterSurface& surface,
                                const Camera& camera);

}  // namespace offing::test

#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace offing::present {

/// How much of its detail a picture is drawn with, as shares of what its settings say.
struct Quality {
  double side_share = 1.0;       ///< of the picture's pixels along a side, which are shown enlarged
  double ray_share = 1.0;        ///< of these pixels, for which rays are cast at the ground
  double grid_share = 1.0;       ///< of the cells of the water's grid along a side
  double views_share = 1.0;      ///< of the pixels along a side of what water mirrors and shows beneath it
  double cloud_light_rad = 0.0;  ///< World::see_clouds()'s tolerance

  bool operator==(const Quality&) const = default;

  /// Rays a pixel along a side.
  double ray_scale() const { return std::sqrt(ray_share); }
};

/// A share of a number, of which `least` is left.
inline int share_of(int number, double share, int least) {
  return std::max(std::min(number, least), static_cast<int>(std::lround(share * number)));
}

/// The rungs of a ladder of quality, coarser from one to the next: first what is least seen.
inline constexpr std::array quality_rungs{
    Quality{},
    Quality{.ray_share = 0.5, .grid_share = 0.75, .views_share = 0.75, .cloud_light_rad = 0.005},
    Quality{.side_share = 0.85,
            .ray_share = 0.5,
            .grid_share = 0.75,
            .views_share = 0.5,
            .cloud_light_rad = 0.01},
    Quality{
        .side_share = 0.7, .ray_share = 0.5, .grid_share = 0.5, .views_share = 0.5, .cloud_light_rad = 0.01},
    Quality{
        .side_share = 0.6, .ray_share = 0.5, .grid_share = 0.5, .views_share = 0.4, .cloud_light_rad = 0.01},
    Quality{.side_share = 0.5,
            .ray_share = 0.5,
            .grid_share = 0.375,
            .views_share = 0.3,
            .cloud_light_rad = 0.01},
    Quality{.side_share = 0.4,
            .ray_share = 0.5,
            .grid_share = 0.375,
            .views_share = 0.25,
            .cloud_light_rad = 0.01},
    Quality{
        .side_share = 0.3, .ray_share = 0.5, .grid_share = 0.25, .views_share = 0.2, .cloud_light_rad = 0.01},
};

}  // namespace offing::present

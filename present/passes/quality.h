#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "host/world/light_lag.h"

namespace offing::present {

/// How much of its detail a picture is drawn with, as shares of what its settings say.
struct Quality {
  double side_share = 1.0;   ///< of the picture's pixels along a side, which are shown enlarged
  double ray_share = 1.0;    ///< of these pixels, for which rays are cast at the ground
  double grid_share = 1.0;   ///< of the cells of the water's grid along a side
  double views_share = 1.0;  ///< of the pixels along a side of what water mirrors and shows beneath it
  /// Clouds at their size, not by the cloudy sky's map, and with four lookups upright, not two.
  bool mirrors_finely = true;
  int sea_halvings = 0;     ///< of the samples along a patch of the sea
  int cloud_halvings = 0;   ///< of the particles of each cloud
  int most_wake_steps = 0;  ///< of wakes that a picture takes further (WorldWakes); 0: all
  world::LightLag light_lag{};

  bool operator==(const Quality&) const = default;

  /// Rays a pixel along a side.
  double ray_scale() const { return std::sqrt(ray_share); }
};

/// A share of a number, of which `least` is left.
inline int share_of(int number, double share, int least) {
  return std::max(std::min(number, least), static_cast<int>(std::lround(share * number)));
}

/// Wakes that have a long past to catch up with, as when a scene begins, do so in many frames: a step of a
/// usual window takes half a millisecond, and a frame that goes by with the wall clock needs three.
constexpr int wake_steps_of_frame = 24;

/// One coarser than the first, whose light all lags behind alike.
constexpr Quality coarser(double side_share, double grid_share, double views_share, int sea_halvings) {
  return {.side_share = side_share,
          .ray_share = 0.5,
          .grid_share = grid_share,
          .views_share = views_share,
          .mirrors_finely = side_share > 0.6,
          .sea_halvings = sea_halvings,
          .cloud_halvings = side_share > 0.7 ? 0 : (side_share > 0.5 ? 1 : 2),
          .most_wake_steps = wake_steps_of_frame,
          .light_lag = {.altitude_share = 0.05,
                        .cloud_steps = 12,
                        .cloud_light_frames = 8,
                        .cloud_rad = 0.01,
                        .cloud_parts = 8}};
}

/// The levels of the quality control, each coarser than the one before: first goes what is seen least.
inline constexpr std::array quality_levels{
    Quality{.most_wake_steps = wake_steps_of_frame, .light_lag = {.cloud_light_frames = 8}},
    coarser(1.0, 0.75, 0.75, 0),
    coarser(1.0, 0.5, 0.5, 1),
    coarser(0.85, 0.5, 0.5, 1),
    coarser(0.7, 0.5, 0.5, 1),
    coarser(0.6, 0.375, 0.3, 1),
    coarser(0.5, 0.375, 0.3, 1),
    coarser(0.4, 0.375, 0.25, 1),
    coarser(0.3, 0.25, 0.2, 2),
    coarser(0.2, 0.25, 0.15, 2),
};

}  // namespace offing::present

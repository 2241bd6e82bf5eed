#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

#include "host/base/parameter_check.h"
#include "kernels/shared/query_params.h"

/// What is asked of the water at a point, and what is answered.
namespace offing::ocean {

/// A place of the world above or below the water plane, m.
struct WaterPoint {
  double x_m = 0.0, z_m = 0.0;
};

/// The water on a point's vertical, as devices write it: height of the surface, m; slopes of the displaced
/// surface; the residual, m; velocity, m/s, pressure, Pa, and acceleration, m/s^2, at the depth that was
/// asked for; the expected error of the height, m.
using WaterSample = SurfaceQuerySample;

/// Its first floats, up to the pressure.
using FirstWaterFloats = std::array<float, SURFACE_QUERY_FIRST_FLOATS>;

/// The unit normal (x, y, z) of the surface there, upward.
inline std::array<float, 3> normal_of(const WaterSample& sample) {
  const float upward =
      1.0f / std::sqrt(sample.slope_x * sample.slope_x + 1.0f + sample.slope_z * sample.slope_z);
  return {-sample.slope_x * upward, upward, -sample.slope_z * upward};
}

/// What is asked of the water at a time.
struct WaterQuery {
  /// Velocity, pressure and acceleration are those of this depth below the moving surface (Wheeler
  /// stretching); 0 is the surface itself. Rings of raindrops count for height and pressure, wakes for
  /// vertical velocity too, and neither for anything else.
  double depth_m = 0.0;
  /// Shorter waves do not count, as for a hull that is longer than they are: Gerstner waves and modes of the
  /// cascades one by one, rings. 0: all count.
  double min_wavelength_m = 0.0;
  /// What the surface alone answers costs less: velocity, pressure and acceleration are 0 then.
  enum class Fields { surface, surface_and_flow } fields = Fields::surface_and_flow;
  double density_kgpm3 = 1025.0;  ///< for the pressure
  /// The search for a point's label ends where it misses the point by no more than this.
  double tolerance_m = 1e-4;
  /// How the waves of the cascades are found between the samples of their patches. Each sample says what
  /// error its height is expected to have, error_rms_m. Gerstner waves are exact in all.
  enum class Accuracy {
    automatic,   ///< exact for up to most_exact_points points, else maps
    exact,       ///< the sum over all modes, for each point
    maps,        ///< splines on maps that are made for queries
    frame_maps,  ///< straight lines on the maps of a frame, as they are drawn: the fastest. There is no
                 ///< acceleration, and short waves lose a quarter of their slopes
  } accuracy = Accuracy::automatic;
};

/// From here on maps cost less than sums over all modes, on two cores.
inline constexpr std::size_t most_exact_points = 16;

/// Takes the samples of some points, those from index `first` on; valid during the call.
using TakeSamples = std::function<void(std::size_t first, std::span<const WaterSample> samples)>;

/// The largest min_wavelength_m: longer than any wave.
inline constexpr double longest_filter_m = 1e6;

/// A point as devices read it. Throws Error(bad_input) unless it is within farthest_point_m.
SurfaceQueryPoint device_point(const WaterPoint& point);

/// Throws Error(bad_input) for a query out of range; `water_depth_m` may be infinite.
void require_valid_query(const WaterQuery& query, double water_depth_m);

}  // namespace offing::ocean

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <functional>
#include <span>

#include "host/base/parameter_check.h"
#include "kernels/shared/query_params.h"

/// Questions about the water at points, and the answers.
namespace offing::ocean {

/// A place in the horizontal plane: x east, z south, m.
struct WaterPoint {
  double x_m = 0.0, z_m = 0.0;
};

/// The water on a point's vertical, as devices write it: height of the surface, m; slopes of the displaced
/// surface; residual, m; velocity, m/s, pressure, Pa, and acceleration, m/s^2, at the query's depth_m;
/// expected error of the height, m.
using WaterSample = SurfaceQuerySample;

/// The first floats of a sample, up to the pressure.
using FirstWaterFloats = std::array<float, SURFACE_QUERY_FIRST_FLOATS>;

/// A sample, and how far the water there is from its place at rest, m.
using ShiftedWaterSample = SurfaceQueryShifted;

/// The upward unit normal (x, y, z) of the surface at a sample.
inline std::array<float, 3> normal_of(const WaterSample& sample) {
  const float upward =
      1.0f / std::sqrt(sample.slope_x * sample.slope_x + 1.0f + sample.slope_z * sample.slope_z);
  return {-sample.slope_x * upward, upward, -sample.slope_z * upward};
}

/// What to compute for the water at a time, and how.
struct WaterQuery {
  /// Depth below the moving surface at which velocity, pressure and acceleration are taken (Wheeler
  /// stretching); 0 is the surface itself. Rings of raindrops change the surface and pressure, wakes
  /// the vertical velocity too. Neither changes the rest of the flow.
  double depth_m = 0.0;
  /// Waves shorter than this are left out, as for a longer hull: Gerstner waves, modes of the cascades and
  /// rings of raindrops, each by its own length. 0: none are left out.
  double min_wavelength_m = 0.0;
  /// `surface` costs less: it leaves velocity, pressure and acceleration at 0.
  enum class Fields { surface, surface_and_flow } fields = Fields::surface_and_flow;
  double density_kgpm3 = 1025.0;  ///< for the pressure
  /// The search for a point's label (the place of its water at rest) ends within this distance of the point.
  double tolerance_m = 1e-4;
  /// How the waves of the cascades are evaluated between the samples of their patches. error_rms_m of each
  /// sample is the expected error of its height. Gerstner waves are exact in all.
  enum class Accuracy {
    automatic,   ///< exact for up to most_exact_points points, else maps
    exact,       ///< the sum over all modes, for each point
    maps,        ///< splines on maps that are made for queries
    frame_maps,  ///< linear interpolation of the maps of a frame, as they are drawn: the fastest. There is
                 ///< no acceleration, and short waves lose a quarter of their slopes
  } accuracy = Accuracy::automatic;
};

/// With more points, maps cost less than sums over all modes, on two cores.
inline constexpr std::size_t most_exact_points = 16;

/// Takes the samples of the points from index `first` on. They are valid during the call.
using TakeSamples = std::function<void(std::size_t first, std::span<const WaterSample> samples)>;

/// The largest min_wavelength_m: longer than any wave.
inline constexpr double longest_filter_m = 1e6;

/// A point as devices read it. Throws Error(bad_input) if a coordinate is beyond farthest_point_m.
SurfaceQueryPoint device_point(const WaterPoint& point);

/// Throws Error(bad_input) for a query out of range; `water_depth_m` may be infinite.
void require_valid_query(const WaterQuery& query, double water_depth_m);

}  // namespace offing::ocean

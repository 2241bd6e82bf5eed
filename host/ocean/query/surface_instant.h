#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "host/ocean/query/gerstner_instant.h"
#include "host/ocean/query/shoals.h"
#include "host/ocean/query/water_query.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/wakes/wake_maps.h"

namespace offing::ocean {

/// A composed sea at one time in host memory, for single points: what ocean/surface_query.cl answers from a
/// frame's maps, in double precision and without a device. There is no acceleration.
class SurfaceInstant {
 public:
  /// One cascade's maps, [n][n][4]: those of SurfaceMaps, and VelocityMap's at the query's depth or nothing.
  struct Maps {
    double patch_length_m = 0.0;
    std::vector<float> displacement, gradient, flow;
  };

  /// Throws Error(bad_input) for Gerstner waves, time or query out of range.
  SurfaceInstant(std::vector<Maps> cascades, int size, const GerstnerSea& gerstner_waves, double time_s,
                 const WaterQuery& query, const Dispersion& dispersion,
                 std::vector<WakeMaps::Instant> wakes = {}, std::optional<ShoalsInstant> shoals = {},
                 double error_rms_m = 0.0);

  /// The water on this point's vertical. Throws Error(bad_input) for a point beyond farthest_point_m.
  WaterSample at(const WaterPoint& point) const;
  /// All cascades, Gerstner waves and wakes at a label, summed, with what shoals leave of them.
  GerstnerValues at_label(const WaterPoint& label) const { return sums_at(label).values; }

  const std::vector<Maps>& cascades() const { return cascades_; }
  const GerstnerInstant& gerstner_waves() const { return gerstner_waves_; }

 private:
  struct Sums {
    GerstnerValues values;
    // Of the displacement as it is interpolated: what steps toward a label follow.
    double x_by_x = 0.0, z_by_x = 0.0, x_by_z = 0.0, z_by_z = 0.0;
  };

  /// What is left of waves at a label: of each cascade, and of each Gerstner wave.
  struct Shares {
    std::array<double, SHOAL_FIRST_GERSTNER> cascades;
    std::vector<double> gerstner_waves;
  };

  Shares shares_at(const WaterPoint& label) const;
  Sums sums_at(const WaterPoint& label) const;
  WaterPoint label_under(const WaterPoint& point) const;

  std::vector<Maps> cascades_;
  int size_;
  GerstnerInstant gerstner_waves_;
  std::vector<WakeMaps::Instant> wakes_;
  std::optional<ShoalsInstant> shoals_;
  std::vector<std::size_t> bands_;  // of each Gerstner wave, over shoals
  WaterQuery query_;
  double weight_papm_, error_rms_m_;
};

}  // namespace offing::ocean

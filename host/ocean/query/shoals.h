#pragma once

#include <array>
#include <memory>

#include "host/ocean/query/depth_map.h"
#include "host/ocean/query/shoaling.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "kernels/shared/shoal_params.h"

namespace offing::ocean {

/// Shares of waves in host memory, at single labels in double precision: what ocean/surface_query.cl reads.
struct ShoalsInstant {
  std::shared_ptr<const DepthMap> depths;
  ShoalTable table;

  /// Of each band at a label.
  std::array<double, SHOAL_BANDS> at(double x_m, double z_m) const {
    return table.at(depths->depth_m(x_m, z_m));
  }
};

/// The shoals of a sea: how deep it is where, and what is left of its waves over each depth, on a device.
/// Shares scale all that a wave does at a label: heights, sideways displacements, slopes, velocities,
/// pressures. How they change from label to label is left out of slopes and gradients: that part is at most
/// the height times SHOAL_STEEPEST times the change of the share with depth, of significant waves that break
/// a quarter of breaking_share times the slope of the bed (0.007 of a beach of 1 : 20).
class Shoals {
 public:
  /// Throws what require_valid_depths() throws, Error(bad_usage) without a table, Error(out_of_memory).
  Shoals(const ocl::Device& device, std::shared_ptr<const DepthMap> depths, const ShoalTable& table);

  const ShoalsInstant& instant() const { return instant_; }
  const ocl::Buffer<ShoalMap>& map() const { return map_; }
  /// [rows][columns] m.
  const ocl::Buffer<float>& depths_m() const { return depths_m_; }
  /// [SHOAL_STEPS][SHOAL_BANDS].
  const ocl::Buffer<float>& shares() const { return shares_; }

 private:
  ShoalsInstant instant_;
  ocl::Buffer<ShoalMap> map_;
  ocl::Buffer<float> depths_m_, shares_;
};

}  // namespace offing::ocean

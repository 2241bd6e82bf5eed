#pragma once

#include <cstdint>
#include <limits>
#include <span>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"
#include "host/terrain/analysis/earth_curve.h"
#include "host/terrain/field/height_field.h"
#include "kernels/shared/terrain_sight.h"

namespace offing::terrain {

/// Who looks, and at what.
struct ViewshedParameters {
  double observer_x_m = 0.0, observer_z_m = 0.0;  ///< within the map
  double observer_height_m = 1.7;                 ///< of the eye above the ground, 0 ... 1e6
  double target_height_m = 0.0;                   ///< of what is to be seen above the ground, 0 ... 1e6
  /// In plan; what is beyond is not seen. Above 0.
  double radius_m = std::numeric_limits<double>::infinity();
  EarthCurve curve{};
};

/// Throws Error(bad_input) that names what is out of range.
void require_valid(const ViewshedParameters& parameters, const PostGrid& grid);

/// Which posts of a height field are seen from a point: those whose line of sight, from the eye to
/// target_height_m above the post, is nowhere below the surface of bilinear patches, the one that rays hit.
/// Touching it hides nothing. Heights fall away by curve from the observer on.
///
/// Posts whose line clears, or cuts, the surface by more than rounding agree with double precision: 1e-5 of
/// posts do not (tests/terrain/analysis/viewshed_test.cpp).
class Viewshed {
 public:
  explicit Viewshed(const ocl::Device& device);

  /// Enqueues seen [rows][columns]: 255 is seen, 0 is not. Throws what require_valid() throws, and
  /// Error(bad_usage) if the buffer holds fewer.
  void at(const HeightField& field, const ViewshedParameters& parameters,
          ocl::Buffer<std::uint8_t>& seen) const;

  /// The same in two steps, the first from the field's heights on the host.
  static TerrainSight sight_from(const PostGrid& grid, std::span<const float> heights_m,
                                 const ViewshedParameters& parameters);
  void at(const HeightField& field, const TerrainSight& sight, ocl::Buffer<std::uint8_t>& seen) const;

 private:
  ocl::KernelTuning rays_;
  ocl::Kernel sweep_, walk_;
};

}  // namespace offing::terrain

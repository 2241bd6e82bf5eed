#pragma once

#include "host/base/camera.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/terrain/field/height_field.h"
#include "kernels/shared/terrain.h"

namespace offing::terrain {

/// What a level sheet of water mirrors of ground (O13 of docs/sources.md).
class MirroredCast {
 public:
  /// Throws what programs throw.
  explicit MirroredCast(const ocl::Device& device);

  /// Enqueues hits [height_px][width_px] of a camera whose eye is below a level plane: what its rays hit
  /// first after they have come up through the plane, by distances from the eye. What is below the plane
  /// hides nothing. Throws what device_view() and HeightField::cast() throw.
  void at(HeightField& field, const Camera& camera, double plane_m, ocl::Buffer<TerrainHit>& hits);

 private:
  ocl::Device device_;
  ocl::Kernel rays_kernel_, hits_kernel_;
  ocl::Buffer<TerrainRay> rays_;
};

}  // namespace offing::terrain

#pragma once

#include <array>
#include <optional>

#include "host/base/camera.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "host/terrain/height_field.h"
#include "host/terrain/tiled_field.h"
#include "kernels/shared/sky_params.h"
#include "kernels/shared/terrain_light.h"

namespace offing::terrain {

/// One float4 of the device.
using Texel = std::array<float, 4>;

/// What lights the ground: the sky's parameters and its view table of kernels/sky for the camera's eye, and
/// what shared/terrain_light.h says of the light.
struct GroundLight {
  TerrainLight light;
  SkyParams sky;
  const ocl::Buffer<Texel>& view_table;
};

/// The light that a camera sees of the ground: cover by height and slope, the sun with soft shadows by a walk
/// of its own through the pyramid, the sky, and the air between (T10 of docs/sources.md). Slopes are averaged
/// over what a pixel sees.
class TerrainShade {
 public:
  explicit TerrainShade(const ocl::Device& device);

  /// Enqueues the image [height_px][width_px] (r, g, b, coverage), kcd/m2 in linear Rec.709, of what the
  /// camera's rays hit, as HeightField::cast() wrote it; (0, 0, 0, 0) where they miss. Throws
  /// Error(bad_usage) for buffers that hold fewer, and what device_view() and programs throw.
  void at(const HeightField& field, const Camera& camera, const ocl::Buffer<TerrainHit>& hits,
          const GroundLight& light, ocl::Buffer<Texel>& image) const;
  /// The same for the tiles of the field's last look().
  void at(const TiledField& field, const Camera& camera, const ocl::Buffer<TerrainHit>& hits,
          const GroundLight& light, ocl::Buffer<Texel>& image) const;

 private:
  ocl::Device device_;
  int lanes_;
  mutable std::optional<ocl::Kernel> kernel_, tiles_kernel_;  ///< built when they are first asked for
};

}  // namespace offing::terrain

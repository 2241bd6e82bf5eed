#pragma once

#include "host/base/camera.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/shading/terrain_shade.h"
#include "host/terrain/tiles/tiled_field.h"

namespace offing::terrain {

/// How far away pictures draw the ground of each pixel: where it covers a pixel in part and the pixel's own
/// ray has passed it, as far as the ground beside it.
class EdgeDistances {
 public:
  /// Throws what programs throw.
  explicit EdgeDistances(const ocl::Device& device);

  /// Enqueues drawn_m [height_px][width_px], m along the unit rays, of the image of TerrainShade and the
  /// distances of HitPlanes for the same camera and sea, where lakes stand before the ground as
  /// LakeLayer::stand_before() leaves them. Throws Error(bad_usage) for buffers that hold fewer, and what
  /// device_view() throws.
  void at(const HeightField& field, const Camera& camera, const SeaOverTerrain& sea,
          const ocl::Buffer<Texel>& image, const ocl::Buffer<float>& distances_m,
          ocl::Buffer<float>& drawn_m) const;
  /// The same for the tiles of the field's last look().
  void at(const TiledField& field, const Camera& camera, const SeaOverTerrain& sea,
          const ocl::Buffer<Texel>& image, const ocl::Buffer<float>& distances_m,
          ocl::Buffer<float>& drawn_m) const;

 private:
  void at(const TerrainField& field, const TerrainView& view, const SeaOverTerrain& sea,
          const ocl::Buffer<Texel>& image, const ocl::Buffer<float>& distances_m,
          ocl::Buffer<float>& drawn_m) const;

  ocl::Kernel kernel_;
};

}  // namespace offing::terrain

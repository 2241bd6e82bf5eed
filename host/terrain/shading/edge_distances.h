#pragma once

#include "host/base/camera.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/shading/terrain_shade.h"
#include "host/terrain/tiles/tiled_field.h"
#include "kernels/shared/terrain.h"

namespace offing::terrain {

/// Distances at which the ground of pixels is drawn. If ground covers only part of a pixel and the pixel's
/// own ray misses it, that is the distance of the nearest ground beside it.
class EdgeDistances {
 public:
  /// Throws what programs throw.
  explicit EdgeDistances(const ocl::Device& device);

  /// Enqueues drawn_m [height_px][width_px], m along the unit rays: of the image of TerrainShade, and of the
  /// distances of HitPlanes for the same camera and sea, to which LakeLayer::stand_before() may have added
  /// lakes. drawn_m is another buffer than distances_m. Throws Error(bad_usage) for buffers that hold fewer
  /// pixels, and what device_view() throws.
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

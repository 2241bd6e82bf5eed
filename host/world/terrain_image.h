#pragma once

#include "host/base/camera.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/terrain/cast/hit_planes.h"
#include "host/terrain/shading/terrain_shade.h"
#include "kernels/shared/terrain.h"

namespace offing::world {

/// What a camera sees of ground, on a device: exactly as large as its picture, row 0 at the top.
struct TerrainImage {
  int width_px = 0, height_px = 0;
  /// [height_px][width_px]
  ocl::Buffer<TerrainHit> hits = {};
  /// [height_px][width_px] (r, g, b, coverage), kcd/m2, linear Rec.709, premultiplied.
  ocl::Buffer<terrain::Texel> image = {};
  /// [2][height_px][width_px]: distance m, +inf where there is no ground; steps of the ray.
  ocl::Buffer<float> planes = {};
  terrain::SeaOverTerrain sea = {};

  /// Gives it the size of the camera's picture.
  void fit(const ocl::Device& device, const Camera& camera);
};

}  // namespace offing::world

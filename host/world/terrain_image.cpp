#include "host/world/terrain_image.h"

#include "host/terrain/cast/image_rays.h"

namespace offing::world {

void TerrainImage::fit(const ocl::Device& device, const Camera& camera) {
  if (width_px == camera.width_px && height_px == camera.height_px) return;
  const std::size_t pixels = terrain::pixel_count(camera);
  hits = ocl::Buffer<TerrainHit>(device, pixels, "ground's hits");
  image = ocl::Buffer<terrain::Texel>(device, pixels, "ground's image");
  planes = ocl::Buffer<float>(device, terrain::HitPlanes::plane_count * pixels, "ground's planes");
  width_px = camera.width_px;
  height_px = camera.height_px;
}

}  // namespace offing::world

#include "host/terrain/cast/mirrored_cast.h"

#include "host/ocl/program.h"
#include "host/terrain/cast/image_rays.h"

namespace offing::terrain {
namespace {

// Where a ray is after this many metres is known to a tenth of a metre.
constexpr float farthest_m = 1e6f;

ocl::Kernel kernel_of(const ocl::Device& device, const char* file, const char* name) {
  return ocl::Program::build(device, file, ocl::Defines()).kernel(name);
}

}  // namespace

MirroredCast::MirroredCast(const ocl::Device& device)
    : device_(device),
      rays_kernel_(kernel_of(device, "terrain/mirror_rays.cl", "mirror_rays")),
      hits_kernel_(kernel_of(device, "terrain/mirror_hits.cl", "mirror_hits")) {}

void MirroredCast::at(HeightField& field, const Camera& camera, double plane_m,
                      ocl::Buffer<TerrainHit>& hits) {
  const TerrainView view = device_view(camera, field.grid());
  const std::size_t pixels = pixel_count(camera);
  require_room("hits", pixels, hits.size());
  if (rays_.size() < pixels) rays_ = ocl::Buffer<TerrainRay>(device_, pixels, "mirrored rays");
  const auto plane = static_cast<float>(plane_m);
  rays_kernel_.launch({{pixels}}, field.device_field(CastMethod::parity), view, plane, farthest_m, rays_);
  field.cast(rays_, pixels, hits);
  hits_kernel_.launch({{pixels}}, view, plane, hits);
}

}  // namespace offing::terrain

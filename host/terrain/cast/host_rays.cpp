#include "host/terrain/cast/host_rays.h"

#include <algorithm>

namespace offing::terrain {
namespace {

// Rays that are on the device at a time: 23 MB with their hits.
constexpr std::size_t most_rays = std::size_t{1} << 18;

}  // namespace

std::vector<RayHit> HostRays::cast(const ocl::Device& device, const PostGrid& grid,
                                   std::span<const RayToBox> rays, const Cast& cast) {
  const std::size_t most = std::min(rays.size(), most_rays);
  if (rays_.size() < most) {
    rays_ = ocl::Buffer<TerrainRay>(device, most, "rays");
    hits_ = ocl::Buffer<TerrainHit>(device, most, "hits");
  }
  std::vector<RayHit> found;
  found.reserve(rays.size());
  std::vector<TerrainRay> packed(most);
  std::vector<TerrainHit> hits(most);
  for (std::size_t first = 0; first < rays.size(); first += most_rays) {
    const std::span<const RayToBox> some = rays.subspan(first, std::min(most_rays, rays.size() - first));
    std::transform(some.begin(), some.end(), packed.begin(),
                   [&](const RayToBox& to_box) { return device_ray(to_box.ray, grid); });
    rays_.write(std::span(packed).first(some.size()));
    cast(rays_, some.size(), hits_);
    hits_.read(std::span(hits).first(some.size()));
    for (std::size_t i = 0; i < some.size(); ++i) found.push_back(ray_hit(hits[i], some[i].moved_m));
  }
  return found;
}

}  // namespace offing::terrain

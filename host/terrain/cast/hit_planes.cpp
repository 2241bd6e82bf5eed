#include "host/terrain/cast/hit_planes.h"

#include "host/ocl/program.h"
#include "host/terrain/cast/image_rays.h"

namespace offing::terrain {

HitPlanes::HitPlanes(const ocl::Device& device)
    : kernel_(ocl::Program::build(device, "terrain/hit_planes.cl", ocl::Defines()).kernel("hit_planes")) {}

void HitPlanes::at(const ocl::Buffer<TerrainHit>& hits, std::size_t count, ocl::Buffer<float>& distances_m,
                   ocl::Buffer<float>& planes) const {
  require_room("hits", count, hits.size());
  require_room("distances", count, distances_m.size());
  require_room("planes", plane_count * count, planes.size());
  kernel_.launch({{count}}, hits, static_cast<int>(count), distances_m, planes);
}

}  // namespace offing::terrain

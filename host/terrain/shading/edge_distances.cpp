#include "host/terrain/shading/edge_distances.h"

#include <cstddef>

#include "host/ocl/program.h"
#include "host/terrain/cast/image_rays.h"

namespace offing::terrain {

EdgeDistances::EdgeDistances(const ocl::Device& device)
    : kernel_(ocl::Program::build(device, "terrain/edge_distances.cl", ocl::Defines().set("LANES", 1))
                  .kernel("edge_distances")) {}

void EdgeDistances::at(const HeightField& field, const Camera& camera, const SeaOverTerrain& sea,
                       const ocl::Buffer<Texel>& image, const ocl::Buffer<float>& distances_m,
                       ocl::Buffer<float>& drawn_m) const {
  at(field.device_field(CastMethod::parity), device_view(camera, field.grid()), sea, image, distances_m,
     drawn_m);
}

void EdgeDistances::at(const TiledField& field, const Camera& camera, const SeaOverTerrain& sea,
                       const ocl::Buffer<Texel>& image, const ocl::Buffer<float>& distances_m,
                       ocl::Buffer<float>& drawn_m) const {
  at(field.device_field(), field.device_view(camera), sea, image, distances_m, drawn_m);
}

void EdgeDistances::at(const TerrainField& field, const TerrainView& view, const SeaOverTerrain& sea,
                       const ocl::Buffer<Texel>& image, const ocl::Buffer<float>& distances_m,
                       ocl::Buffer<float>& drawn_m) const {
  const auto width = static_cast<std::size_t>(view.width_px),
             height = static_cast<std::size_t>(view.height_px);
  require_room("image", width * height, image.size());
  require_room("distances", width * height, distances_m.size());
  require_room("drawn distances", width * height, drawn_m.size());
  kernel_.launch({{width, height}}, field, view, distances_m, image, static_cast<float>(sea.below_m),
                 static_cast<float>(sea.bend_perm), drawn_m);
}

}  // namespace offing::terrain

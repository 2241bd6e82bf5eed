#include "host/terrain/terrain_shade.h"

#include "host/ocl/program.h"
#include "host/terrain/picture.h"

namespace offing::terrain {

TerrainShade::TerrainShade(const ocl::Device& device)
    : lanes_(lanes_of(device)),
      kernel_(ocl::Program::build(device, "terrain/terrain_shade.cl",
                                  ocl::Defines().set("LANES", lanes_).set("UP_RULE", TERRAIN_UP_WITH_PARENT))
                  .kernel("terrain_shade")) {}

void TerrainShade::at(const HeightField& field, const Camera& camera, const ocl::Buffer<TerrainHit>& hits,
                      const GroundLight& light, ocl::Buffer<Texel>& image) const {
  const TerrainView view = device_view(camera, field.grid());
  require_room("hits", pixel_count(camera), hits.size());
  require_room("image", pixel_count(camera), image.size());
  kernel_.launch(picture_shape(camera, lanes_), field.heights_m(), field.pyramid().lids_m(),
                 field.device_field(CastMethod::parity), view, hits, light.light, light.sky, light.view_table,
                 image);
}

}  // namespace offing::terrain

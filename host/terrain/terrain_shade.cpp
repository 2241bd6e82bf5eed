#include "host/terrain/terrain_shade.h"

#include "host/ocl/program.h"
#include "host/terrain/picture.h"

namespace offing::terrain {
namespace {

ocl::Kernel build(const ocl::Device& device, const ocl::Defines& defines) {
  return ocl::Program::build(device, "terrain/terrain_shade.cl", defines).kernel("terrain_shade");
}

ocl::Defines defines_for(int lanes) {
  return ocl::Defines().set("LANES", lanes).set("UP_RULE", TERRAIN_UP_WITH_PARENT);
}

void require_pictures(const Camera& camera, const ocl::Buffer<TerrainHit>& hits,
                      const ocl::Buffer<Texel>& image) {
  require_room("hits", pixel_count(camera), hits.size());
  require_room("image", pixel_count(camera), image.size());
}

}  // namespace

TerrainShade::TerrainShade(const ocl::Device& device) : device_(device), lanes_(lanes_of(device)) {}

void TerrainShade::at(const HeightField& field, const Camera& camera, const ocl::Buffer<TerrainHit>& hits,
                      const GroundLight& light, ocl::Buffer<Texel>& image) const {
  const TerrainView view = device_view(camera, field.grid());
  require_pictures(camera, hits, image);
  if (!kernel_) kernel_ = build(device_, defines_for(lanes_));
  kernel_->launch(picture_shape(camera, lanes_), field.heights_m(), field.pyramid().lids_m(),
                  field.device_field(CastMethod::parity), view, hits, light.light, light.sky, light.view_table,
                  image);
}

void TerrainShade::at(const TiledField& field, const Camera& camera, const ocl::Buffer<TerrainHit>& hits,
                      const GroundLight& light, ocl::Buffer<Texel>& image) const {
  const TerrainView view = field.device_view(camera);
  require_pictures(camera, hits, image);
  if (!tiles_kernel_) tiles_kernel_ = build(device_, defines_for(lanes_).set_flag("TILED"));
  tiles_kernel_->launch(picture_shape(camera, lanes_), field.pool(), field.pages(), field.device_field(), view,
                        hits, light.light, light.sky, light.view_table, image);
}

}  // namespace offing::terrain

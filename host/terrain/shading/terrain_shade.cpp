#include "host/terrain/shading/terrain_shade.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/program.h"
#include "host/terrain/cast/image_rays.h"

namespace offing::terrain {
namespace {

constexpr int most_rays = 4096;

void require_valid(const Sampling& sampling) {
  if (sampling.rays < 1 || sampling.rays > most_rays) {
    throw Error(ErrorKind::bad_input,
                fmt::format("terrain sampling: rays: expected 1 ... {}, found {}", most_rays, sampling.rays),
                "16 rays per pixel are enough for smooth edges");
  }
  if (!std::isfinite(sampling.least_contrast)) {
    throw Error(ErrorKind::bad_input,
                fmt::format("terrain sampling: least_contrast: expected a finite share, found {}",
                            sampling.least_contrast),
                "0.2 is a fifth of a pixel's luminance");
  }
}

/// Launches a kernel with the arguments of lakes, or none.
template <class Launch>
void with(const LakeLayer* lakes, const Launch& launch) {
  if (lakes != nullptr) {
    launch(lakes->waters(), lakes->cells(), lakes->waves(), lakes->count());
  } else {
    launch();
  }
}

ocl::Defines with_lakes(ocl::Defines defines, const LakeLayer* lakes) {
  if (lakes != nullptr) defines.set("LAKES", 1);
  return defines;
}

}  // namespace

TerrainShade::TerrainShade(const ocl::Device& device)
    : device_(device),
      rays_(ray_tuning(device)),
      contrast_kernel_(ocl::Program::build(device, "terrain/terrain_contrast.cl").kernel("terrain_contrast")),
      no_colours_(device, 1, "colour map"),
      no_shares_(device, 1, "shares of the sky"),
      no_shadow_(device, 1, "shadow of clouds") {}

TerrainShade::Kernels TerrainShade::build(const ocl::Defines& defines) const {
  return {ocl::Program::build(device_, "terrain/terrain_shade.cl", defines).kernel("terrain_shade"),
          ocl::Program::build(device_, "terrain/terrain_refine.cl", defines).kernel("terrain_refine")};
}

void TerrainShade::at(const HeightField& field, const Camera& camera, const ocl::Buffer<TerrainHit>& hits,
                      const TerrainIllumination& light, ocl::Buffer<Texel>& image,
                      const TerrainAppearance& look) {
  std::optional<Kernels>& kernels = map_kernels_[look.lakes != nullptr ? 1 : 0];
  if (!kernels) {
    kernels = build(with_lakes(
        ocl::Defines().set("LANES", rays_.lanes).set("UP_RULE", TERRAIN_UP_WITH_PARENT), look.lakes));
  }
  paint(*kernels,
        {field.heights_m(), field.pyramid().maxima_m(), field.device_field(CastMethod::parity),
         device_view(camera, field.grid())},
        camera, hits, light, image, look);
}

void TerrainShade::at(const TiledField& field, const Camera& camera, const ocl::Buffer<TerrainHit>& hits,
                      const TerrainIllumination& light, ocl::Buffer<Texel>& image,
                      const TerrainAppearance& look) {
  if (look.open_sky != nullptr) {
    throw Error(ErrorKind::bad_usage, "terrain shade: shares of the sky are not those of tiles",
                "leave open_sky out");
  }
  std::optional<Kernels>& kernels =
      tile_kernels_[static_cast<std::size_t>(field.map().edge)][look.lakes != nullptr ? 1 : 0];
  if (!kernels) kernels = build(with_lakes(tiles_defines(rays_.lanes, field.map().edge), look.lakes));
  paint(*kernels, {field.pool(), field.pages(), field.device_field(), field.device_view(camera)}, camera,
        hits, light, image, look);
}

void TerrainShade::paint(const Kernels& kernels, const SeenTerrain& terrain, const Camera& camera,
                         const ocl::Buffer<TerrainHit>& hits, const TerrainIllumination& light,
                         ocl::Buffer<Texel>& image, const TerrainAppearance& look) {
  const Sampling& sampling = look.sampling;
  require_valid(sampling);
  const std::size_t pixels = pixel_count(camera);
  require_room("hits", pixels, hits.size());
  require_room("image", pixels, image.size());
  pixels_ = pixels;
  if (needs_.size() < pixels) {
    needs_ = ocl::Buffer<std::uint8_t>(device_, pixels, "terrain needs");
    edges_ = ocl::Buffer<Texel>(device_, pixels, "terrain edges");
  }
  TerrainLook device_look{};
  device_look.hidden_below_m = static_cast<float>(look.sea.below_m);
  device_look.hidden_bend_perm = static_cast<float>(look.sea.bend_perm);
  device_look.hidden_above_m = static_cast<float>(look.sea.above_m);
  device_look.sea_goes_on = look.sea_goes_on ? 1 : 0;
  if (look.colours != nullptr) look.colours->describe(device_look);
  if (look.open_sky != nullptr) look.open_sky->describe(device_look);
  const auto& colours = look.colours != nullptr ? look.colours->colours() : no_colours_;
  const auto& shares = look.open_sky != nullptr ? look.open_sky->shares() : no_shares_;
  const CloudShadowParams shadow = light.clouds != nullptr ? light.clouds->params : CloudShadowParams{};
  const auto& shadow_map = light.clouds != nullptr ? light.clouds->map : no_shadow_;
  const bool refines_all = sampling.rays > 1 && sampling.least_contrast < 0.0;
  if (refines_all || sampling.rays == 1) needs_.fill(refines_all ? TERRAIN_MANY_RAYS : TERRAIN_ONE_RAY);
  if (!refines_all) {
    with(look.lakes, [&](const auto&... lakes) {
      kernels.shade.launch(image_shape(camera, rays_), terrain.heights_m, terrain.maxima_m, terrain.field,
                           terrain.view, hits, light.light, light.sky, light.view_table, device_look, colours,
                           shares, shadow, shadow_map, lakes..., image, edges_);
    });
    if (sampling.rays == 1) return;
    contrast_kernel_.launch(
        {{static_cast<std::size_t>(camera.width_px), static_cast<std::size_t>(camera.height_px)}}, edges_,
        camera.width_px, camera.height_px, static_cast<float>(sampling.least_contrast), needs_);
  }
  with(look.lakes, [&](const auto&... lakes) {
    kernels.refine.launch(image_shape(camera, rays_), terrain.heights_m, terrain.maxima_m, terrain.field,
                          terrain.view, light.light, light.sky, light.view_table, device_look, colours,
                          shares, shadow, shadow_map, lakes..., needs_, sampling.rays, image);
  });
}

double TerrainShade::refined_share() const {
  if (pixels_ == 0) return 0.0;
  const auto needs = needs_.map();
  const auto begin = needs.span().begin(), end = begin + static_cast<std::ptrdiff_t>(pixels_);
  const auto left = std::count(begin, end, TERRAIN_ONE_RAY);
  return 1.0 - static_cast<double>(left) / static_cast<double>(pixels_);
}

}  // namespace offing::terrain

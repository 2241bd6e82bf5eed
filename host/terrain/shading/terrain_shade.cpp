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

bool shows_relief(const TerrainAppearance& look) {
  return look.relief != nullptr && look.relief->is_laid();
}

/// Of kernels of the same terrain.
std::size_t variant(const TerrainAppearance& look) {
  return (look.lakes != nullptr ? 1u : 0u) + (shows_relief(look) ? 2u : 0u) +
         (look.canopy != nullptr ? 4u : 0u);
}

ocl::Defines defines_of(const TerrainAppearance& look, ocl::Defines of_terrain) {
  if (look.lakes != nullptr) of_terrain.set_flag("LAKES");
  if (shows_relief(look)) of_terrain.set_flag("RELIEF");
  if (look.canopy != nullptr) of_terrain.set_flag("CANOPY");
  return of_terrain;
}

/// Launches a kernel with the arguments of lakes, of relief and of woods, where there are any.
template <class Launch>
void with_extras(const TerrainAppearance& look, const Launch& launch) {
  const auto with_woods = [&](const auto&... others) {
    if (look.canopy != nullptr) {
      TerrainCanopy params = look.canopy->params();
      params.stands = look.woods == WoodsShape::crowns ? 1 : 0;
      launch(others..., params, look.canopy->texels());
    } else {
      launch(others...);
    }
  };
  const auto with_relief = [&](const auto&... lakes) {
    if (shows_relief(look)) {
      with_woods(lakes..., look.relief->params(), look.relief->heights_m(), look.relief->maxima_m());
    } else {
      with_woods(lakes...);
    }
  };
  if (look.lakes != nullptr) {
    with_relief(look.lakes->waters(), look.lakes->cells(), look.lakes->waves(), look.lakes->count());
  } else {
    with_relief();
  }
}

}  // namespace

TerrainShade::TerrainShade(const ocl::Device& device)
    : device_(device),
      rays_(ray_tuning(device)),
      contrast_kernel_(ocl::Program::build(device, "terrain/terrain_contrast.cl").kernel("terrain_contrast")),
      no_colours_(device, 1, "colour map"),
      no_shares_(device, 1, "shares of the sky"),
      no_shadow_(device, 1, "shadow of clouds"),
      no_materials_(device, 1, "materials of terrain") {}

TerrainShade::Kernels TerrainShade::build(const ocl::Defines& defines) const {
  return {ocl::Program::build(device_, "terrain/terrain_shade.cl", defines).kernel("terrain_shade"),
          ocl::Program::build(device_, "terrain/terrain_refine.cl", defines).kernel("terrain_refine")};
}

void TerrainShade::at(const HeightField& field, const Camera& camera, ocl::Buffer<TerrainHit>& hits,
                      const TerrainIllumination& light, ocl::Buffer<Texel>& image,
                      const TerrainAppearance& look) {
  std::optional<Kernels>& kernels = map_kernels_[variant(look)];
  if (!kernels) {
    kernels = build(
        defines_of(look, ocl::Defines().set("LANES", rays_.lanes).set("UP_RULE", TERRAIN_UP_WITH_PARENT)));
  }
  paint(*kernels,
        {field.heights_m(), field.pyramid().maxima_m(), field.device_field(CastMethod::parity),
         device_view(camera, field.grid())},
        camera, hits, light, image, look);
}

void TerrainShade::at(const TiledField& field, const Camera& camera, ocl::Buffer<TerrainHit>& hits,
                      const TerrainIllumination& light, ocl::Buffer<Texel>& image,
                      const TerrainAppearance& look) {
  if (look.open_sky != nullptr) {
    throw Error(ErrorKind::bad_usage, "terrain shade: shares of the sky are not those of tiles",
                "leave open_sky out");
  }
  std::optional<Kernels>& kernels = tile_kernels_[static_cast<std::size_t>(field.map().edge)][variant(look)];
  if (!kernels) kernels = build(defines_of(look, tiles_defines(rays_.lanes, field.map().edge)));
  paint(*kernels, {field.pool(), field.pages(), field.device_field(), field.device_view(camera)}, camera,
        hits, light, image, look);
}

void TerrainShade::paint(const Kernels& kernels, const SeenTerrain& terrain, const Camera& camera,
                         ocl::Buffer<TerrainHit>& hits, const TerrainIllumination& light,
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
  device_look.finest_detail_m = static_cast<float>(look.finest_detail_m);
  if (look.colours != nullptr) look.colours->describe(device_look);
  if (look.open_sky != nullptr) look.open_sky->describe(device_look);
  device_look.material_count = look.materials != nullptr ? look.materials->count() : 0;
  const auto& materials = look.materials != nullptr ? look.materials->materials() : no_materials_;
  const auto& colours = look.colours != nullptr ? look.colours->colours() : no_colours_;
  const auto& shares = look.open_sky != nullptr ? look.open_sky->shares() : no_shares_;
  const CloudShadowParams shadow = light.clouds != nullptr ? light.clouds->params : CloudShadowParams{};
  const auto& shadow_map = light.clouds != nullptr ? light.clouds->map : no_shadow_;
  const bool refines_all = sampling.rays > 1 && sampling.least_contrast < 0.0;
  if (refines_all || sampling.rays == 1) needs_.fill(refines_all ? TERRAIN_MANY_RAYS : TERRAIN_ONE_RAY);
  const auto launch = [&](const ocl::Kernel& kernel, const auto&... arguments) {
    kernel.launch(image_shape(camera, rays_), terrain.heights_m, terrain.maxima_m, terrain.field,
                  terrain.view, arguments...);
  };
  if (!refines_all) {
    with_extras(look, [&](const auto&... extras) {
      launch(kernels.shade, hits, light.light, light.sky, light.view_table, device_look, colours, shares,
             shadow, shadow_map, materials, extras..., image, edges_);
    });
    if (sampling.rays == 1) return;
    contrast_kernel_.launch(
        {{static_cast<std::size_t>(camera.width_px), static_cast<std::size_t>(camera.height_px)}}, edges_,
        camera.width_px, camera.height_px, static_cast<float>(sampling.least_contrast), needs_);
  }
  with_extras(look, [&](const auto&... extras) {
    launch(kernels.refine, light.light, light.sky, light.view_table, device_look, colours, shares, shadow,
           shadow_map, materials, extras..., needs_, sampling.rays, image);
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

#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "host/base/camera.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/ocl/program.h"
#include "host/ocl/tuning.h"
#include "host/terrain/cast/relief_surface.h"
#include "host/terrain/field/height_field.h"
#include "host/terrain/lakes/lake_layer.h"
#include "host/terrain/shading/canopy.h"
#include "host/terrain/shading/colour_layer.h"
#include "host/terrain/shading/materials.h"
#include "host/terrain/shading/open_sky.h"
#include "host/terrain/tiles/tiled_field.h"
#include "kernels/shared/cloud_shadow.h"
#include "kernels/shared/sky_params.h"
#include "kernels/shared/terrain_light_params.h"

namespace offing::terrain {

/// One float4 of the device.
using Texel = std::array<float, 4>;

/// The shadow of clouds (kernels/clouds/cloud_shadow.clh), with places relative to the point at sea level
/// below the camera's eye.
struct CloudShade {
  CloudShadowParams params;
  const ocl::Buffer<Texel>& map;
};

/// What lights the ground: the sky's parameters and its view table of kernels/sky for the camera's eye, and
/// what shared/terrain_light_params.h says of the light.
struct TerrainIllumination {
  TerrainLight light;
  SkyParams sky;
  const ocl::Buffer<Texel>& view_table;
  const CloudShade* clouds = nullptr;  ///< none: no clouds shade it
};

/// Rays a pixel. All pixels get one. Those whose light differs from that of a neighbour by more than a share
/// of the brighter one's luminance get a quarter of `rays` of their own instead, and all of them where it
/// differs by TERRAIN_MANY_CONTRASTS times as much or where the ground ends; they are spread evenly over the
/// pixel. The light is that of ground without relief, and greyer: materials are filtered over the pixel as
/// they are computed.
struct Sampling {
  int rays = 16;                 ///< 1 ... 4096; 1: no pixel gets more
  double least_contrast = 0.15;  ///< below 0: all pixels get all of them
};

/// A sea that is drawn over its bed: pixels do not see ground that lies deeper than this; nor, in a picture
/// of what is under water, ground that stands out of it.
struct SeaOverTerrain {
  double below_m = -1e30;
  double bend_perm = 0.0;  ///< the depth grows by this times the square of the distance
  double above_m = 1e30;   ///< ground more than four pixels above it is not seen
};

/// How pictures show woods.
enum class WoodsShape {
  crowns,  ///< rays hit crowns
  even,    ///< rays hit the ground under them, which has the mean light of the wood
};

/// What lies on the ground, and how finely it is drawn. What is pointed to is not kept.
struct TerrainAppearance {
  Sampling sampling = {};
  const ColourLayer* colours = nullptr;  ///< none: cover by height and slope
  const OpenSky* open_sky = nullptr;     ///< none: nothing but its own slope hides the sky from ground
  SeaOverTerrain sea = {};
  const LakeLayer* lakes = nullptr;          ///< nullptr: none
  const MaterialLayer* materials = nullptr;  ///< over the cover by height and slope; nullptr: none
  const CanopyLayer* canopy = nullptr;       ///< woods over all of these; nullptr: none
  WoodsShape woods = WoodsShape::crowns;
  /// Whether rays that pass by the map meet a sea beyond it, at TerrainLight::sea_level_m.
  bool sea_goes_on = false;
  const ReliefSurface* relief = nullptr;  ///< that the hits are of; none: they are those of the field
  double finest_detail_m = 0.0;           ///< patterns of the ground that are finer show as their mean
};

/// The light that a camera sees of the ground: its colours, or cover by height and slope, the sun with soft
/// shadows by a walk of its own through the pyramid, the sky, and the air between (T10 of docs/sources.md).
/// Slopes are averaged over what a pixel sees, and edges over the rays of `Sampling`.
class TerrainShade {
 public:
  explicit TerrainShade(const ocl::Device& device);

  /// Enqueues the image [height_px][width_px] (r, g, b, coverage) of what the camera sees, kcd/m2 in linear
  /// Rec.709, premultiplied by the coverage, the share of a pixel's rays that hit: what is behind shines
  /// through with 1 - coverage. `hits` are those of HeightField::cast() for the same camera; where crowns of
  /// woods stand in front, they become hits of the crowns. Throws Error(bad_usage) for buffers that hold
  /// fewer, Error(bad_input) for a sampling out of range, and what device_view() and programs throw.
  void at(const HeightField& field, const Camera& camera, ocl::Buffer<TerrainHit>& hits,
          const TerrainIllumination& light, ocl::Buffer<Texel>& image, const TerrainAppearance& look = {});

  /// The same for the tiles of the field's last look(). Throws Error(bad_usage) for a look with shares of the
  /// sky, which are those of a HeightField.
  void at(const TiledField& field, const Camera& camera, ocl::Buffer<TerrainHit>& hits,
          const TerrainIllumination& light, ocl::Buffer<Texel>& image, const TerrainAppearance& look = {});

  /// Waits for the share of pixels of the last at() that got rays of their own.
  double refined_share() const;

 private:
  struct Kernels {
    ocl::Kernel shade, refine;
  };
  /// As kernels take it: heights and maxima, or the pool and pages of tiles.
  struct SeenTerrain {
    const ocl::Buffer<float>&heights_m, &maxima_m;
    TerrainField field;
    TerrainView view;
  };
  Kernels build(const ocl::Defines& defines) const;
  void paint(const Kernels& kernels, const SeenTerrain& terrain, const Camera& camera,
             ocl::Buffer<TerrainHit>& hits, const TerrainIllumination& light, ocl::Buffer<Texel>& image,
             const TerrainAppearance& look);

  ocl::Device device_;
  ocl::KernelTuning rays_;
  // Built when they are first asked for, by which of lakes, relief and woods there are; those of tiles by
  // MapEdge.
  using Variants = std::array<std::optional<Kernels>, 8>;
  Variants map_kernels_;
  std::array<Variants, 3> tile_kernels_;
  ocl::Kernel contrast_kernel_;
  ocl::Buffer<std::uint32_t> no_colours_;
  ocl::Buffer<std::uint8_t> no_shares_;
  ocl::Buffer<Texel> no_shadow_;
  ocl::Buffer<TerrainMaterial> no_materials_;
  ocl::Buffer<std::uint8_t> needs_;  // [height_px][width_px]
  ocl::Buffer<Texel> edges_;         // the same, of terrain_shade.cl
  std::size_t pixels_ = 0;           // of the last picture
};

}  // namespace offing::terrain

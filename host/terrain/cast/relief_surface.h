#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

#include "host/base/camera.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/ocl/program.h"
#include "host/ocl/tuning.h"
#include "host/terrain/lakes/lake_layer.h"
#include "host/terrain/shading/materials.h"
#include "kernels/shared/terrain.h"
#include "kernels/shared/terrain_relief.h"

namespace offing::terrain {

class HeightField;
class TiledField;

/// Ground without relief, under something that stands on it.
struct LevelDisc {
  double x_m = 0.0, z_m = 0.0;  ///< from the first post
  double radius_m = 1.0;        ///< relief begins at this radius, and is complete ramp_m() farther out
  double share = 1.0;           ///< 0: relief is as elsewhere

  double ramp_m() const { return 1.5 + 0.5 * radius_m; }
  bool operator==(const LevelDisc&) const = default;
};

/// Relief that pictures show between the posts of the ground.
struct ReliefSettings {
  double strength = 1.0;                              ///< 0 none, 1 that of the shaded normals
  double shore_m = -1e30;                             ///< there is none at or below this height
  double tree_line_m = 2000.0, snow_line_m = 2800.0;  ///< m; stones lie above the first
  std::vector<LevelDisc> discs = {};
  std::vector<std::shared_ptr<const Lake>> lakes = {};  ///< at whose shores relief ends as at shore_m
  std::vector<Material> materials = {};                 ///< of the scene; each has its relief

  bool operator==(const ReliefSettings&) const = default;
};

/// The levels of relief of a map. The spacing of posts is four times that of the level before.
struct ReliefLevels {
  int count = 0;         ///< 0: posts of the map are already that close
  int finest_log2 = 0;   ///< the first has 2^finest_log2 steps to a cell of the map
  double reach_m = 0.0;  ///< there is no relief farther from the eye
};
ReliefLevels relief_levels(int cells_x, int cells_z, double spacing_x_m, double spacing_z_m);

/// The ground that is drawn near an eye: the surface of a field with relief between its posts, within some
/// hundred metres. Only pictures use it; queries use the field. A camera above the field's surface is never
/// inside the relief.
///
/// It has up to three levels of posts around the eye, bilinear between posts; those of the first level are
/// two decimetres apart. Relief fades out with the distance, finer octaves first (shared/terrain_relief.h).
class ReliefSurface {
 public:
  /// Throws what programs throw.
  explicit ReliefSurface(const ocl::Device& device);

  /// Enqueues the surface that a camera sees; it keeps no reference to the field. Outside the picture it is
  /// the field's own surface. There is no relief where the eye is off the map, or too high above the ground
  /// (`above_m`). `lakes` are those of the settings, null for none. Throws what device_view() throws.
  void at(const HeightField& field, const Camera& camera, double above_m, const ReliefSettings& settings,
          const LakeLayer* lakes = nullptr);
  /// The same with the tiles of the last look(). Maps that repeat or mirror have no relief.
  void at(const TiledField& field, const Camera& camera, double above_m, const ReliefSettings& settings,
          const LakeLayer* lakes = nullptr);

  /// Whether the last at() made any relief; if not, the field is drawn as it is.
  bool is_laid() const { return params_.levels > 0; }
  const TerrainRelief& params() const { return params_; }
  const ocl::Buffer<float>& heights_m() const { return heights_m_; }
  const ocl::Buffer<float>& maxima_m() const { return maxima_m_; }

 private:
  /// Fills params_. False if there is no relief to lay.
  bool choose_levels(const TerrainField& field, const TerrainView& eye, double above_m,
                     const ReliefSettings& settings);
  void lay(const ocl::Kernel& posts, const ocl::Buffer<float>& heights_m, const ocl::Buffer<float>& maxima_m,
           const TerrainField& field, const TerrainView& view, const LakeLayer* lakes);

  ocl::Device device_;
  ocl::KernelTuning rays_;
  std::optional<ocl::Kernel> map_posts_, tile_posts_;  // built when they are first asked for
  ocl::Kernel base_, reduce_;
  ocl::Buffer<float> heights_m_, maxima_m_;
  ocl::Buffer<TerrainReliefDisc> discs_;
  ocl::Buffer<LakeWater> no_lakes_;
  ocl::Buffer<std::uint8_t> no_cells_;
  std::vector<Material> laid_materials_;
  MaterialLayer materials_;  // these, or an unused one if there are none
  TerrainRelief params_{};
};

}  // namespace offing::terrain

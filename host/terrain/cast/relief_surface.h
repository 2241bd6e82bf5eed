#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "host/base/camera.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "host/ocl/program.h"
#include "host/ocl/tuning.h"
#include "kernels/shared/terrain.h"
#include "kernels/shared/terrain_relief.h"

namespace offing::terrain {

class HeightField;
class TiledField;

/// Ground without relief, under something that stands on it.
struct LevelDisc {
  double x_m = 0.0, z_m = 0.0;  ///< from the first post
  double radius_m = 1.0;        ///< relief begins beside it, and is whole ramp_m() farther away
  double share = 1.0;           ///< 0: relief is as elsewhere

  double ramp_m() const { return 1.5 + 0.5 * radius_m; }
  bool operator==(const LevelDisc&) const = default;
};

/// Relief of the ground between its posts, as far as pictures show it.
struct ReliefSettings {
  double strength = 1.0;                              ///< 0 none, 1 as the light on it has it
  double shore_m = -1e30;                             ///< there is none at or below this height
  double tree_line_m = 2000.0, snow_line_m = 2800.0;  ///< m; stones lie above the first
  std::vector<LevelDisc> discs = {};

  bool operator==(const ReliefSettings&) const = default;
};

/// The levels of relief of a map: their posts are spaced four times as far as those of the level before.
struct ReliefLevels {
  int count = 0;         ///< 0: its posts are too close for any
  int finest_log2 = 0;   ///< the first has 2^finest_log2 steps to a cell of the map
  double reach_m = 0.0;  ///< there is no relief farther from the eye
};
ReliefLevels relief_levels(int cells_x, int cells_z, double spacing_x_m, double spacing_z_m);

/// The ground that is drawn near an eye: the surface of a field with relief between its posts, some hundred
/// metres around. Only pictures know it; all answers are those of the field. Near a camera that is above the
/// field's surface there is none that would hide everything from it.
///
/// It is laid in up to three levels of posts around the eye, bilinear between them, the first with posts two
/// decimetres apart, and fades out with the distance, the finer octaves first (shared/terrain_relief.h).
class ReliefSurface {
 public:
  /// Throws what programs throw.
  explicit ReliefSurface(const ocl::Device& device);

  /// Enqueues the surface that a camera sees, of a field that is not kept; beside the picture it is the
  /// field's own. There is none where the eye is not over the map, or `above_m` above its ground and that too
  /// far. Throws what device_view() throws.
  void at(const HeightField& field, const Camera& camera, double above_m, const ReliefSettings& settings);
  /// The same of the tiles of the last look(). There is none where a map repeats or mirrors.
  void at(const TiledField& field, const Camera& camera, double above_m, const ReliefSettings& settings);

  /// Whether the last at() laid any; if not, the field is drawn as it is.
  bool is_laid() const { return params_.levels > 0; }
  const TerrainRelief& params() const { return params_; }
  const ocl::Buffer<float>& heights_m() const { return heights_m_; }
  const ocl::Buffer<float>& maxima_m() const { return maxima_m_; }

 private:
  /// Fills params_. False if there is no relief to lay.
  bool choose_levels(const TerrainField& field, const TerrainView& eye, double above_m,
                     const ReliefSettings& settings);
  void lay(const ocl::Kernel& posts, const ocl::Buffer<float>& heights_m, const ocl::Buffer<float>& maxima_m,
           const TerrainField& field, const TerrainView& view);

  ocl::Device device_;
  ocl::KernelTuning rays_;
  std::optional<ocl::Kernel> map_posts_, tile_posts_;  // built when they are first asked for
  ocl::Kernel base_, reduce_;
  ocl::Buffer<float> heights_m_, maxima_m_;
  ocl::Buffer<TerrainReliefDisc> discs_;
  TerrainRelief params_{};
};

}  // namespace offing::terrain

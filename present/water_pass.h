#pragma once

#include <array>
#include <string_view>

#include "host/base/camera.h"
#include "host/world/world.h"
#include "present/gl_context.h"
#include "present/gl_objects.h"
#include "present/map_texture.h"
#include "present/shader_program.h"
#include "present/transfer.h"

namespace offing::present {

/// Cells of the projected grid, across and along the line of sight.
struct GridCells {
  int columns = 128, rows = 128;
};

/// How finely the water is drawn.
struct WaterDetail {
  GridCells cells;
  /// Samples along a pixel's footprint, which is long where water is seen at a grazing angle.
  int taps = 1;
};

/// What the water shows instead of light.
enum class DebugView {
  none,
  height,
  slope,
  jacobian,
  foam,
  footprint,
  cascade_0,
  cascade_1,
  cascade_2,
  cascade_3
};
inline constexpr std::array all_debug_views{DebugView::none,      DebugView::height,    DebugView::slope,
                                            DebugView::jacobian,  DebugView::foam,      DebugView::footprint,
                                            DebugView::cascade_0, DebugView::cascade_1, DebugView::cascade_2,
                                            DebugView::cascade_3};
std::string_view to_string(DebugView view);

enum class Fill { solid, wireframe };

/// What to draw: the world as this camera sees it.
struct FrameRequest {
  Camera camera;
  double exposure = 1.0;  ///< 1 / (kcd/m2), of exposure_for()
  DebugView debug = DebugView::none;
  Fill fill = Fill::solid;
};

/// Draws the ocean's surface: a projected grid displaced by the cascades and trochoids of a world.
class WaterPass {
 public:
  WaterPass(const GlCapabilities& capabilities, WaterDetail detail);

  /// Copies the world's maps into textures by way of the ladder.
  void prepare(world::World& world, TransferLadder& transfer);
  /// Draws onto the bound target, whose depth is reversed. `environment` is the map of SkyPass.
  void draw(const world::World& world, const FrameRequest& request, GLuint environment) const;

 private:
  void set_sea(const world::World& world, const Camera& camera) const;
  void set_light(const world::World& world) const;

  GlCapabilities capabilities_;
  WaterDetail detail_;
  ShaderProgram program_;
  GlVertexArray vertices_;
  GlBuffer indices_;
  MapTexture displacement_, gradient_, foam_;
  GlTexture foam_pattern_;
};

}  // namespace offing::present

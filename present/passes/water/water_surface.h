#pragma once

#include <optional>

#include "host/base/camera.h"
#include "host/world/world.h"
#include "present/gl/gl_context.h"
#include "present/gl/gl_objects.h"
#include "present/gl/render_target.h"
#include "present/gl/shader_program.h"
#include "present/passes/frame_request.h"
#include "present/passes/water/hull_mask.h"
#include "present/passes/water/water_maps.h"
#include "present/passes/water/water_shape.h"

namespace offing::present {

/// The water as a camera sees it: the displaced grid of a WaterShape, drawn into textures that hold for each
/// pixel what its light depends on (water_surface.frag). Light is worked out from them once a pixel, however
/// small the triangles are.
class WaterSurface {
 public:
  WaterSurface(const GlCapabilities& capabilities, GridCells cells);

  /// Takes over another number of cells.
  void fit(GridCells cells);
  /// Draws onto the textures, as large as the camera's picture; false where no water is in sight.
  bool draw(const world::World& world, const WaterMaps& maps, const Camera& camera, Fill fill);

  /// What was drawn last: three textures of four floats, and reversed depth. Distance 0 is no water.
  const RenderTarget& target() const { return target_; }
  /// The rings of what was drawn last.
  const RingWaves& rings() const { return shape_.rings(); }

 private:
  void index_cells() const;

  GlCapabilities capabilities_;
  WaterShape shape_;
  HullMask hulls_;
  ShaderProgram program_;
  GlVertexArray vertices_;
  GlBuffer indices_;
  RenderTarget target_;
};

}  // namespace offing::present

#pragma once

#include <optional>

#include "host/base/camera.h"
#include "host/ocean/trochoid_instant.h"
#include "host/world/world.h"
#include "present/gl_context.h"
#include "present/gl_objects.h"
#include "present/render_target.h"
#include "present/ring_waves.h"
#include "present/shader_program.h"
#include "present/uniform_block.h"
#include "present/water_maps.h"

namespace offing::present {

/// Cells of the projected grid, across and along the line of sight.
struct GridCells {
  int columns = 128, rows = 128;
};

enum class Fill { solid, wireframe };

/// The shape of the water as a camera sees it: a projected grid displaced by the cascades and trochoids of a
/// world, drawn into textures that hold for each pixel what its light depends on (water_surface.frag). Light
/// is worked out from them once a pixel, however small the triangles are.
class WaterSurface {
 public:
  WaterSurface(const GlCapabilities& capabilities, GridCells cells);

  /// Draws onto the textures, as large as the camera's picture; false where no water is in sight.
  bool draw(const world::World& world, const WaterMaps& maps, const Camera& camera, Fill fill);

  /// What was drawn last: three textures of four floats, and reversed depth. Distance 0 is no water.
  const RenderTarget& target() const { return target_; }
  /// The rings of what was drawn last.
  const RingWaves& rings() const { return rings_; }

 private:
  void set_trochoids(const ocean::TrochoidInstant& trochoids, const Camera& camera) const;

  GlCapabilities capabilities_;
  GridCells cells_;
  ShaderProgram program_;
  GlVertexArray vertices_;
  GlBuffer indices_;
  UniformBlock trochoid_block_;
  RingWaves rings_;
  RenderTarget target_;
};

}  // namespace offing::present

#pragma once

#include <span>

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

/// Draws the ocean's surface: a projected grid displaced by the cascades and trochoids of a world.
class WaterPass {
 public:
  WaterPass(const GlCapabilities& capabilities, WaterDetail detail);

  /// Copies the world's maps into textures by way of the ladder.
  void prepare(world::World& world, TransferLadder& transfer);
  /// Draws onto the bound target, whose depth is reversed. `environment` is the map of SkyPass.
  void draw(const world::World& world, const Camera& camera, GLuint environment) const;

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

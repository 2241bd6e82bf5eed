#pragma once

#include <optional>

#include "host/base/camera.h"
#include "host/ocean/query/gerstner_instant.h"
#include "host/ocean/surface/projected_grid.h"
#include "host/world/world.h"
#include "present/gl/gl_context.h"
#include "present/gl/gl_objects.h"
#include "present/gl/render_target.h"
#include "present/gl/shader_program.h"
#include "present/gl/uniform_block.h"
#include "present/passes/frame_request.h"
#include "present/passes/water/hull_mask.h"
#include "present/passes/water/ring_waves.h"
#include "present/passes/water/water_maps.h"
#include "present/passes/water/water_uniforms.h"
#include "present/passes/water/wave_features.h"

namespace offing::present {

/// Cells of the projected grid, across and along the line of sight.
struct GridCells {
  int columns = 128, rows = 128;

  bool operator==(const GridCells&) const = default;
};

/// The vertices of a projected grid, displaced by the cascades and Gerstner waves of a world: a pixel each of
/// textures (water_shape.frag), since software renderers share out pixels among cores, but not vertices.
class WaterShape {
 public:
  explicit WaterShape(GridCells cells);

  /// Works the vertices out, [rows + 1][columns + 1], near row first.
  void draw(const world::World& world, const WaterMaps& maps, const Camera& camera,
            const ocean::ProjectedGrid& grid);
  /// Gives them to a program in use, from texture unit `first_unit` on.
  void bind(const ShaderProgram& program, int first_unit) const;

  GridCells cells() const { return cells_; }
  /// Takes over another number of cells.
  void fit(GridCells cells);
  /// The rings of what was drawn last.
  const RingWaves& rings() const { return rings_; }

 private:
  GridCells cells_;
  ShaderVariants<WaveFeatures> programs_;
  GlVertexArray no_vertices_;
  UniformBlock<glsl::WaveUniforms, glsl::ShapeUniforms> block_;
  RingWaves rings_;
  RenderTarget target_;
};

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
  UniformBlock<glsl::SurfaceUniforms> block_;
  GlVertexArray vertices_;
  GlBuffer indices_;
  RenderTarget target_;
};

}  // namespace offing::present

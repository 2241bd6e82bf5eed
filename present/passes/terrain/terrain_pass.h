#pragma once

#include "host/base/camera.h"
#include "host/world/world_terrain.h"
#include "present/gl/gl_objects.h"
#include "present/gl/shader_program.h"
#include "present/gl/texture_array.h"
#include "present/gl/transfer.h"
#include "present/gl/uniform_block.h"
#include "present/passes/layer_light.h"
#include "present/passes/terrain/terrain_uniforms.h"
#include "present/passes/view_uniforms.h"

namespace offing::present {

/// Lays the ground that OpenCL saw over the picture, pixel by pixel where it was seen as finely as the
/// picture is drawn; coarser views are enlarged without mixing what is near with what is far.
class TerrainPass {
 public:
  TerrainPass();

  /// Copies what was seen into textures.
  void prepare(const world::TerrainImage& terrain, Transfer& transfer);

  /// Pixels that ground covers, which may be drawn before what lies behind; and those that it covers in part,
  /// at its edges, which go over what lies behind.
  enum class Part { covered, edges };
  /// Draws onto the bound target, whose depth is reversed, as this camera sees it. `light` is that of edges.
  void draw(const Camera& camera, Part part, LayerLight light = LayerLight::drawn);
  /// Fills the bound target with the steps that rays took (terrain::step_colours), linear Rec.709.
  void draw_steps();

 private:
  bool is_exact(const Camera& camera) const;
  void bind(const ShaderProgram& program) const;

  ShaderProgram exact_, enlarged_, steps_;
  UniformBlock<glsl::ViewUniforms, glsl::TerrainUniforms> block_;
  GlVertexArray no_vertices_;
  TextureArray image_, planes_;
};

}  // namespace offing::present

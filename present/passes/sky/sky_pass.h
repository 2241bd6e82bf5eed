#pragma once

#include <cstdint>
#include <optional>

#include "host/base/camera.h"
#include "host/sky/clear_sky.h"
#include "present/gl/gl_objects.h"
#include "present/gl/render_target.h"
#include "present/gl/shader_program.h"
#include "present/gl/uniform_block.h"
#include "present/passes/sky/sky_uniforms.h"
#include "present/passes/view_uniforms.h"

namespace offing::present {

/// Draws the clear sky, behind everything else and into a round map that reflections read (environment.glsl).
/// It holds OpenGL's copies of the sky's tables.
class SkyPass {
 public:
  explicit SkyPass(int step_px = 1);

  /// Works out the sky's light at every `step_px`-th pixel of rows and columns, linear between them: quicker
  /// where the CPU draws, and hardly another picture (tests/present/passes/sky_pass_test.cpp).
  void set_step(int step_px);

  /// Takes over tables and parameters of this sky and draws the map of reflections, unless it has them.
  void prepare(const sky::ClearSky& sky);
  /// Fills the target, which stays bound, where its depth, reversed, is infinite.
  void draw(const Camera& camera, const RenderTarget& target);

  /// The round map, a 2-D texture of kcd/m2.
  GLuint environment() const { return environment_.texture(); }

 private:
  void bind(const ShaderProgram& program) const;
  void draw_nodes(const Camera& camera);
  void draw_sun(const Camera& camera);

  int step_px_ = 1;
  ShaderProgram sky_, sun_, map_;
  std::optional<ShaderProgram> enlarge_;  // once step_px_ has been > 1
  RenderTarget nodes_;                    // where pixels' corners (step_px_ i, step_px_ j) are
  GlVertexArray no_vertices_;
  UniformBlock<SkyParams> block_;
  UniformBlock<glsl::ViewUniforms> view_;
  UniformBlock<glsl::SkyNodesUniforms> nodes_block_;
  GlTexture view_table_, depth_table_;
  RenderTarget environment_;
  SkyParams params_{};
  std::uint64_t revision_ = 0;  // of the sky that all this is of; 0: of none
};

}  // namespace offing::present

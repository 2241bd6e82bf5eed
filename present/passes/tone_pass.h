#pragma once

#include "present/gl/gl_objects.h"
#include "present/gl/render_target.h"
#include "present/gl/shader_program.h"
#include "present/gl/uniform_block.h"
#include "present/passes/tone_uniforms.h"

namespace offing::present {

/// Turns scene-linear light into sRGB: the one place where exposure and tone mapping happen.
class TonePass {
 public:
  TonePass();
  /// The way from light to the screen; colours that are no light keep themselves.
  enum class Curve { filmic, none };
  /// Draws `picture` onto the bound target of the same size.
  void draw(const RenderTarget& picture, double exposure, Curve curve = Curve::filmic);

 private:
  ShaderProgram program_;
  UniformBlock<glsl::ToneUniforms> block_;
  GlVertexArray no_vertices_;
};

}  // namespace offing::present

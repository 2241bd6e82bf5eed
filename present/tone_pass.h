#pragma once

#include "host/sky/clear_sky.h"
#include "present/gl_objects.h"
#include "present/render_target.h"
#include "present/shader_program.h"

namespace offing::present {

/// Exposure, 1 / (kcd/m2), as a meter that catches the light at the eye sets it, and `ev` stops above.
double exposure_for(const sky::Illuminance& light, double sun_height, double ev);

/// Turns scene-linear light into sRGB: the one place where exposure and tone mapping happen.
class TonePass {
 public:
  TonePass();
  /// Draws `picture` onto the bound target of the same size.
  void draw(const RenderTarget& picture, double exposure) const;

 private:
  ShaderProgram program_;
  GlVertexArray no_vertices_;
};

}  // namespace offing::present

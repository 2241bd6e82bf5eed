#include "present/passes/tone_pass.h"

#include "present/passes/uniform_bindings.h"

namespace offing::present {

TonePass::TonePass()
    : program_({.vertex = {shader_file("screen.vert")},
                .fragment = {shader_file("tone_uniforms.h"), uniform_block("Tone", "ToneUniforms tone;"),
                             shader_file("tone.frag")}}),
      block_("Tone", pass_binding),
      no_vertices_(GlVertexArray::make()) {}

void TonePass::draw(const RenderTarget& picture, double exposure, Curve curve) {
  program_.use();
  bind_sampler(program_, "picture", 0, picture.texture());
  block_.fill({.exposure = static_cast<float>(exposure), .is_filmic = curve == Curve::filmic ? 1 : 0});
  block_.bind(program_);
  glBindVertexArray(no_vertices_.name());
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace offing::present

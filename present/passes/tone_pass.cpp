#include "present/passes/tone_pass.h"

namespace offing::present {

TonePass::TonePass()
    : program_({.vertex = {shader_file("screen.vert")}, .fragment = {shader_file("tone.frag")}}),
      no_vertices_(GlVertexArray::make()) {}

void TonePass::draw(const RenderTarget& picture, double exposure, Curve curve) const {
  program_.use();
  bind_sampler(program_, "picture", 0, picture.texture());
  program_.set("exposure", static_cast<float>(exposure));
  program_.set("is_filmic", curve == Curve::filmic ? 1 : 0);
  glBindVertexArray(no_vertices_.name());
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace offing::present

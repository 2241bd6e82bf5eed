#include "present/tone_pass.h"

namespace offing::present {

TonePass::TonePass()
    : program_({.vertex = {shader_file("screen.vert")}, .fragment = {shader_file("tone.frag")}}),
      no_vertices_(GlVertexArray::make()) {}

void TonePass::draw(const RenderTarget& picture, double exposure) const {
  program_.use();
  program_.set("picture", 0);
  program_.set("exposure", static_cast<float>(exposure));
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, picture.texture());
  glBindVertexArray(no_vertices_.name());
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace offing::present

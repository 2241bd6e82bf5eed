#include "present/tone_pass.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::present {

double exposure_for(const sky::Illuminance& light, double sun_height, double ev) {
  // A level surface of the sky's and the sun's light, diffuse and white, comes out at 1. Below this light,
  // deep dusk, pictures grow dark as the eye's do.
  constexpr double least_klx = 1e-3;
  const double level_klx =
      sky::luminance(light.sky_klx) + sky::luminance(light.sun_klx) * std::max(0.0, sun_height);
  return std::exp2(ev) * std::numbers::pi / std::max(level_klx, least_klx);
}

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

#include "present/passes/enlarge/enlarge_pass.h"

#include <epoxy/gl.h>

#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

constexpr int picture_unit = 0, edges_unit = 1;

ShaderProgram enlarge_program(const char* fragment) {
  return ShaderProgram({.vertex = {shader_file("screen.vert")}, .fragment = {shader_file(fragment)}});
}

/// As it is, or evenly made smaller or larger.
void copy_to_framebuffer(const RenderTarget& picture, GLuint framebuffer, int width, int height) {
  glBindFramebuffer(GL_READ_FRAMEBUFFER, picture.framebuffer());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  glBlitFramebuffer(0, 0, picture.width(), picture.height(), 0, 0, width, height, GL_COLOR_BUFFER_BIT,
                    GL_LINEAR);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
}

}  // namespace

void EnlargePass::draw(const RenderTarget& picture, GLuint framebuffer, int width, int height) {
  if (is_even_ || (picture.width() >= width && picture.height() >= height)) {
    copy_to_framebuffer(picture, framebuffer, width, height);
    return;
  }
  if (!programs_) {
    programs_.emplace(Programs{.edges = enlarge_program("enlarge/enlarge_edges.frag"),
                               .enlarge = enlarge_program("enlarge/enlarge.frag")});
  }
  if (edges_.width() != picture.width() || edges_.height() != picture.height())
    edges_ = RenderTarget(picture.width(), picture.height(), GL_RGBA8, RenderTarget::Depth::none);
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(no_vertices_.name());
  edges_.bind();
  programs_->edges.use();
  bind_sampler(programs_->edges, "picture", picture_unit, picture.texture());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
  glViewport(0, 0, width, height);
  programs_->enlarge.use();
  bind_sampler(programs_->enlarge, "picture", picture_unit, picture.texture());
  bind_sampler(programs_->enlarge, "edges", edges_unit, edges_.texture());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace offing::present

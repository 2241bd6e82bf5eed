#include "present/sky_pass.h"

#include <span>
#include <vector>

#include "host/sky/clear_sky_glsl.h"
#include "present/sampler.h"
#include "present/view_ray.h"

namespace offing::present {
namespace {

constexpr int environment_size = 256;  // pixels of 0.4 degrees at the horizon
constexpr GLuint sky_binding = 0;
constexpr int view_unit = 0, depth_unit = 1;

ShaderProgram sky_program(const char* fragment) {
  return ShaderProgram({.vertex = {shader_file("screen.vert")},
                        .fragment = {{"sky::clear_sky_glsl()", sky::clear_sky_glsl()},
                                     shader_file("sky_view.glsl"),
                                     shader_file("environment.glsl"),
                                     shader_file("view_ray.glsl"),
                                     shader_file(fragment)}});
}

void fill_table(const GlTexture& texture, const ocl::Buffer<sky::Texel>& table, int columns) {
  const std::vector<sky::Texel> texels = table.read();
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, columns, static_cast<GLsizei>(texels.size()) / columns, 0,
               GL_RGBA, GL_FLOAT, texels.data());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

SkyPass::SkyPass()
    : sky_(sky_program("sky.frag")),
      map_(sky_program("environment.frag")),
      no_vertices_(GlVertexArray::make()),
      block_(GlBuffer::make()),
      view_table_(GlTexture::make()),
      depth_table_(GlTexture::make()),
      environment_(environment_size, environment_size, GL_RGBA16F, RenderTarget::Depth::none) {}

void SkyPass::bind(const ShaderProgram& program) const {
  program.use();
  program.bind_block("Sky", sky_binding);
  glBindBufferBase(GL_UNIFORM_BUFFER, sky_binding, block_.name());
  bind_sampler(program, "view_table", view_unit, view_table_.name());
  bind_sampler(program, "depth_table", depth_unit, depth_table_.name());
  glBindVertexArray(no_vertices_.name());
  glDisable(GL_DEPTH_TEST);
}

void SkyPass::prepare(const sky::ClearSky& sky) {
  if (sky.revision() == revision_) return;
  glBindBuffer(GL_UNIFORM_BUFFER, block_.name());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(SkyParams), &sky.params(), GL_DYNAMIC_DRAW);
  glActiveTexture(GL_TEXTURE0);
  fill_table(view_table_, sky.view_table(), SKY_VIEW_COLUMNS);
  fill_table(depth_table_, sky.depth_table(), SKY_DEPTH_COLUMNS);
  environment_.bind();
  bind(map_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  revision_ = sky.revision();
}

void SkyPass::draw(const Camera& camera) const {
  bind(sky_);
  set_view_rays(sky_, camera);
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_EQUAL);
  glDepthRange(0.0, 0.0);
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDepthMask(GL_TRUE);
  glDepthRange(0.0, 1.0);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace offing::present

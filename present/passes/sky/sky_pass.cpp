#include "present/passes/sky/sky_pass.h"

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include <glm/common.hpp>
#include <glm/ext/vector_int2.hpp>
#include <glm/geometric.hpp>

#include "present/passes/camera_projection.h"
#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

constexpr int environment_size = 256;  // pixels of 0.4 degrees at the horizon
constexpr int view_unit = 0, depth_unit = 1;

ShaderProgram sky_program(const char* fragment) {
  return ShaderProgram({.vertex = {shader_file("screen.vert")},
                        .fragment = {{"sky::clear_sky_glsl()", sky::clear_sky_glsl()},
                                     uniform_block("Sky", "SkyParams sky;"),
                                     shader_file("view_uniforms.h"),
                                     uniform_block("View", "ViewUniforms view;"),
                                     shader_file("sky/sky_view.glsl"),
                                     shader_file("sky/environment.glsl"),
                                     shader_file("view_ray.glsl"),
                                     shader_file("sky/sky_direction.glsl"),
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

struct PixelRange {
  int left, bottom, width, height;
};

/// The pixels within this angle of a direction, as far as they are in the picture.
std::optional<PixelRange> pixels_around(const glm::dvec3& direction, double angle_rad, const Camera& camera) {
  const CameraBasis axes = basis(camera);
  const glm::dvec2 extent = half_extent(camera);
  const double ahead = glm::dot(direction, axes.forward), sine = std::sin(angle_rad);
  const PixelRange whole{0, 0, camera.width_px, camera.height_px};
  if (ahead < -sine) return std::nullopt;
  if (ahead < 1.5 * sine) return whole;  // edges of the cone may lie beside the eye
  // Tangents of where the cone's edges lie along an axis of the picture (Mara & McGuire 2013, eq. 3).
  const auto edges = [&](double across) {
    const double scale = ahead * ahead - sine * sine;
    const double root = sine * std::sqrt(across * across + scale);
    return glm::dvec2(across * ahead - root, across * ahead + root) / scale;
  };
  const auto range = [](glm::dvec2 clip, int pixels) {
    const glm::dvec2 px = glm::clamp(0.5 * (clip + 1.0), 0.0, 1.0) * static_cast<double>(pixels);
    return glm::ivec2(glm::floor(px.x), glm::ceil(px.y));
  };
  const glm::ivec2 columns = range(edges(glm::dot(direction, axes.right)) / extent.x, camera.width_px);
  const glm::ivec2 rows = range(edges(glm::dot(direction, axes.up)) / extent.y, camera.height_px);
  if (columns.x == columns.y || rows.x == rows.y) return std::nullopt;
  return PixelRange{columns.x, rows.x, columns.y - columns.x, rows.y - rows.x};
}

}  // namespace

SkyPass::SkyPass(int step_px)
    : sky_(sky_program("sky/sky.frag")),
      sun_(sky_program("sky/sun.frag")),
      map_(sky_program("sky/environment.frag")),
      no_vertices_(GlVertexArray::make()),
      block_("Sky", sky_binding),
      view_("View", pass_binding),
      nodes_block_("SkyNodes", pass_binding),
      view_table_(GlTexture::make()),
      depth_table_(GlTexture::make()),
      environment_(environment_size, environment_size, GL_RGBA16F, RenderTarget::Depth::none) {
  set_step(step_px);
}

void SkyPass::set_step(int step_px) {
  if (step_px_ == step_px) return;
  step_px_ = step_px;
  if (!enlarge_) {
    enlarge_.emplace(ShaderStages{.vertex = {shader_file("screen.vert")},
                                  .fragment = {shader_file("sky/sky_uniforms.h"),
                                               uniform_block("SkyNodes", "SkyNodesUniforms sky_nodes;"),
                                               shader_file("sky/sky_enlarged.frag")}});
  }
  nodes_block_.fill({.step_px = static_cast<float>(step_px_)});
}

void SkyPass::bind(const ShaderProgram& program) const {
  program.use();
  block_.bind(program);
  bind_sampler(program, "view_table", view_unit, view_table_.name());
  bind_sampler(program, "depth_table", depth_unit, depth_table_.name());
  glBindVertexArray(no_vertices_.name());
  glDisable(GL_DEPTH_TEST);
}

void SkyPass::prepare(const sky::ClearSky& sky) {
  if (sky.revision() == revision_) return;
  block_.fill(sky.params());
  glActiveTexture(GL_TEXTURE0);
  fill_table(view_table_, sky.view_table(), SKY_VIEW_COLUMNS);
  fill_table(depth_table_, sky.depth_table(), SKY_DEPTH_COLUMNS);
  environment_.bind();
  bind(map_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  params_ = sky.params();
  revision_ = sky.revision();
}

void SkyPass::draw_nodes(const Camera& camera) {
  const auto nodes_along = [&](int pixels) { return (pixels + step_px_ - 1) / step_px_ + 1; };
  const glm::ivec2 pixels(camera.width_px, camera.height_px);
  const glm::ivec2 nodes(nodes_along(pixels.x), nodes_along(pixels.y));
  if (glm::ivec2(nodes_.width(), nodes_.height()) != nodes)
    nodes_ = RenderTarget(nodes.x, nodes.y, GL_RGBA16F, RenderTarget::Depth::none);
  nodes_.bind();
  bind(sky_);
  // Node i lies at pixel step i: clip coordinates of the nodes' picture, scaled and shifted to the pixels'.
  const CameraBasis axes = basis(camera);
  const glm::dvec2 extent = half_extent(camera), step = 2.0 * step_px_ / glm::dvec2(pixels);
  const glm::dvec2 scale = 0.5 * step * glm::dvec2(nodes), shift = scale - 0.5 * step - 1.0;
  glsl::ViewUniforms view = view_uniforms(camera);
  view.ray_forward = axes.forward + shift.x * extent.x * axes.right + shift.y * extent.y * axes.up;
  view.ray_right = scale.x * extent.x * axes.right;
  view.ray_up = scale.y * extent.y * axes.up;
  view_.fill(view);
  view_.bind(sky_);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void SkyPass::draw(const Camera& camera, const RenderTarget& target) {
  if (step_px_ > 1) {
    draw_nodes(camera);
    target.bind();
    enlarge_->use();
    bind_sampler(*enlarge_, "nodes", view_unit, nodes_.texture());
    nodes_block_.bind(*enlarge_);
  } else {
    target.bind();
    bind(sky_);
    view_.fill(view_uniforms(camera));
    view_.bind(sky_);
  }
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_EQUAL);
  glDepthRange(0.0, 0.0);
  glDepthMask(GL_FALSE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  draw_sun(camera);
  glDepthMask(GL_TRUE);
  glDepthRange(0.0, 1.0);
  glDisable(GL_DEPTH_TEST);
}

// Apart, where it is: all pixels of the sky would pay for it, as drivers that draw on the CPU skip no
// branches.
void SkyPass::draw_sun(const Camera& camera) {
  const glm::dvec3 direction(params_.sun_direction_x, params_.sun_direction_y, params_.sun_direction_z);
  const auto box = pixels_around(direction, params_.sun_angular_radius_rad, camera);
  if (!box) return;
  bind(sun_);
  view_.fill(view_uniforms(camera));
  view_.bind(sun_);
  glEnable(GL_DEPTH_TEST);
  glEnable(GL_SCISSOR_TEST);
  glScissor(box->left, box->bottom, box->width, box->height);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
  glDisable(GL_SCISSOR_TEST);
}

}  // namespace offing::present

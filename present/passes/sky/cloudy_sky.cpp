#include "present/passes/sky/cloudy_sky.h"

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "present/passes/camera_projection.h"
#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

constexpr int side_count = 4, face_count = side_count + 1;  // the last one is the zenith's
constexpr int face_unit = 0, sky_unit = 1;
// Faces reach beyond their edges by half a pixel, so that between the outermost pixels' middles there is a
// whole face and no seam.
double reach(int face_px) {
  return face_px / (face_px - 1.0);
}

Camera face_camera(const glm::dvec3& eye_m, int face, int face_px) {
  constexpr double right_angle = 0.5 * std::numbers::pi;
  const bool is_side = face < side_count;
  return {.eye_m = eye_m,
          .yaw_rad = is_side ? face * right_angle : 0.0,
          .pitch_rad = is_side ? 0.0 : right_angle,
          .vertical_field_of_view_rad = 2.0 * std::atan(reach(face_px)),
          .width_px = face_px,
          .height_px = face_px};
}

ShaderProgram map_program() {
  return ShaderProgram(
      {.vertex = {shader_file("screen.vert")},
       .fragment = {shader_file("view_uniforms.h"), shader_file("sky/sky_uniforms.h"),
                    uniform_block("CloudySky", "ViewUniforms view; CloudySkyUniforms cloudy_sky;"),
                    shader_file("sky/environment.glsl"), shader_file("view_ray.glsl"),
                    shader_file("sky/cloudy_sky.frag")}});
}

}  // namespace

CloudySky::CloudySky(int face_px)
    : face_px_(face_px),
      program_(map_program()),
      block_("CloudySky", pass_binding),
      no_vertices_(GlVertexArray::make()) {}

void CloudySky::make_maps() {
  face_ = RenderTarget(face_px_, face_px_, GL_RGBA16F, RenderTarget::Depth::none);
  maps_ = GlTexture::make();
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, maps_.name());
  glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_RGBA16F, side_px(), side_px(), 2, 0, GL_RGBA, GL_HALF_FLOAT,
               nullptr);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
  glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
  framebuffer_ = GlFramebuffer::make();
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  constexpr std::array<GLenum, 2> layers{GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1};
  for (std::size_t i = 0; i < layers.size(); ++i) {
    glFramebufferTextureLayer(GL_FRAMEBUFFER, layers[i], maps_.name(), 0, static_cast<GLint>(i));
  }
  glDrawBuffers(layers.size(), layers.data());
}

void CloudySky::bind(int unit) const {
  if (!has_map_) return;
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D_ARRAY, maps_.name());
}

std::vector<float> CloudySky::read() const {
  std::vector<float> pixels(std::size_t{4} * static_cast<std::size_t>(side_px() * side_px()));
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glReadBuffer(GL_COLOR_ATTACHMENT1);
  glReadPixels(0, 0, side_px(), side_px(), GL_RGBA, GL_FLOAT, pixels.data());
  return pixels;
}

void CloudySky::fill_levels() const {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D_ARRAY, maps_.name());
  glGenerateMipmap(GL_TEXTURE_2D_ARRAY);
}

void CloudySky::draw_face(const ocl::Device& device, const Scenery& scenery, const glm::dvec3& eye_m,
                          int face, Transfer& transfer) {
  const Camera camera = face_camera(eye_m, face, face_px_);
  clouds_.prepare_open(device, scenery.drawn, camera, transfer);
  face_.bind();
  glClearColor(0.0f, 0.0f, 0.0f, 0.0f);
  glClear(GL_COLOR_BUFFER_BIT);
  clouds_.draw(above_level(camera, scenery.sea_level_m), scenery.air, scenery.clear_sky,
               CloudPass::AirFrom::sea);
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, side_px(), side_px());
  program_.use();
  block_.fill(view_uniforms(camera), {.reach = static_cast<float>(reach(face_px_))});
  block_.bind(program_);
  bind_sampler(program_, "clouds", face_unit, face_.texture());
  bind_sampler(program_, "clear_sky", sky_unit, scenery.clear_sky);
  glBindVertexArray(no_vertices_.name());
  glDisable(GL_DEPTH_TEST);
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void CloudySky::draw(const ocl::Device& device, const Scenery& scenery, const glm::dvec3& eye_m,
                     SkyRefresh refresh, Transfer& transfer) {
  if (!maps_) make_maps();
  if (refresh == SkyRefresh::slice && has_map_) {
    draw_face(device, scenery, eye_m, due_, transfer);
    due_ = (due_ + 1) % face_count;
  } else {
    for (int face = 0; face < face_count; ++face) draw_face(device, scenery, eye_m, face, transfer);
    has_map_ = true;
  }
  fill_levels();
}

}  // namespace offing::present

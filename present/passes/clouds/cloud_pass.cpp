#include "present/passes/clouds/cloud_pass.h"

#include <algorithm>
#include <array>
#include <cstddef>

#include "present/passes/air.h"
#include "present/passes/camera_projection.h"
#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

constexpr int cloud_environment_unit = 0, cloud_image_unit = 1, distance_unit = 2;

ShaderProgram cloud_program() {
  return ShaderProgram({.vertex = {shader_file("screen.vert")},
                        .fragment = {shader_file("view_uniforms.h"), shader_file("clouds/cloud_uniforms.h"),
                                     uniform_block("Clouds", "ViewUniforms view; CloudUniforms clouds;"),
                                     shader_file("sky/environment.glsl"), shader_file("air.glsl"),
                                     shader_file("view_ray.glsl"), shader_file("clouds/clouds.frag")}});
}

void fit_texture(TextureArray& texture, const TextureArray::Shape& shape) {
  if (texture.shape() != shape) texture = TextureArray(shape);
}

}  // namespace

CloudPass::CloudPass()
    : program_(cloud_program()), block_("Clouds", pass_binding), no_vertices_(GlVertexArray::make()) {}

void CloudPass::set_textures(const ocl::Device& device, const clouds::BillboardTextures& textures) {
  if (cloud_image_) {
    cloud_image_->set_textures(textures);
  } else {
    cloud_image_.emplace(device, textures);
  }
}

void CloudPass::fit(const ocl::Device& device, int width_px, int height_px) {
  if (!cloud_image_) cloud_image_.emplace(device, built_in_billboards());
  cloud_image_->fit(width_px, height_px);
}

void CloudPass::prepare(const ocl::Device& device, const clouds::DrawnParticles& drawn, const Camera& camera,
                        const RenderTarget& target, Transfer& transfer) {
  const int width = target.width(), height = target.height();
  fit(device, width, height);
  depth_.resize(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  target.bind();
  glReadPixels(0, 0, width, height, GL_DEPTH_COMPONENT, GL_FLOAT, depth_.data());
  cloud_image_->scene_depth().write(depth_);
  make(drawn, camera, transfer);
}

void CloudPass::prepare_open(const ocl::Device& device, const clouds::DrawnParticles& drawn,
                             const Camera& camera, Transfer& transfer) {
  fit(device, camera.width_px, camera.height_px);
  cloud_image_->scene_depth().fill(0.0f);
  make(drawn, camera, transfer);
}

void CloudPass::make(const clouds::DrawnParticles& drawn, const Camera& camera, Transfer& transfer) {
  cloud_image_->draw(drawn, camera);
  glActiveTexture(GL_TEXTURE0);
  const int width = cloud_image_->width_px(), height = cloud_image_->height_px();
  fit_texture(image_, {.width = width, .height = height, .layers = 1, .channels = 4});
  fit_texture(distance_, {.width = width, .height = height, .layers = 1, .channels = 1});
  const std::array<Upload, 2> uploads{
      {{cloud_image_->image(), &image_}, {cloud_image_->distance_m(), &distance_}}};
  transfer.upload(uploads);
}

void CloudPass::draw(const Camera& camera, const sky::Atmosphere& air, GLuint environment, AirFrom air_from,
                     LayerLight light) {
  program_.use();
  bind_sampler(program_, "environment", cloud_environment_unit, environment);
  image_.bind(cloud_image_unit);
  distance_.bind(distance_unit);
  program_.set("cloud_image", cloud_image_unit);
  program_.set("cloud_distance", distance_unit);
  const sky::Spectrum& depth = air.rayleigh_optical_depth;
  glsl::ViewUniforms view = view_uniforms(camera);
  view.haze_perm = haze_perm(air);
  block_.fill(view, {.rayleigh_depth = glm::vec3(depth[0], 0.5 * (depth[1] + depth[2]), depth[3]),
                     .aerosol_depth = static_cast<float>(air.aerosol_optical_depth),
                     .scale_heights_m = glm::vec2(air.rayleigh_scale_height_m, air.aerosol_scale_height_m),
                     .airless_m = static_cast<float>(air_from == AirFrom::sea ? std::max(-camera.eye_m.y, 0.0)
                                                                              : 0.0)});
  block_.bind(program_);
  glBindVertexArray(no_vertices_.name());
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  set_layer_blending(light);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_BLEND);
}

const clouds::BillboardTextures& built_in_billboards() {
  static const clouds::BillboardTextures textures = clouds::billboard_textures();
  return textures;
}

clouds::DrawnParticles drawn_clouds(const world::World& world) {
  const world::WorldClouds& clouds = *world.clouds();
  const auto& [x, y, z] = world.parameters().sun.sun_direction;
  return {.particles = clouds.particles(),
          .sprites = clouds.sprites(),
          .order = clouds.order(),
          .count = clouds.count(),
          .origin_m = clouds.sky_origin_m(),
          .sun_direction = {x, y, z},
          .near_m = near_m,
          .resolved = clouds.resolved()};
}

}  // namespace offing::present

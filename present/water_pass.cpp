#include "present/water_pass.h"

#include <array>
#include <numbers>
#include <utility>
#include <vector>

#include <glm/common.hpp>

#include "present/air.h"
#include "present/foam_texture.h"
#include "present/view_ray.h"
#include "present/water_light.h"

namespace offing::present {
namespace {

constexpr int environment_unit = WaterMaps::first_free_unit, pattern_unit = environment_unit + 1,
              shadow_unit = pattern_unit + 1, first_surface_unit = shadow_unit + 1,
              first_view_unit = first_surface_unit + 4;
// Waves shorter than 2 m break without drawing air under: they make no foam.
constexpr double ripples_radpm = std::numbers::pi;

ShaderProgram water_program() {
  return ShaderProgram(
      {.vertex = {shader_file("screen.vert")},
       .fragment = {CloudShadows::glsl(), shader_file("environment.glsl"), shader_file("air.glsl"),
                    shader_file("view_ray.glsl"), shader_file("water.glsl"), shader_file("rings.glsl"),
                    shader_file("wakes.glsl"), shader_file("shoals.glsl"), shader_file("fresnel.glsl"),
                    shader_file("water_light.glsl"), shader_file("caustics.glsl"),
                    shader_file("water_views.glsl"), shader_file("water_debug.glsl"),
                    shader_file("water.frag")}});
}

glm::vec3 to_vec3(const ocean::SlopeCovariance& slopes) {
  return {slopes.xx, slopes.xz, slopes.zz};
}

glm::vec3 to_vec3(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

}  // namespace

WaterPass::WaterPass(const GlCapabilities& capabilities, WaterDetail detail)
    : detail_(detail),
      surface_(capabilities, detail.cells),
      program_(water_program()),
      no_vertices_(GlVertexArray::make()),
      foam_pattern_(foam_texture()) {}

void WaterPass::set_waves(const world::World& world, const Camera& camera) const {
  const ocean::OceanParameters& sea = world.parameters().ocean;
  const glm::dvec2 eye_m(camera.eye_m.x, camera.eye_m.z);
  maps_.bind(program_, world, eye_m);
  surface_.rings().bind(program_);
  std::vector<glm::vec4> hidden;
  std::vector<float> breaking;
  for (std::size_t i = 0; i < sea.cascades.size(); ++i) {
    breaking.push_back(sea.cascades[i].k_min_radpm < ripples_radpm ? 1.0f : 0.0f);
    for (const ocean::SlopeCovariance& level : world.hidden_slopes().cascades[i]) {
      hidden.emplace_back(to_vec3(level), 0.0f);
    }
  }
  program_.set("hidden_slopes", hidden);
  program_.set("level_count", static_cast<int>(hidden.size() / sea.cascades.size()));
  program_.set("ripples", to_vec3(world.hidden_slopes().ripples));
  program_.set("trochoid_slopes", to_vec3(world.hidden_slopes().trochoids));
  program_.set("tap_count", detail_.taps);
  program_.set("breaking", breaking);
  program_.set("foam_onset", glm::vec2(sea.foam.onset_jacobian, sea.foam.width));
  const glm::dvec2 foam_place = eye_m / static_cast<double>(foam_tile_m);
  program_.set("foam_place", glm::vec2(foam_place - glm::floor(foam_place / 100.0) * 100.0));
  program_.set("foam_tile_m", foam_tile_m);
}

void WaterPass::set_light(const world::World& world) const {
  const sky::Illuminance& light = world.illuminance();
  const auto& sun = world.sky().params();
  const WaterLight water = water_light(world);
  program_.set("sun_direction", glm::vec3(sun.sun_direction_x, sun.sun_direction_y, sun.sun_direction_z));
  program_.set("sun_radius_rad", sun.sun_angular_radius_rad);
  program_.set("sun_klx", to_vec3(light.sun_klx));
  program_.set("sky_klx", to_vec3(light.sky_klx));
  program_.set("water_of_sky_kcdpm2", water.of_sky_kcdpm2);
  program_.set("water_of_sun_kcdpm2", water.of_sun_kcdpm2);
  program_.set("attenuation_perm", water.attenuation_perm);
}

void WaterPass::bind_surface() const {
  const RenderTarget& surface = surface_.target();
  const std::array<std::pair<const char*, GLuint>, 4> textures{{{"place_of", surface.texture(0)},
                                                                {"facet_of", surface.texture(1)},
                                                                {"strain_of", surface.texture(2)},
                                                                {"depth_of", surface.depth_texture()}}};
  int unit = first_surface_unit;
  for (const auto& [name, texture] : textures) {
    bind_sampler(program_, name, unit++, texture);
  }
}

void WaterPass::draw(world::World& world, const FrameRequest& request, const DryPasses& dry,
                     const RenderTarget& target, TransferLadder& transfer) {
  if (!surface_.draw(world, maps_, request.camera, request.fill)) return;
  views_.draw(world, request, detail_.views_px, dry, transfer);
  target.bind();
  program_.use();
  set_view_rays(program_, request.camera);
  set_waves(world, request.camera);
  set_light(world);
  bind_surface();
  set_air(program_, world.parameters().atmosphere, dry.environment, environment_unit);
  dry.shadows.bind(program_, shadow_unit);
  views_.bind(program_, first_view_unit);
  bind_sampler(program_, "foam_pattern", pattern_unit, foam_pattern_.name());
  program_.set("eye_height_m", static_cast<float>(request.camera.eye_m.y));
  program_.set("debug_view", static_cast<int>(request.debug));
  program_.set("debug_white", static_cast<float>(1.0 / request.exposure));
  program_.set("debug_height_m", static_cast<float>(0.5 * world.reach().vertical_m));

  // The shader gives the surface's depth, so that water hides what lies behind it and is hidden by what is
  // before it.
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace offing::present

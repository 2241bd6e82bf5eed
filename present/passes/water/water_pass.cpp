#include "present/passes/water/water_pass.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <numbers>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "present/passes/air.h"
#include "present/passes/camera_projection.h"
#include "present/passes/water/foam_texture.h"
#include "present/passes/water/water_light.h"

namespace offing::present {
namespace {

constexpr int environment_unit = WaterMaps::first_free_unit, pattern_unit = environment_unit + 1,
              shadow_unit = pattern_unit + 1, first_surface_unit = shadow_unit + 1,
              first_view_unit = first_surface_unit + 4;
// Waves shorter than 2 m break without drawing air under: they make no foam.
constexpr double ripples_radpm = std::numbers::pi;

/// Share of the foam of steep waves that a wind leaves: whitecaps begin at 3.7 m/s (Callaghan and others
/// 2008), calmer seas break without drawing air under, however steep.
double whitecap_share(double wind_speed_mps) {
  constexpr double first_mps = 3.7, all_mps = 6.0;
  return glm::smoothstep(first_mps, all_mps, wind_speed_mps);
}

glm::vec3 to_vec3(const ocean::SlopeCovariance& slopes) {
  return {slopes.xx, slopes.xz, slopes.zz};
}

glm::vec3 to_vec3(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

void set_light(const ShaderProgram& program, const world::World& world) {
  const sky::Illuminance& light = world.illuminance();
  const auto& sun = world.sky().params();
  const WaterLight water = water_light(world);
  program.set("sun_direction", glm::vec3(sun.sun_direction_x, sun.sun_direction_y, sun.sun_direction_z));
  program.set("sun_radius_rad", sun.sun_angular_radius_rad);
  program.set("sun_klx", to_vec3(light.sun_klx));
  program.set("sky_klx", to_vec3(light.sky_klx));
  program.set("water_of_sky_kcdpm2", water.of_sky_kcdpm2);
  program.set("water_of_sun_kcdpm2", water.of_sun_kcdpm2);
  program.set("attenuation_perm", water.attenuation_perm);
}

}  // namespace

WaterPass::WaterPass(const GlCapabilities& capabilities, WaterDetail detail)
    : detail_(detail),
      surface_(capabilities, detail.cells),
      programs_(program_for),
      no_vertices_(GlVertexArray::make()),
      foam_pattern_(foam_texture()) {}

ShaderProgram WaterPass::program_for(const Features& features) {
  const ShaderPart compiled_for{"features of the water",
                                fmt::format("#define TAPS {}\n#define WATER_SHOW {:d}\n#define MIRRORS {:d}\n"
                                            "#define MIRRORS_THINGS {:d}\n#define SHOWS_BENEATH {:d}\n",
                                            features.taps, static_cast<int>(features.debug), features.mirrors,
                                            features.mirrors_things, features.shows_beneath)};
  std::vector<ShaderPart> fragment{compiled_for, CloudShadows::glsl(), shader_file("sky/environment.glsl")};
  if (features.has_clouds) fragment.push_back(shader_file("sky/cloudy_sky.glsl"));
  for (const char* name : {"air.glsl", "view_ray.glsl"}) fragment.push_back(shader_file(name));
  std::ranges::move(wave_shaders(features.waves), std::back_inserter(fragment));
  for (const char* name : {"water/fresnel.glsl", "water/water_light.glsl", "water/caustics.glsl",
                           "water/water_views.glsl", "water/water_debug.glsl", "water/water.frag"})
    fragment.push_back(shader_file(name));
  return ShaderProgram({.vertex = {shader_file("screen.vert")}, .fragment = std::move(fragment)});
}

void WaterPass::set_waves(const ShaderProgram& program, const world::World& world,
                          const Camera& camera) const {
  const ocean::OceanParameters& sea = world.parameters().ocean;
  const glm::dvec2 eye_m(camera.eye_m.x, camera.eye_m.z);
  maps_.bind(program, world, eye_m);
  surface_.rings().bind(program);
  std::vector<glm::vec4> hidden;
  std::vector<float> breaking;
  for (std::size_t i = 0; i < sea.cascades.size(); ++i) {
    breaking.push_back(sea.cascades[i].k_min_radpm < ripples_radpm ? 1.0f : 0.0f);
    for (const ocean::SlopeCovariance& level : world.hidden_slopes().cascades[i]) {
      hidden.emplace_back(to_vec3(level), 0.0f);
    }
  }
  program.set("hidden_slopes", hidden);
  program.set("level_count", static_cast<int>(hidden.size() / sea.cascades.size()));
  program.set("ripples", to_vec3(world.hidden_slopes().ripples));
  program.set("gerstner_slopes", to_vec3(world.hidden_slopes().gerstner_waves));
  program.set("breaking", breaking);
  program.set("whitecaps", static_cast<float>(whitecap_share(world.parameters().wind.wind_speed_mps)));
  program.set("foam_onset", glm::vec2(sea.foam.onset_jacobian, sea.foam.width));
  const glm::dvec2 foam_place = eye_m / static_cast<double>(foam_tile_m);
  program.set("foam_place", glm::vec2(foam_place - glm::floor(foam_place / 100.0) * 100.0));
  program.set("foam_tile_m", foam_tile_m);
}

void WaterPass::bind_surface(const ShaderProgram& program) const {
  const RenderTarget& surface = surface_.target();
  const std::array<std::pair<const char*, GLuint>, 4> textures{{{"place_of", surface.texture(0)},
                                                                {"facet_of", surface.texture(1)},
                                                                {"strain_of", surface.texture(2)},
                                                                {"depth_of", surface.depth_texture()}}};
  int unit = first_surface_unit;
  for (const auto& [name, texture] : textures) {
    bind_sampler(program, name, unit++, texture);
  }
}

void WaterPass::draw(world::World& world, const FrameRequest& request, const DryPasses& dry,
                     const RenderTarget& target, Transfer& transfer) {
  constexpr int least_cells = 16, least_views_px = 32;
  const Quality& quality = request.quality;
  surface_.fit({share_of(detail_.cells.columns, quality.grid_share, least_cells),
                share_of(detail_.cells.rows, quality.grid_share, least_cells)});
  if (!surface_.draw(world, maps_, request.camera, request.fill)) return;
  views_.draw(world, request, share_of(detail_.views_px, quality.views_share, least_views_px), dry, transfer);
  target.bind();
  const ShaderProgram& program = programs_.with({.waves = wave_features(world, surface_.rings()),
                                                 .taps = detail_.taps,
                                                 .debug = request.debug,
                                                 .mirrors = views_.has_mirrored(),
                                                 .mirrors_things = views_.has_mirrored_things(),
                                                 .shows_beneath = views_.has_beneath(),
                                                 .has_clouds = dry.cloudy_sky.has_map()});
  program.use();
  set_view_rays(program, request.camera);
  set_waves(program, world, request.camera);
  set_light(program, world);
  bind_surface(program);
  set_air(program, world.parameters().atmosphere, dry.environment, environment_unit);
  dry.cloudy_sky.bind(environment_unit);
  dry.shadows.bind(program, shadow_unit);
  views_.bind(program, first_view_unit);
  bind_sampler(program, "foam_pattern", pattern_unit, foam_pattern_.name());
  program.set("eye_height_m", static_cast<float>(request.camera.eye_m.y));
  program.set("debug_white", static_cast<float>(1.0 / request.exposure));
  program.set("debug_height_m", static_cast<float>(0.5 * world.reach().vertical_m));

  // The shader gives the surface's depth, so that water hides what lies behind it and is hidden by what is
  // before it.
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_GREATER);
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisable(GL_DEPTH_TEST);
}

}  // namespace offing::present

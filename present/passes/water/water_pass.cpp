#include "present/passes/water/water_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <iterator>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "host/ocean/ocean_limits.h"
#include "present/passes/air.h"
#include "present/passes/camera_projection.h"
#include "present/passes/uniform_bindings.h"
#include "present/passes/water/foam_texture.h"
#include "present/passes/water/water_light.h"

namespace offing::present {
namespace {

constexpr int water_environment_unit = WaterMaps::first_free_unit, pattern_unit = water_environment_unit + 1,
              shadow_unit = pattern_unit + 1, first_surface_unit = shadow_unit + 1,
              first_view_unit = first_surface_unit + 3,
              ground_unit = first_view_unit + WaterViews::unit_count;
static_assert(ground_unit < 16, "OpenGL 3.3 promises no more units");
static_assert(glsl::most_cascades == ocean::most_cascades &&
              1 << (glsl::most_levels - 1) == ocean::largest_size);
glm::vec3 to_vec3(const ocean::SlopeCovariance& slopes) {
  return {slopes.xx, slopes.xz, slopes.zz};
}

glm::vec3 to_vec3(const std::array<double, 3>& values) {
  return {values[0], values[1], values[2]};
}

void set_light(const world::World& world, glsl::WaterUniforms& uniforms) {
  const sky::Illuminance& light = world.illuminance();
  const auto& sun = world.sky().params();
  const WaterLight water = water_light(world);
  uniforms.sun_direction = {sun.sun_direction_x, sun.sun_direction_y, sun.sun_direction_z};
  uniforms.sun_radius_rad = sun.sun_angular_radius_rad;
  uniforms.sun_klx = to_vec3(light.sun_klx);
  uniforms.sky_klx = to_vec3(light.sky_klx);
  uniforms.water_of_sky_kcdpm2 = water.of_sky_kcdpm2;
  uniforms.water_of_sun_kcdpm2 = water.of_sun_kcdpm2;
  uniforms.attenuation_perm = water.attenuation_perm;
}

glm::dvec2 within_100_tiles(const glm::dvec2& place) {
  return place - glm::floor(place / 100.0) * 100.0;
}

/// Thin foam lies in streaks along a strong wind: their tile is drawn out, six times in a gale.
void set_foam_pattern(const ocean::Wind& wind, const Camera& camera, glsl::WaterUniforms& uniforms) {
  constexpr double tile_m = foam_tile_m, wide_tile_m = 4.0 * tile_m;
  constexpr double first_streaks_mps = 8.0, gale_mps = 20.0, drawn_out = 6.0;
  const double streaks = glm::smoothstep(first_streaks_mps, gale_mps, wind.wind_speed_mps);
  const double long_tile_m = wide_tile_m * glm::mix(1.0, drawn_out, streaks);
  const double cosine = std::cos(wind.wind_direction_rad), sine = std::sin(wind.wind_direction_rad);
  const glm::dvec2 eye_m(camera.eye_m.x, camera.eye_m.z);
  const glm::dvec2 x(cosine / long_tile_m, -sine / wide_tile_m), z(sine / long_tile_m, cosine / wide_tile_m);
  uniforms.foam_place = within_100_tiles(eye_m / tile_m);
  uniforms.foam_tile_m = foam_tile_m;
  uniforms.streak_place = within_100_tiles(eye_m.x * x + eye_m.y * z);
  uniforms.streak_x = x;
  uniforms.streak_z = z;
  uniforms.streak_share = static_cast<float>(glm::mix(0.35, 0.7, streaks));
}

void set_waves(world::World& world, const Camera& camera, glsl::WaterUniforms& uniforms) {
  const ocean::OceanParameters& sea = world.parameters().ocean;
  const int cascades = std::min(static_cast<int>(sea.cascades.size()), glsl::most_cascades);
  int hidden = 0;
  for (int i = 0; i < cascades; ++i) {
    const auto cascade = static_cast<std::size_t>(i);
    const ocean::FoamGathering gathering = world.ocean().foam_gathering()[cascade];
    uniforms.foam_factor[i] =
        world.ocean().foam_onset().cascades[cascade].mean > 0.0 ? static_cast<float>(gathering.factor) : 0.0f;
    uniforms.foam_steepness[i] = static_cast<float>(gathering.steepness);
    uniforms.foam_variance[i] = static_cast<float>(gathering.variance);
    for (const ocean::SlopeCovariance& level : world.hidden_slopes().cascades[cascade]) {
      uniforms.hidden_slopes[hidden++] = {to_vec3(level), 0.0f};
    }
  }
  uniforms.level_count = hidden / cascades;
  uniforms.ripples = to_vec3(world.hidden_slopes().ripples);
  uniforms.gerstner_slopes = to_vec3(world.hidden_slopes().gerstner_waves);
  uniforms.gerstner_compression = static_cast<float>(ocean::compression_variance(sea.gerstner_waves));
  set_foam_pattern(world.parameters().wind, camera, uniforms);
}

ShaderProgram screen_program(const char* fragment) {
  return ShaderProgram({.vertex = {shader_file("screen.vert")}, .fragment = {shader_file(fragment)}});
}

}  // namespace

WaterPass::WaterPass(const GlCapabilities& capabilities, WaterDetail detail)
    : detail_(detail),
      surface_(capabilities, detail.cells),
      programs_(program_for),
      block_("Water", pass_binding),
      no_vertices_(GlVertexArray::make()),
      foam_pattern_(foam_texture()),
      ground_(screen_program("water/water_ground.frag")),
      depth_(screen_program("water/water_depth.frag")),
      mask_(screen_program("water/water_mask.frag")),
      masked_(GlFramebuffer::make()) {}

ShaderProgram WaterPass::program_for(const Features& features) {
  const ShaderPart compiled_for{
      "features of the water",
      fmt::format("#define TAPS {}\n#define WATER_SHOW {:d}\n#define MIRRORS {:d}\n"
                  "#define MIRRORS_THINGS {:d}\n#define MIRRORS_FINELY {:d}\n#define SHOWS_BENEATH {:d}\n"
                  "#define FOAM_VALUE_LIMIT {:.1f}\n",
                  features.taps, static_cast<int>(features.debug), features.mirrors, features.mirrors_things,
                  features.mirrors_finely, features.shows_beneath, foam_value_limit)};
  std::vector<ShaderPart> fragment =
      water_uniforms("Water", "ViewUniforms view; WaveUniforms waves; WaterUniforms water;");
  for (const ShaderPart& part : {compiled_for, CloudShadows::glsl(), shader_file("sky/environment.glsl")})
    fragment.push_back(part);
  if (features.has_clouds) fragment.push_back(shader_file("sky/cloudy_sky.glsl"));
  for (const char* name : {"air.glsl", "view_ray.glsl"}) fragment.push_back(shader_file(name));
  std::ranges::move(wave_shaders(features.waves), std::back_inserter(fragment));
  for (const char* name : {"water/fresnel.glsl", "water/water_light.glsl", "water/caustics.glsl",
                           "water/water_views.glsl", "water/water_debug.glsl", "water/water.frag"})
    fragment.push_back(shader_file(name));
  return ShaderProgram({.vertex = {shader_file("screen.vert")}, .fragment = std::move(fragment)});
}

void WaterPass::bind_surface(const ShaderProgram& program) const {
  const RenderTarget& surface = surface_.target();
  const std::array<std::pair<const char*, GLuint>, 3> textures{{{"place_of", surface.texture(0)},
                                                                {"facet_of", surface.texture(1)},
                                                                {"strain_of", surface.texture(2)}}};
  int unit = first_surface_unit;
  for (const auto& [name, texture] : textures) {
    bind_sampler(program, name, unit++, texture);
  }
}

void WaterPass::keep_ground(const RenderTarget& target) {
  constexpr int light_unit = 0, depth_unit = 1;
  if (ground_target_.width() != target.width() || ground_target_.height() != target.height()) {
    ground_target_ = RenderTarget(target.width(), target.height(), GL_RGBA32F, RenderTarget::Depth::none);
  }
  ground_target_.bind();
  glBindVertexArray(no_vertices_.name());
  ground_.use();
  bind_sampler(ground_, "shown_light", light_unit, target.texture());
  bind_sampler(ground_, "shown_depth", depth_unit, target.depth_texture());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void WaterPass::draw_mask(const RenderTarget& target) {
  constexpr int depth_unit = 0, shown_unit = 1;
  if (mask_target_.width() != target.width() || mask_target_.height() != target.height()) {
    mask_target_ =
        RenderTarget(target.width(), target.height(), GL_R8, RenderTarget::Depth::single_precision);
  }
  glBindVertexArray(no_vertices_.name());
  glEnable(GL_DEPTH_TEST);
  glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_FALSE);
  // Water hides what lies behind it and is hidden by what is before it.
  target.bind();
  glDepthFunc(GL_GREATER);
  depth_.use();
  bind_sampler(depth_, "depth_of", depth_unit, surface_.target().depth_texture());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  mask_target_.bind();
  glDepthFunc(GL_ALWAYS);
  mask_.use();
  bind_sampler(mask_, "depth_of", depth_unit, surface_.target().depth_texture());
  bind_sampler(mask_, "shown_depth", shown_unit, target.depth_texture());
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
  glDisable(GL_DEPTH_TEST);
}

// In bands, between which somebody may ask for another picture: this takes longest where the CPU draws.
bool WaterPass::fill(const FrameRequest& request, int height_px) {
  const int bands = request.goes_on ? std::min(height_px, 16) : 1;
  glEnable(GL_SCISSOR_TEST);
  bool goes_on = true;
  for (int band = 0; goes_on && band < bands; ++band) {
    const int bottom = height_px * band / bands, top = height_px * (band + 1) / bands;
    glScissor(0, bottom, request.camera.width_px, top - bottom);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    goes_on = request.is_wanted();
  }
  glDisable(GL_SCISSOR_TEST);
  return goes_on;
}

bool WaterPass::draw(world::World& world, const FrameRequest& request, const DryPasses& dry,
                     const RenderTarget& target, Transfer& transfer) {
  constexpr int least_cells = 16, least_views_px = 32;
  const Quality& quality = request.quality;
  surface_.fit({share_of(detail_.cells.columns, quality.grid_share, least_cells),
                share_of(detail_.cells.rows, quality.grid_share, least_cells)});
  if (!surface_.draw(world, maps_, request.camera, request.fill)) return true;
  views_.draw(world, request, share_of(detail_.views_px, quality.views_share, least_views_px), dry, transfer);
  if (!request.is_wanted()) return false;
  if (views_.has_beneath()) keep_ground(target);
  draw_mask(target);
  const ShaderProgram& program = programs_.with({.waves = wave_features(world, surface_.rings()),
                                                 .taps = detail_.taps,
                                                 .debug = request.debug,
                                                 .mirrors = views_.has_mirrored(),
                                                 .mirrors_things = views_.has_mirrored_things(),
                                                 .mirrors_finely = quality.mirrors_finely,
                                                 .shows_beneath = views_.has_beneath(),
                                                 .has_clouds = dry.cloudy_sky.has_map()});
  program.use();
  glsl::ViewUniforms view = view_uniforms(above_level(request.camera, world.sea_level_m()));
  view.white_kcdpm2 = static_cast<float>(1.0 / request.exposure);
  view.haze_perm = haze_perm(world.parameters().atmosphere);
  glsl::WaterUniforms water{};
  water.debug_height_m = static_cast<float>(0.5 * world.reach().vertical_m);
  set_waves(world, request.camera, water);
  set_light(world, water);
  views_.describe(water);
  block_.fill(view, maps_.waves(world, {request.camera.eye_m.x, request.camera.eye_m.z}), water);
  block_.bind(program);
  maps_.bind(program);
  surface_.rings().bind(program);
  bind_surface(program);
  bind_sampler(program, "environment", water_environment_unit, dry.environment);
  dry.cloudy_sky.bind(water_environment_unit);
  dry.shadows.bind(program, shadow_unit);
  views_.bind(program, first_view_unit);
  bind_sampler(program, "shown_ground", ground_unit, views_.has_beneath() ? ground_target_.texture() : 0);
  bind_sampler(program, "foam_pattern", pattern_unit, foam_pattern_.name());

  // On the pixels that show water alone: those of the mask.
  glBindFramebuffer(GL_FRAMEBUFFER, masked_.name());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target.texture(), 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, mask_target_.depth_texture(), 0);
  glViewport(0, 0, target.width(), target.height());
  glEnable(GL_DEPTH_TEST);
  glDepthFunc(GL_LESS);
  glDepthRange(0.5, 0.5);
  glDepthMask(GL_FALSE);
  glBindVertexArray(no_vertices_.name());
  const bool is_whole = fill(request, target.height());
  glDepthMask(GL_TRUE);
  glDepthRange(0.0, 1.0);
  glDisable(GL_DEPTH_TEST);
  target.bind();
  return is_whole;
}

}  // namespace offing::present

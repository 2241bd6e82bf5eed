#include "present/passes/water/underwater_pass.h"

#include <utility>
#include <vector>

#include "present/passes/air.h"
#include "present/passes/camera_projection.h"
#include "present/passes/uniform_bindings.h"
#include "present/passes/water/water_light.h"
#include "present/passes/water/wave_features.h"

namespace offing::present {
namespace {

constexpr int underwater_environment_unit = 0, light_unit = 1, underwater_depth_unit = 2;

}  // namespace

UnderwaterPass::UnderwaterPass()
    : programs_(program_for), block_("Underwater", pass_binding), no_vertices_(GlVertexArray::make()) {}

ShaderProgram UnderwaterPass::program_for(Sky sky) {
  std::vector<ShaderPart> fragment =
      water_uniforms("Underwater", "ViewUniforms view; UnderwaterUniforms underwater;");
  fragment.push_back(shader_file("sky/environment.glsl"));
  if (sky == Sky::cloudy) fragment.push_back(shader_file("sky/cloudy_sky.glsl"));
  for (const char* name : {"air.glsl", "view_ray.glsl", "water/fresnel.glsl", "water/underwater.frag"}) {
    fragment.push_back(shader_file(name));
  }
  return ShaderProgram({.vertex = {shader_file("screen.vert")}, .fragment = std::move(fragment)});
}

void UnderwaterPass::draw(const world::World& world, const Camera& camera, const Dry& dry,
                          const RenderTarget& target) {
  target.bind();
  const ShaderProgram& program = programs_.with(dry.cloudy_sky.has_map() ? Sky::cloudy : Sky::clear);
  program.use();
  bind_sampler(program, "environment", underwater_environment_unit, dry.environment);
  dry.cloudy_sky.bind(underwater_environment_unit);
  bind_sampler(program, "dry_light", light_unit, dry.light.texture());
  bind_sampler(program, "dry_depth", underwater_depth_unit, dry.light.depth_texture());
  const WaterLight light = water_light(world);
  glsl::ViewUniforms view = view_uniforms(above_level(camera, world.sea_level_m()));
  view.haze_perm = haze_perm(world.parameters().atmosphere);
  block_.fill(view, {.attenuation_perm = light.attenuation_perm,
                     .deep_kcdpm2 = (light.of_sky_kcdpm2 + light.of_sun_kcdpm2) / water_leaving_share});
  block_.bind(program);
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace offing::present

#include "present/passes/water/underwater_pass.h"

#include <utility>
#include <vector>

#include "present/passes/air.h"
#include "present/passes/camera_projection.h"
#include "present/passes/water/water_light.h"

namespace offing::present {
namespace {

constexpr int environment_unit = 0, light_unit = 1, depth_unit = 2;

}  // namespace

UnderwaterPass::UnderwaterPass() : programs_(program_for), no_vertices_(GlVertexArray::make()) {}

ShaderProgram UnderwaterPass::program_for(Sky sky) {
  std::vector<ShaderPart> fragment{shader_file("sky/environment.glsl")};
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
  set_view_rays(program, camera);
  set_air(program, world.parameters().atmosphere, dry.environment, environment_unit);
  dry.cloudy_sky.bind(environment_unit);
  bind_sampler(program, "dry_light", light_unit, dry.light.texture());
  bind_sampler(program, "dry_depth", depth_unit, dry.light.depth_texture());
  const WaterLight light = water_light(world);
  program.set("attenuation_perm", light.attenuation_perm);
  program.set("deep_kcdpm2", (light.of_sky_kcdpm2 + light.of_sun_kcdpm2) / water_leaving_share);
  program.set("view_near_m", static_cast<float>(near_m));
  program.set("depth_m", static_cast<float>(-camera.eye_m.y));
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace offing::present

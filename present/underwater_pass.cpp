#include "present/underwater_pass.h"

#include "present/air.h"
#include "present/sampler.h"
#include "present/view_depth.h"
#include "present/view_ray.h"
#include "present/water_light.h"

namespace offing::present {
namespace {

constexpr int environment_unit = 0, light_unit = 1, depth_unit = 2;

ShaderProgram underwater_program() {
  return ShaderProgram(
      {.vertex = {shader_file("screen.vert")},
       .fragment = {shader_file("environment.glsl"), shader_file("air.glsl"), shader_file("view_ray.glsl"),
                    shader_file("fresnel.glsl"), shader_file("underwater.frag")}});
}

}  // namespace

UnderwaterPass::UnderwaterPass() : program_(underwater_program()), no_vertices_(GlVertexArray::make()) {}

void UnderwaterPass::draw(const world::World& world, const Camera& camera, GLuint environment,
                          const RenderTarget& dry, const RenderTarget& target) const {
  target.bind();
  program_.use();
  set_view_rays(program_, camera);
  set_air(program_, world.parameters().atmosphere, environment, environment_unit);
  bind_sampler(program_, "dry_light", light_unit, dry.texture());
  bind_sampler(program_, "dry_depth", depth_unit, dry.depth_texture());
  const WaterLight light = water_light(world);
  program_.set("attenuation_perm", light.attenuation_perm);
  program_.set("deep_kcdpm2", (light.of_sky_kcdpm2 + light.of_sun_kcdpm2) / water_leaving_share);
  program_.set("view_near_m", static_cast<float>(near_m));
  program_.set("depth_m", static_cast<float>(-camera.eye_m.y));
  glDisable(GL_DEPTH_TEST);
  glBindVertexArray(no_vertices_.name());
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

}  // namespace offing::present

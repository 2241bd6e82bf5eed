#include "present/passes/clouds/cloud_shadows.h"

#include <vector>

#include "host/ocl/program_source.h"
#include "present/passes/uniform_bindings.h"

namespace offing::present {
namespace {

void fill(const GlTexture& texture, int size, const void* texels) {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size, size, 0, GL_RGBA, GL_FLOAT, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

CloudShadows::CloudShadows() : block_("CloudShadow", cloud_shadow_binding), map_(GlTexture::make()) {
  fill(map_, 1, nullptr);
}

ShaderPart CloudShadows::glsl() {
  return {"clouds/cloud_shadow.clh",
          ocl::glsl_source("clouds/cloud_shadow.clh") +
              uniform_block("CloudShadow", "CloudShadowParams cloud_shadow;").text +
              R"(
uniform sampler2D cloud_shadow_map;
float cloud_share(vec3 place_m) { return cloud_shadow_share(cloud_shadow, cloud_shadow_map, place_m); }
)"};
}

void CloudShadows::prepare(const world::World& world, const glm::dvec3& eye_m) {
  const world::WorldClouds* clouds = world.clouds();
  const clouds::CloudShadowMap* shadow = clouds != nullptr ? clouds->shadow() : nullptr;
  block_.fill(shadow != nullptr ? clouds->shadow_about(eye_m) : CloudShadowParams{});
  if (shadow == nullptr || shadow->revision() == revision_) return;
  const std::vector<clouds::CloudShadowMap::Texel> texels = shadow->map().read();
  fill(map_, CLOUD_SHADOW_SIZE, texels.data());
  revision_ = shadow->revision();
}

void CloudShadows::bind(const ShaderProgram& program, int unit) const {
  block_.bind(program);
  bind_sampler(program, "cloud_shadow_map", unit, map_.name());
}

}  // namespace offing::present

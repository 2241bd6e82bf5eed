#include "present/passes/clouds/cloud_shadows.h"

#include <vector>

#include "host/ocl/program_source.h"

namespace offing::present {
namespace {

constexpr GLuint shadow_binding = 3;

void fill(const GlTexture& texture, int size, const void* texels) {
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture.name());
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, size, size, 0, GL_RGBA, GL_FLOAT, texels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
}

}  // namespace

CloudShadows::CloudShadows() : block_(GlBuffer::make()), map_(GlTexture::make()) {
  fill(map_, 1, nullptr);
}

ShaderPart CloudShadows::glsl() {
  return {"clouds/cloud_shadow.clh", ocl::glsl_source("clouds/cloud_shadow.clh") + R"(
layout(std140) uniform CloudShadow { CloudShadowParams cloud_shadow; };
uniform sampler2D cloud_shadow_map;
float cloud_share(vec3 place_m) { return cloud_shadow_share(cloud_shadow, cloud_shadow_map, place_m); }
)"};
}

void CloudShadows::prepare(const world::World& world, const glm::dvec3& eye_m) {
  const world::WorldClouds* clouds = world.clouds();
  const clouds::CloudShadowMap* shadow = clouds != nullptr ? clouds->shadow() : nullptr;
  const CloudShadowParams params = shadow != nullptr ? clouds->shadow_about(eye_m) : CloudShadowParams{};
  glBindBuffer(GL_UNIFORM_BUFFER, block_.name());
  glBufferData(GL_UNIFORM_BUFFER, sizeof(params), &params, GL_DYNAMIC_DRAW);
  if (shadow == nullptr || shadow->revision() == revision_) return;
  const std::vector<clouds::CloudShadowMap::Texel> texels = shadow->map().read();
  fill(map_, CLOUD_SHADOW_SIZE, texels.data());
  revision_ = shadow->revision();
}

void CloudShadows::bind(const ShaderProgram& program, int unit) const {
  program.bind_block("CloudShadow", shadow_binding);
  glBindBufferBase(GL_UNIFORM_BUFFER, shadow_binding, block_.name());
  bind_sampler(program, "cloud_shadow_map", unit, map_.name());
}

}  // namespace offing::present

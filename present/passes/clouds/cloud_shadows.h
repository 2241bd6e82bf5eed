#pragma once

#include <cstdint>

#include <glm/vec3.hpp>

#include "host/world/world.h"
#include "present/gl/gl_objects.h"
#include "present/gl/shader_program.h"
#include "present/gl/uniform_block.h"

namespace offing::present {

/// The shadow that a world's clouds throw, for shaders that begin with glsl().
class CloudShadows {
 public:
  CloudShadows();

  /// What shaders read it with: cloud_share(place_m), the share of the sun's light that clouds let through to
  /// a place relative to the eye.
  static ShaderPart glsl();

  /// Copies the shadow of the world as it stands, for this eye.
  void prepare(const world::World& world, const glm::dvec3& eye_m);
  /// Gives it to a program in use, by this texture unit.
  void bind(const ShaderProgram& program, int unit) const;

 private:
  UniformBlock<CloudShadowParams> block_;
  GlTexture map_;
  std::uint64_t revision_ = 0;  // of the clouds in the map
};

}  // namespace offing::present

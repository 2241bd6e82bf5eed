#pragma once

#include <memory>

#include <glm/vec2.hpp>

#include "host/ocean/query/shoals.h"
#include "host/world/world.h"
#include "present/gl/gl_objects.h"
#include "present/gl/shader_program.h"
#include "present/gl/texture_array.h"
#include "present/gl/transfer.h"
#include "present/gl/uniform_block.h"
#include "present/passes/water/water_uniforms.h"

namespace offing::present {

/// OpenGL's copies of a sea's depths and of what shoals leave of its waves, which shoals.glsl reads.
class ShoalTexture {
 public:
  ShoalTexture();

  /// Copies them where they are others than those of the last call; none: the open sea.
  void prepare(const std::shared_ptr<const ocean::Shoals>& shoals);
  /// Gives them, if there are any, to a program in use that HAS_SHOALS; the texture goes to this unit.
  void bind(const ShaderProgram& program, int unit) const;
  /// Fills in where an eye at this label stands among the depths.
  void place(glm::dvec2 eye_m, glsl::WaveUniforms& waves) const;

 private:
  std::shared_ptr<const ocean::Shoals> shoals_;
  GlTexture depths_;
  UniformBlock<glsl::ShoalUniforms> shares_;
};

/// OpenGL's copies of a sea's maps, which the shaders of the water read (water.glsl, wakes.glsl,
/// shoals.glsl).
class WaterMaps {
 public:
  /// Units from first_free_unit on are left to others.
  static constexpr int first_free_unit = 5;

  /// Copies the maps of the world as it stands.
  void prepare(world::World& world, Transfer& transfer);

  /// Gives the maps to a program in use.
  void bind(const ShaderProgram& program) const;
  /// The uniforms of the maps for an eye at this label.
  glsl::WaveUniforms waves(const world::World& world, glm::dvec2 eye_m) const;

 private:
  MapTexture displacement_, gradient_, foam_, wakes_;
  ShoalTexture shoals_;
};

}  // namespace offing::present

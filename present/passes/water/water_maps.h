#pragma once

#include <glm/vec2.hpp>

#include "host/world/world.h"
#include "present/gl/map_texture.h"
#include "present/gl/shader_program.h"
#include "present/gl/transfer.h"
#include "present/passes/water/shoal_texture.h"

namespace offing::present {

/// OpenGL's copies of a sea's maps, which the shaders of the water read (water.glsl, wakes.glsl,
/// shoals.glsl).
class WaterMaps {
 public:
  /// Units from first_free_unit on are left to others.
  static constexpr int first_free_unit = 5;

  /// Copies the maps of the world as it stands,.
  void prepare(world::World& world, Transfer& transfer);

  /// Binds the maps, and tells a program in use where on them an eye at this label stands.
  void bind(const ShaderProgram& program, const world::World& world, glm::dvec2 eye_m) const;

 private:
  void bind_wakes(const ShaderProgram& program, const world::World& world, glm::dvec2 eye_m) const;

  MapTexture displacement_, gradient_, foam_, wakes_;
  ShoalTexture shoals_;
};

}  // namespace offing::present

#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "host/world/world.h"
#include "present/uniform_block.h"

namespace offing::present {

/// The lamps of a world, its sun and its sky, as mesh_light.glsl has them.
class MeshLights {
 public:
  MeshLights();

  /// Takes them over for an eye.
  void prepare(const world::World& world, const glm::dvec3& eye_m);
  /// Gives them to a program in use.
  void bind(const ShaderProgram& program) const;
  /// Light of a white surface that faces a lamp, kcd/m2; black for one that is not there any more.
  glm::vec3 white_kcdpm2(int lamp) const;

 private:
  UniformBlock block_;
  std::vector<glm::vec3> klx_;  // in the order of World::lighting()
  glm::vec3 sky_klx_{0.0f}, ground_klx_{0.0f};
};

}  // namespace offing::present

#pragma once

#include <vector>

#include <glm/vec3.hpp>

#include "host/world/world.h"
#include "present/gl/uniform_block.h"
#include "present/passes/clouds/cloud_shadows.h"
#include "present/passes/meshes/mesh_uniforms.h"

namespace offing::present {

/// The lights of a world, its sun and its sky, as mesh_light.glsl has them.
class MeshLights {
 public:
  MeshLights();

  /// Takes them over for an eye. Keeps a reference to the shadows, which fall on the sun's light.
  void prepare(const world::World& world, const glm::dvec3& eye_m, const CloudShadows& shadows);
  /// Gives them to a program in use.
  void bind(const ShaderProgram& program) const;
  /// Light of a white highlight of a light, kcd/m2, in the light's colour: as bright as white in all light
  /// that there is, so that no light's highlights are darker than what they lie on.
  glm::vec3 highlight_kcdpm2(int light) const;
  /// How much a light counts for highlights, 0 ... 1: less than all where it sends but a hundredth of the
  /// light, none where it is gone.
  double highlight_share(int light) const;

 private:
  const CloudShadows* shadows_ = nullptr;  // of the last prepare()
  UniformBlock<glsl::LightUniforms> block_;
  std::vector<glm::vec3> klx_;  // in the order of World::lighting()
  float white_klx_ = 0.0f;      // luminance of all light together
};

}  // namespace offing::present

#pragma once

#include <glm/vec2.hpp>

#include "host/ocean/query/gerstner_instant.h"
#include "present/gl/shader_program.h"
#include "present/gl/uniform_block.h"
#include "present/passes/water/water_uniforms.h"

namespace offing::present {

/// What rings.glsl knows of rings of waves.
class RingWaves {
 public:
  RingWaves();

  /// Takes over the rings for an eye at this label: of more than a shader takes, 64, those that look tallest
  /// from there, by amplitude over distance.
  void prepare(const ocean::GerstnerInstant& gerstner_waves, glm::dvec2 eye_m);
  /// Gives them to a program in use.
  void bind(const ShaderProgram& program) const { rings_.bind(program); }
  int count() const { return count_; }

 private:
  UniformBlock<glsl::RingUniforms> rings_;
  int count_ = 0;
};

}  // namespace offing::present

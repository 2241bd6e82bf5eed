#pragma once

#include <glm/vec2.hpp>

#include "host/ocean/trochoid_instant.h"
#include "present/shader_program.h"
#include "present/uniform_block.h"

namespace offing::present {

/// What rings.glsl knows of rings of waves.
class RingWaves {
 public:
  RingWaves();

  /// Sets it on a program in use, for an eye at this label: of more rings than a shader takes, 64, those that
  /// look tallest from there, by amplitude over distance.
  void set(const ShaderProgram& program, const ocean::TrochoidInstant& trochoids, glm::dvec2 eye_m) const;

 private:
  UniformBlock rings_;
};

}  // namespace offing::present

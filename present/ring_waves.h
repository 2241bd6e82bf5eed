#pragma once

#include <glm/vec2.hpp>

#include "host/ocean/trochoid_instant.h"
#include "present/shader_program.h"

namespace offing::present {

/// Sets the uniforms of rings.glsl on a program in use, for an eye at this label: of more rings than a shader
/// takes, 64, those that look tallest from there, by amplitude over distance.
void set_rings(const ShaderProgram& program, const ocean::TrochoidInstant& trochoids, glm::dvec2 eye_m);

}  // namespace offing::present

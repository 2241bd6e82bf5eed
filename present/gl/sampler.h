#pragma once

#include "present/gl/shader_program.h"

namespace offing::present {

/// Binds a texture to a unit, from which a sampler of the program in use reads it from now on.
inline void bind_sampler(const ShaderProgram& program, const char* sampler, int unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
  program.set(sampler, unit);
}

}  // namespace offing::present

#pragma once

#include <cstddef>
#include <vector>

#include "present/gl/gl_objects.h"
#include "present/gl/shader_program.h"

namespace offing::present {

/// The values of a shader's uniform block of vec4, which may hold more than OpenGL promises for uniforms
/// outside of blocks: 1024 numbers a stage.
class UniformBlock {
 public:
  /// `name` is the block's, `binding` its own among the blocks of a program, `capacity` as many values as the
  /// shader declares.
  UniformBlock(const char* name, GLuint binding, std::size_t capacity);

  /// Sets the first values and leaves the others 0.
  void fill(std::vector<glm::vec4> values) const;
  /// Gives them to a program in use.
  void bind(const ShaderProgram& program) const;

 private:
  const char* name_;
  GLuint binding_;
  std::size_t capacity_;
  GlBuffer buffer_;
};

}  // namespace offing::present

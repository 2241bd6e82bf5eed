#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <epoxy/gl.h>
#include <glm/ext/vector_int2.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace offing::present {

/// A piece of a shader's text, and what messages call it.
struct ShaderPart {
  std::string name;
  std::string text;
};

/// The file of present/passes of this name, "water/water.frag": embedded, or read from the folder
/// OFFING_SHADER_PATH if it is there. Throws Error(build_failed) if there is none.
ShaderPart shader_file(const std::string& name);

/// What a program is made of: the parts of a stage follow each other behind `#version 330 core`.
struct ShaderStages {
  std::vector<ShaderPart> vertex;
  std::vector<ShaderPart> fragment;
};

/// A linked program. Uniforms are set while it is in use; those that the compiler found unused are ignored.
class ShaderProgram {
 public:
  /// Throws Error(build_failed) with the compiler's messages, which name file and line.
  explicit ShaderProgram(const ShaderStages& stages);
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&& other) noexcept;
  ~ShaderProgram();

  void use() const { glUseProgram(program_); }
  /// Binds a uniform block, if the program has it, to a binding point.
  void bind_block(const char* block, GLuint binding) const;

  void set(const char* uniform, int value) const;
  void set(const char* uniform, float value) const;
  void set(const char* uniform, glm::vec2 value) const;
  void set(const char* uniform, glm::vec3 value) const;
  void set(const char* uniform, glm::vec4 value) const;
  void set(const char* uniform, const glm::mat4& value) const;
  void set(const char* uniform, glm::ivec2 value) const;
  void set(const char* uniform, const std::vector<float>& values) const;
  void set(const char* uniform, const std::vector<glm::vec3>& values) const;
  void set(const char* uniform, const std::vector<glm::vec4>& values) const;

 private:
  GLuint program_ = 0;
};

}  // namespace offing::present

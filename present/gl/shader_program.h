#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <epoxy/gl.h>

#include "present/gl/embedded_file.h"

namespace offing::present {

/// Every embedded file: stages (.vert, .frag) and what several of them share (.glsl).
std::span<const EmbeddedFile> shader_sources();

/// A piece of a shader's text, and what messages call it.
struct ShaderPart {
  std::string name;
  std::string text;
};

/// The file of present/passes of this name, "water/water.frag": embedded, or read from the folder
/// OFFING_SHADER_PATH if it is there. Throws Error(build_failed) if there is none.
ShaderPart shader_file(const std::string& name);

/// The declaration of a uniform block of std140 layout: `members` as in "ViewUniforms view; ToneUniforms
/// tone;".
ShaderPart uniform_block(const std::string& name, const std::string& members);

/// What a program is made of: the parts of a stage follow each other behind `#version 330 core`.
struct ShaderStages {
  std::vector<ShaderPart> vertex;
  std::vector<ShaderPart> fragment;
};

/// A linked program. Samplers and blocks are set while it is in use; those that the compiler found unused are
/// ignored.
class ShaderProgram {
 public:
  /// Throws Error(build_failed) with the compiler's messages, which name file and line.
  explicit ShaderProgram(const ShaderStages& stages);
  ShaderProgram(ShaderProgram&& other) noexcept;
  ShaderProgram& operator=(ShaderProgram&& other) noexcept;
  ~ShaderProgram();

  void use() const { glUseProgram(program_); }
  /// Binds a uniform block of this size, if the program has it, to a binding point. Throws
  /// Error(build_failed) if the block has another size.
  void bind_block(const char* block, GLuint binding, std::size_t bytes) const;

  /// Sets a sampler to a texture unit. All other values are in uniform blocks.
  void set(const char* sampler, int unit) const;

 private:
  GLuint program_ = 0;
};

/// Binds a texture to a unit, from which a sampler of the program in use reads it from now on.
inline void bind_sampler(const ShaderProgram& program, const char* sampler, int unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D, texture);
  program.set(sampler, unit);
}

/// One shader compiled for what is drawn with it: renderers such as llvmpipe go through both sides of a
/// branch and once more through a loop whose length they do not know, so that what is not needed costs as
/// much as what is. Features are an ordered value.
template <class Features>
class ShaderVariants {
 public:
  explicit ShaderVariants(std::function<ShaderProgram(const Features&)> make) : make_(std::move(make)) {}

  /// Compiles it where it is the first with these features. Throws what ShaderProgram throws.
  const ShaderProgram& with(const Features& features) {
    const auto known = programs_.find(features);
    return known != programs_.end() ? known->second
                                    : programs_.emplace(features, make_(features)).first->second;
  }

 private:
  std::function<ShaderProgram(const Features&)> make_;
  std::map<Features, ShaderProgram> programs_;
};

}  // namespace offing::present

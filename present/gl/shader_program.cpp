#include "present/gl/shader_program.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::present {
namespace {

// Lines of part i are numbered from (i + 1) * lines_per_part + 1, since not every driver keeps the file
// number of a #line directive. Lower numbers are of files within a part that numbers its own lines, as
// sky::clear_sky_glsl() does.
constexpr std::size_t lines_per_part = 10'000;

// Drivers write "0:20023(5): error" or "0(20023) : error": file and line.
std::string with_names(const std::string& log, const std::vector<ShaderPart>& parts) {
  static const std::regex place(R"((^|\n)(?:ERROR: )?(\d+)[:(](\d+)\)?)");
  std::string named;
  auto rest = log.cbegin();
  for (std::sregex_iterator match(log.begin(), log.end(), place), end; match != end; ++match) {
    const std::size_t number = std::stoul((*match)[3]), part = number / lines_per_part - 1;
    named.append(rest, (*match)[0].first);
    named += fmt::format("{}{}:{}", (*match)[1].str(),
                         part < parts.size() ? parts[part].name : "included text", number % lines_per_part);
    rest = (*match)[0].second;
  }
  return named.append(rest, log.cend());
}

class Shader {
 public:
  Shader(GLenum stage, const std::vector<ShaderPart>& parts) : shader_(glCreateShader(stage)) {
    std::string source = "#version 330 core\n";
    for (std::size_t i = 0; i < parts.size(); ++i) {
      source += fmt::format("#line {}\n{}\n", (i + 1) * lines_per_part + 1, parts[i].text);
    }
    const char* text = source.c_str();
    glShaderSource(shader_, 1, &text, nullptr);
    glCompileShader(shader_);
    GLint is_good = 0, length = 0;
    glGetShaderiv(shader_, GL_COMPILE_STATUS, &is_good);
    if (is_good == GL_TRUE) return;
    glGetShaderiv(shader_, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetShaderInfoLog(shader_, length, nullptr, log.data());
    glDeleteShader(shader_);
    throw Error(
        ErrorKind::build_failed,
        fmt::format("shader {}: does not compile: {}", parts.back().name, with_names(log.c_str(), parts)),
        "correct the shader, or unset OFFING_SHADER_PATH");
  }
  Shader(const Shader&) = delete;
  Shader& operator=(const Shader&) = delete;
  ~Shader() { glDeleteShader(shader_); }

  GLuint name() const { return shader_; }

 private:
  GLuint shader_;
};

}  // namespace

ShaderPart shader_file(const std::string& name) {
  const char* folder = std::getenv("OFFING_SHADER_PATH");
  if (folder != nullptr && *folder != '\0') {
    const std::filesystem::path path = std::filesystem::path(folder) / name;
    if (std::ifstream file(path, std::ios::binary); file) {
      std::ostringstream text;
      text << file.rdbuf();
      return {path.string(), text.str()};
    }
  }
  for (const EmbeddedFile& source : shader_sources()) {
    if (source.name == name) return {"present/passes/" + name, std::string(source.text)};
  }
  throw Error(ErrorKind::build_failed, fmt::format("no shader source \"{}\" in present/passes", name),
              "correct the name, or the folder in OFFING_SHADER_PATH");
}

ShaderPart uniform_block(const std::string& name, const std::string& members) {
  return {"uniform block " + name, fmt::format("layout(std140) uniform {} {{ {} }};\n", name, members)};
}

ShaderProgram::ShaderProgram(const ShaderStages& stages) {
  const Shader vertex(GL_VERTEX_SHADER, stages.vertex), fragment(GL_FRAGMENT_SHADER, stages.fragment);
  const GLuint program = glCreateProgram();
  glAttachShader(program, vertex.name());
  glAttachShader(program, fragment.name());
  glLinkProgram(program);
  glDetachShader(program, vertex.name());
  glDetachShader(program, fragment.name());
  GLint is_good = 0, length = 0;
  glGetProgramiv(program, GL_LINK_STATUS, &is_good);
  if (is_good != GL_TRUE) {
    glGetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(std::max(length, 1)), '\0');
    glGetProgramInfoLog(program, length, nullptr, log.data());
    glDeleteProgram(program);
    throw Error(ErrorKind::build_failed,
                fmt::format("shaders {} and {}: do not link: {}", stages.vertex.back().name,
                            stages.fragment.back().name, log.c_str()),
                "correct the shaders, or unset OFFING_SHADER_PATH");
  }
  program_ = program;
}

ShaderProgram::ShaderProgram(ShaderProgram&& other) noexcept : program_(std::exchange(other.program_, 0)) {}

ShaderProgram& ShaderProgram::operator=(ShaderProgram&& other) noexcept {
  std::swap(program_, other.program_);
  return *this;
}

ShaderProgram::~ShaderProgram() {
  if (program_ != 0) glDeleteProgram(program_);
}

void ShaderProgram::bind_block(const char* block, GLuint binding, std::size_t bytes) const {
  const GLuint index = glGetUniformBlockIndex(program_, block);
  if (index == GL_INVALID_INDEX) return;
  GLint size = 0;
  glGetActiveUniformBlockiv(program_, index, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
  if (static_cast<std::size_t>(size) != bytes) {
    throw Error(
        ErrorKind::build_failed,
        fmt::format("uniform block {}: expected {} bytes, found {} in the shader", block, bytes, size),
        "correct the struct of uniforms, or unset OFFING_SHADER_PATH");
  }
  glUniformBlockBinding(program_, index, binding);
}

void ShaderProgram::set(const char* sampler, int unit) const {
  glUniform1i(glGetUniformLocation(program_, sampler), unit);
}

}  // namespace offing::present

#include "present/gl/uniform_block.h"

namespace offing::present {

UniformBlock::UniformBlock(const char* name, GLuint binding, std::size_t capacity)
    : name_(name), binding_(binding), capacity_(capacity), buffer_(GlBuffer::make()) {}

void UniformBlock::fill(std::vector<glm::vec4> values) const {
  values.resize(capacity_);
  glBindBuffer(GL_UNIFORM_BUFFER, buffer_.name());
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(values.size() * sizeof(glm::vec4)), values.data(),
               GL_STREAM_DRAW);
}

void UniformBlock::bind(const ShaderProgram& program) const {
  program.bind_block(name_, binding_);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding_, buffer_.name());
}

}  // namespace offing::present

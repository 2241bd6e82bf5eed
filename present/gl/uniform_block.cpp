#include "present/gl/uniform_block.h"

namespace offing::present {

UniformBuffer::UniformBuffer(const char* name, GLuint binding)
    : name_(name), binding_(binding), buffer_(GlBuffer::make()) {}

void UniformBuffer::upload(std::span<const std::byte> bytes) {
  size_ = bytes.size();
  glBindBuffer(GL_UNIFORM_BUFFER, buffer_.name());
  glBufferData(GL_UNIFORM_BUFFER, static_cast<GLsizeiptr>(bytes.size()), bytes.data(), GL_STREAM_DRAW);
}

void UniformBuffer::bind(const ShaderProgram& program) const {
  program.bind_block(name_, binding_, size_);
  glBindBufferBase(GL_UNIFORM_BUFFER, binding_, buffer_.name());
}

}  // namespace offing::present

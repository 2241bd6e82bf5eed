#include "present/gl/render_target.h"

#include <epoxy/gl.h>
#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::present {

RenderTarget::RenderTarget(int width, int height, GLenum format, Depth depth)
    : RenderTarget(width, height, format, 1, depth) {}

RenderTarget::RenderTarget(int width, int height, GLenum format, int count, Depth depth)
    : width_(width), height_(height), framebuffer_(GlFramebuffer::make()) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  std::vector<GLenum> outputs;
  for (int i = 0; i < count; ++i) {
    const GlTexture& colour = colours_.emplace_back(GlTexture::make());
    glBindTexture(GL_TEXTURE_2D, colour.name());
    glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(format), width, height, 0, GL_RGBA, GL_UNSIGNED_BYTE,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    outputs.push_back(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(i));
    glFramebufferTexture2D(GL_FRAMEBUFFER, outputs.back(), GL_TEXTURE_2D, colour.name(), 0);
  }
  glDrawBuffers(count, outputs.data());
  if (depth == Depth::single_precision) {
    depth_ = GlTexture::make();
    glBindTexture(GL_TEXTURE_2D, depth_.name());
    glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, width, height, 0, GL_DEPTH_COMPONENT, GL_FLOAT,
                 nullptr);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth_.name(), 0);
  }
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(
        ErrorKind::device,
        fmt::format("OpenGL: a picture of {} x {} pixels cannot be created ({:#x})", width, height, status),
        "choose a smaller size");
  }
}

void RenderTarget::fill_levels() const {
  constexpr GLint most_levels = 1000;  // as many as there are
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, texture());
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, most_levels);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_LINEAR);
  glGenerateMipmap(GL_TEXTURE_2D);
}

void RenderTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, width_, height_);
}

std::vector<float> RenderTarget::read(std::size_t output) const {
  std::vector<float> pixels(4 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glReadBuffer(GL_COLOR_ATTACHMENT0 + static_cast<GLenum>(output));
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_FLOAT, pixels.data());
  glReadBuffer(GL_COLOR_ATTACHMENT0);
  return pixels;
}

std::vector<unsigned char> RenderTarget::read_bytes() const {
  std::vector<unsigned char> pixels(3 * static_cast<std::size_t>(width_) * static_cast<std::size_t>(height_));
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(0, 0, width_, height_, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
  return pixels;
}

}  // namespace offing::present

#include "present/gl/multisample_target.h"

#include <algorithm>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::present {
namespace {

GLint most_samples() {
  GLint colour = 1, depth = 1;
  glGetIntegerv(GL_MAX_COLOR_TEXTURE_SAMPLES, &colour);
  glGetIntegerv(GL_MAX_DEPTH_TEXTURE_SAMPLES, &depth);
  return std::max(1, std::min(colour, depth));
}

void bind_unit(int unit, GLuint texture) {
  glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
  glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture);
}

}  // namespace

MultisampleTarget::MultisampleTarget(int width, int height, int wanted_samples)
    : width_(width),
      height_(height),
      samples_(std::min(wanted_samples, most_samples())),
      light_(GlTexture::make()),
      depth_(GlTexture::make()),
      framebuffer_(GlFramebuffer::make()) {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  const auto attach = [&](const GlTexture& texture, GLenum format, GLenum place) {
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture.name());
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, samples_, format, width, height, GL_TRUE);
    glFramebufferTexture2D(GL_FRAMEBUFFER, place, GL_TEXTURE_2D_MULTISAMPLE, texture.name(), 0);
  };
  attach(light_, GL_RGBA16F, GL_COLOR_ATTACHMENT0);
  attach(depth_, GL_DEPTH_COMPONENT32F, GL_DEPTH_ATTACHMENT);
  const GLenum status = glCheckFramebufferStatus(GL_FRAMEBUFFER);
  if (status != GL_FRAMEBUFFER_COMPLETE) {
    throw Error(ErrorKind::device,
                fmt::format("OpenGL: a picture of {} x {} pixels of {} samples cannot be created ({:#x})",
                            width, height, samples_, status),
                "choose a smaller size");
  }
}

void MultisampleTarget::bind() const {
  glBindFramebuffer(GL_FRAMEBUFFER, framebuffer_.name());
  glViewport(0, 0, width_, height_);
}

void MultisampleTarget::bind_samples(int light_unit, int depth_unit) const {
  bind_unit(light_unit, light_.name());
  bind_unit(depth_unit, depth_.name());
}

}  // namespace offing::present

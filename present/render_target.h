#pragma once

#include <vector>

#include "present/gl_objects.h"

namespace offing::present {

/// A framebuffer of our own: a colour texture and, if wanted, a depth buffer of single precision.
class RenderTarget {
 public:
  enum class Depth { none, single_precision };

  RenderTarget() = default;
  /// Throws Error(device) if the driver cannot draw on this format.
  RenderTarget(int width, int height, GLenum format, Depth depth);

  int width() const { return width_; }
  int height() const { return height_; }
  GLuint framebuffer() const { return framebuffer_.name(); }
  GLuint texture() const { return colour_.name(); }

  /// Draws go here, onto all of it.
  void bind() const;
  /// Pixels [height][width] of 4 floats, row 0 at the bottom.
  std::vector<float> read() const;
  /// Pixels [height][width][3], row 0 at the bottom.
  std::vector<unsigned char> read_bytes() const;

 private:
  int width_ = 0, height_ = 0;
  GlTexture colour_, depth_;
  GlFramebuffer framebuffer_;
};

}  // namespace offing::present

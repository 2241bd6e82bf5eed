#pragma once

#include <vector>

#include "present/gl/gl_objects.h"

namespace offing::present {

/// A framebuffer of our own: colour textures and, if wanted, a depth texture of single precision.
class RenderTarget {
 public:
  enum class Depth { none, single_precision };

  RenderTarget() = default;
  /// Throws Error(device) if the driver cannot draw on this format.
  RenderTarget(int width, int height, GLenum format, Depth depth);
  /// The same with `count` (1 ... 8) colour textures, which a shader's outputs 0, 1, ... go to.
  RenderTarget(int width, int height, GLenum format, int count, Depth depth);

  int width() const { return width_; }
  int height() const { return height_; }
  GLuint framebuffer() const { return framebuffer_.name(); }
  GLuint texture(std::size_t output = 0) const { return colours_[output].name(); }
  GLuint depth_texture() const { return depth_.name(); }

  /// Draws go here, onto all of it.
  void bind() const;
  /// Makes coarser levels of output 0 of what has been drawn on it, for lookups by level.
  void fill_levels() const;
  /// Pixels of an output, [height][width] of 4 floats, row 0 at the bottom.
  std::vector<float> read(std::size_t output = 0) const;
  /// Pixels of output 0, [height][width][3], row 0 at the bottom.
  std::vector<unsigned char> read_bytes() const;

 private:
  int width_ = 0, height_ = 0;
  std::vector<GlTexture> colours_;
  GlTexture depth_;
  GlFramebuffer framebuffer_;
};

}  // namespace offing::present

#pragma once

#include "present/gl/gl_objects.h"

namespace offing::present {

/// A framebuffer of our own with several samples a pixel: light (RGBA, half precision) and depth of single
/// precision.
class MultisampleTarget {
 public:
  MultisampleTarget() = default;
  /// As many samples as wanted, or as the driver has. Throws Error(device) if it cannot draw on that.
  MultisampleTarget(int width, int height, int wanted_samples);

  int width() const { return width_; }
  int height() const { return height_; }
  int samples() const { return samples_; }

  /// Draws go here, onto all of it.
  void bind() const;
  /// Binds light and depth as textures of many samples to units.
  void bind_samples(int light_unit, int depth_unit) const;

 private:
  int width_ = 0, height_ = 0, samples_ = 0;
  GlTexture light_, depth_;
  GlFramebuffer framebuffer_;
};

}  // namespace offing::present

#pragma once

#include "present/gl_objects.h"

namespace offing::present {

/// A texture array for maps of a simulation: [layers][size][size] texels of 1 or 4 floats, row-major, that
/// repeats across its edges; with mip levels.
class MapTexture {
 public:
  MapTexture() = default;
  MapTexture(int size, int layers, int channels);

  int size() const { return size_; }
  int layers() const { return layers_; }
  /// Floats of all layers.
  std::size_t count() const;

  /// Replaces the finest level: `texels` are floats in memory, or an offset into the buffer bound to
  /// GL_PIXEL_UNPACK_BUFFER.
  void specify(const void* texels) const;
  /// Makes the other levels from the finest.
  void make_levels() const;
  void bind(int unit) const;

 private:
  int size_ = 0, layers_ = 0, channels_ = 0;
  GlTexture texture_;
};

}  // namespace offing::present

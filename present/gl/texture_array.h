#pragma once

#include <cstddef>
#include <span>

#include "present/gl/gl_objects.h"

namespace offing::present {

/// A texture array that takes its texels from a simulation: [layers][height][width] texels of 1 or 4 floats.
class TextureArray {
 public:
  struct Shape {
    int width = 0, height = 0, layers = 0, channels = 0;
    bool operator==(const Shape&) const = default;
  };

  TextureArray() = default;
  /// As large as a picture whose texels are read one by one: no mip levels, no filter.
  explicit TextureArray(const Shape& shape) : TextureArray(shape, 1) {}

  const Shape& shape() const { return shape_; }
  /// Floats of all layers.
  std::size_t count() const;

  /// Replaces the texels of all levels; OpenGL makes the coarser ones. `texels` are floats in memory, or an
  /// offset into the buffer bound to GL_PIXEL_UNPACK_BUFFER.
  void specify(const void* texels) const;
  /// The same, but works the coarser levels out on the CPU. This is faster where OpenGL itself draws on the
  /// CPU.
  void specify_levels(std::span<const float> texels) const;
  void bind(int unit) const;

 protected:
  /// With more than one level, width and height are the same power of two. Leaves the texture bound.
  TextureArray(const Shape& shape, int levels);

 private:
  void specify_level(int level, const void* texels) const;

  Shape shape_;
  int levels_ = 1;
  GlTexture texture_;
};

/// A texture array for maps of a simulation: [layers][size][size] texels of 1 or 4 floats, row-major, that
/// repeats across its edges; with mip levels, filtered.
class MapTexture : public TextureArray {
 public:
  MapTexture() = default;
  MapTexture(int size, int layers, int channels);

  int size() const { return shape().width; }
  int layers() const { return shape().layers; }
};

}  // namespace offing::present

#pragma once

#include "present/gl/texture_array.h"

namespace offing::present {

/// A texture array for maps of a simulation: [layers][size][size] texels of 1 or 4 floats, row-major, that
/// repeats across its edges; with mip levels, filtered.
class MapTexture : public TextureArray {
 public:
  MapTexture() = default;
  MapTexture(int size, int layers, int channels);

  int size() const { return shape().width; }
  int layers() const { return shape().layers; }

  /// Makes the other levels from the finest.
  void make_levels() const;
};

}  // namespace offing::present

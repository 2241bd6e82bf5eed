#pragma once

#include <cstddef>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/terrain/field/post_grid.h"

namespace offing::terrain {

/// How the levels of a pyramid lie in memory. Level L has nodes of 2^L x 2^L cells, padded to whole nodes of
/// the top level, so that where a level begins is a formula; the top level is the highest that keeps all
/// within 0.4 times the height map, and may have more nodes than one.
struct PyramidLayout {
  int padded_x = 0, padded_z = 0;  ///< cells, multiples of 2^top_level
  int top_level = 1;

  static PyramidLayout of(const PostGrid& grid);

  int nodes_x(int level) const { return padded_x >> level; }
  int nodes_z(int level) const { return padded_z >> level; }
  /// Where a level's nodes [nodes_z][nodes_x] begin.
  std::size_t begin(int level) const;
  std::size_t node_count() const { return begin(top_level + 1); }
};

/// Maxima over 2 x 2 cells and more on a device (T2, T8 of docs/sources.md): the highest post of all patches
/// of a node, as the very float it is in the map, so that no rounding lowers a maximum. Single patches need
/// none in memory: a walk that reaches one reads its corners anyway.
class Pyramid {
 public:
  /// Enqueues the pyramid's levels. heights_m [rows][columns] is not kept. Throws Error(out_of_memory).
  Pyramid(const ocl::Device& device, const PostGrid& grid, const ocl::Buffer<float>& heights_m);

  const PyramidLayout& layout() const { return layout_; }
  const ocl::Buffer<float>& maxima_m() const { return maxima_m_; }

 private:
  PyramidLayout layout_;
  ocl::Buffer<float> maxima_m_;
};

}  // namespace offing::terrain

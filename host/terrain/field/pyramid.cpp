#include "host/terrain/field/pyramid.h"

#include <algorithm>

#include "host/ocl/program.h"

namespace offing::terrain {
namespace {

constexpr double largest_share = 0.4;  // of the height map

int rounded_up(int cells, int level) {
  return (((cells - 1) >> level) + 1) << level;
}

PyramidLayout with_top(const PostGrid& grid, int level) {
  return {.padded_x = rounded_up(grid.columns - 1, level),
          .padded_z = rounded_up(grid.rows - 1, level),
          .top_level = level};
}

}  // namespace

PyramidLayout PyramidLayout::of(const PostGrid& grid) {
  const double most_nodes = largest_share * grid.columns * grid.rows;
  const int cells = std::max(grid.columns, grid.rows) - 1;
  PyramidLayout layout = with_top(grid, 1);
  for (int level = 2; 1 << (level - 1) < cells; ++level) {
    const PyramidLayout higher = with_top(grid, level);
    if (static_cast<double>(higher.node_count()) <= most_nodes) layout = higher;
  }
  return layout;
}

std::size_t PyramidLayout::begin(int level) const {
  std::size_t nodes = 0;
  for (int below = 1; below < level; ++below) {
    nodes += static_cast<std::size_t>(nodes_x(below)) * static_cast<std::size_t>(nodes_z(below));
  }
  return nodes;
}

Pyramid::Pyramid(const ocl::Device& device, const PostGrid& grid, const ocl::Buffer<float>& heights_m)
    : layout_(PyramidLayout::of(grid)), maxima_m_(device, layout_.node_count(), "node maxima") {
  const auto shape_of = [&](int level) {
    return ocl::LaunchShape{
        {static_cast<std::size_t>(layout_.nodes_x(level)), static_cast<std::size_t>(layout_.nodes_z(level))}};
  };
  ocl::Program::build(device, "terrain/pyramid_base.cl")
      .kernel("pyramid_base")
      .launch(shape_of(1), heights_m, 0, grid.columns, grid.rows, layout_.nodes_x(1), maxima_m_, 0);
  const ocl::Kernel reduce =
      ocl::Program::build(device, "terrain/pyramid_reduce.cl").kernel("pyramid_reduce");
  for (int level = 2; level <= layout_.top_level; ++level) {
    reduce.launch(shape_of(level), maxima_m_, static_cast<int>(layout_.begin(level - 1)),
                  layout_.nodes_x(level), static_cast<int>(layout_.begin(level)));
  }
}

}  // namespace offing::terrain

#include "host/terrain/shading/colour_layer.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/program.h"

namespace offing::terrain {
namespace {

using Rgba = std::array<std::uint8_t, 4>;

// Places of texels of all levels are 32-bit numbers.
constexpr std::size_t most_texels = std::size_t{1} << 30;

void require_valid(const ColourMap& map) {
  const std::size_t texels = map.columns < 1 || map.rows < 1
                                 ? 0
                                 : static_cast<std::size_t>(map.columns) * static_cast<std::size_t>(map.rows);
  if (texels == 0 || texels > most_texels || map.rgba.size() != 4 * texels) {
    throw Error(ErrorKind::bad_input,
                fmt::format("colour map: expected 1 ... {} texels of 4 bytes, found {} x {} and {} bytes",
                            most_texels, map.columns, map.rows, map.rgba.size()),
                "make the picture smaller");
  }
  const bool is_finite = std::isfinite(map.left) && std::isfinite(map.top) && std::isfinite(map.right) &&
                         std::isfinite(map.bottom);
  if (!is_finite || map.right <= map.left || map.bottom <= map.top) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("colour map: expected edges from left to right and from top to bottom, found {:g} "
                    "... {:g} and {:g} ... {:g} cells",
                    map.left, map.right, map.top, map.bottom),
        "give the position of the picture");
  }
}

}  // namespace

ColourLayer::ColourLayer(const ocl::Device& device, const ColourMap& map) {
  require_valid(map);
  look_.colour_columns = map.columns;
  look_.colour_rows = map.rows;
  look_.colour_left = static_cast<float>(map.left);
  look_.colour_top = static_cast<float>(map.top);
  look_.colours_a_cell_x = static_cast<float>(map.columns / (map.right - map.left));
  look_.colours_a_cell_z = static_cast<float>(map.rows / (map.bottom - map.top));
  struct Level {
    std::size_t columns, rows, begin;
  };
  std::vector<Level> levels{{static_cast<std::size_t>(map.columns), static_cast<std::size_t>(map.rows), 0}};
  while (levels.back().columns * levels.back().rows > 1) {
    const Level& last = levels.back();
    levels.push_back({(last.columns + 1) / 2, (last.rows + 1) / 2, last.begin + last.columns * last.rows});
  }
  look_.colour_levels = static_cast<int>(levels.size());
  colours_ = ocl::Buffer<std::uint32_t>(device, levels.back().begin + 1, "colour map");

  const std::size_t texels = levels.front().columns * levels.front().rows;
  const ocl::Buffer<Rgba> srgb(device, std::span(reinterpret_cast<const Rgba*>(map.rgba.data()), texels),
                               "picture of the ground");
  ocl::Program::build(device, "terrain/colour_base.cl")
      .kernel("colour_base")
      .launch({{texels}}, srgb, colours_);
  const ocl::Kernel reduce = ocl::Program::build(device, "terrain/colour_reduce.cl").kernel("colour_reduce");
  for (std::size_t i = 1; i < levels.size(); ++i) {
    const Level &source = levels[i - 1], &target = levels[i];
    reduce.launch({{target.columns, target.rows}}, colours_, static_cast<std::uint32_t>(source.begin),
                  static_cast<int>(source.columns), static_cast<int>(source.rows),
                  static_cast<std::uint32_t>(target.begin));
  }
  // The picture's memory must outlive the kernels that read it.
  std::uint32_t coarsest = 0;
  colours_.read(std::span(&coarsest, 1), levels.back().begin);
}

void ColourLayer::describe(TerrainLook& look) const {
  look.colour_columns = look_.colour_columns;
  look.colour_rows = look_.colour_rows;
  look.colour_levels = look_.colour_levels;
  look.colour_left = look_.colour_left;
  look.colour_top = look_.colour_top;
  look.colours_a_cell_x = look_.colours_a_cell_x;
  look.colours_a_cell_z = look_.colours_a_cell_z;
}

}  // namespace offing::terrain

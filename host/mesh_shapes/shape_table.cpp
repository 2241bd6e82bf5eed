#include "host/mesh_shapes/shape_table.h"

#include <algorithm>
#include <iterator>
#include <map>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace offing::mesh_shapes {
namespace {

constexpr int base_detail = 2;
constexpr auto count = ShapeNumber::Kind::count;

}  // namespace

const std::vector<ShapeRow>& shapes() {
  static const std::vector<ShapeRow> rows{
      {.name = "knot",
       .other_name = "torus-knot",
       .help = "a knotted tube",
       .size = "radius",
       .size_help = "of the torus that it lies on",
       .size_flag = "--radius-m",
       .numbers = {{"--around", "windings about z", 2, count},
                   {"--through", "windings through the hole", 3, count},
                   {"--winding-m", "radius of the tube of the torus that it lies on", 0.45},
                   {"--tube-m", "radius of the knotted tube", 0.18}},
       .grid = {120, 12},
       .u_help = "cells along the tube",
       .v_help = "cells around the tube",
       .has_truth = true,
       .make =
           [](const ShapeOrder& order) {
             const std::vector<double>& n = order.numbers;
             return make_torus_knot({.around = static_cast<int>(n[0]),
                                     .through = static_cast<int>(n[1]),
                                     .radius_m = order.size_m,
                                     .winding_m = n[2],
                                     .tube_radius_m = n[3]},
                                    order.grid, order.roughness);
           }},
      {.name = "sphere",
       .help = "a sphere (an icosphere)",
       .size = "radius",
       .size_flag = "--radius-m",
       .level = 4,
       .generated_detail = 3,
       .has_truth = true,
       .make = [](const ShapeOrder& o) { return make_sphere(o.size_m, o.level, o.roughness); }},
      {.name = "ellipsoid",
       .help = "an ellipsoid (a stretched icosphere)",
       .size = "semi-axis",
       .size_help = "along x",
       .size_flag = "--x-m",
       .numbers = {{"--y-m", "semi-axis along y", 0.75}, {"--z-m", "semi-axis along z", 0.5}},
       .level = 4,
       .generated_detail = 3,
       .has_truth = true,
       .make =
           [](const ShapeOrder& order) {
             return make_ellipsoid({order.size_m, order.numbers[0], order.numbers[1]}, order.level,
                                   order.roughness);
           }},
      {.name = "torus",
       .help = "a torus about z",
       .size = "radius",
       .size_help = "of the tube's middle",
       .size_flag = "--radius-m",
       .numbers = {{"--tube-m", "radius of the tube", 0.4}},
       .grid = {80, 32},
       .u_help = "cells around z",
       .v_help = "cells around the tube",
       .generated_detail = 3,
       .has_truth = true,
       .make =
           [](const ShapeOrder& order) {
             return make_torus(order.size_m, order.numbers[0], order.grid, order.roughness);
           }},
      {.name = "saddle",
       .help = "a saddle: an open patch with a border",
       .size = "half width",
       .size_help = "along x and y",
       .size_flag = "--half-width-m",
       .grid = {48, 48},
       .u_help = "cells along x",
       .v_help = "cells along y",
       .generated_detail = 3,
       .is_closed = false,
       .has_truth = true,
       .make = [](const ShapeOrder& o) { return make_saddle(o.size_m, o.grid, o.roughness); }},
      {.name = "head",
       .help = "a rounded shape like a character's head",
       .size = "radius",
       .size_help = "of the skull",
       .size_flag = "--radius-m",
       .level = 5,
       .has_truth = true,
       .make = [](const ShapeOrder& o) { return make_head(o.size_m, o.level, o.roughness); }},
      {.name = "ship",
       .help = "a hull with its deck",
       .size = "length",
       .size_flag = "--length-m",
       .grid = {120, 64},
       .u_help = "cells along the hull",
       .v_help = "cells around the hull",
       .make = [](const ShapeOrder& order) { return make_ship(order.size_m, order.grid); }},
      {.name = "bird",
       .help = "a soaring bird",
       .size = "span",
       .size_help = "from tip to tip of its wings",
       .size_flag = "--span-m",
       .grid = {120, 24},
       .u_help = "cells from tip to tip",
       .v_help = "cells around its wings and body",
       .make = [](const ShapeOrder& order) { return make_bird(order.size_m, order.grid); }},
      {.name = "boat",
       .help = "an open boat",
       .size = "length",
       .size_flag = "--length-m",
       .grid = {96, 64},
       .u_help = "cells along the hull",
       .v_help = "cells around the hull, half of them outside",
       .make = [](const ShapeOrder& order) { return make_boat(order.size_m, order.grid); }},
      {.name = "box",
       .help = "a box",
       .size = "half side",
       .size_help = "along x",
       .size_flag = "--x-m",
       .numbers = {{"--y-m", "half side along y", 1.0}, {"--z-m", "half side along z", 1.0}},
       .grid = {4, 0},
       .u_help = "cells along each side",
       .make =
           [](const ShapeOrder& order) {
             return make_box(2.0 * glm::dvec3(order.size_m, order.numbers[0], order.numbers[1]),
                             order.grid.u_cells);
           }},
      {.name = "cylinder",
       .help = "a closed cylinder that stands on a circle",
       .size = "radius",
       .size_flag = "--radius-m",
       .numbers = {{"--height-m", "height", 2.0}},
       .grid = {12, 48},
       .u_help = "cells from bottom to top",
       .v_help = "cells around the axis",
       .make = [](const ShapeOrder& o) { return make_cylinder(o.size_m, o.numbers[0], o.grid); }},
      {.name = "cone",
       .help = "a closed cone that stands on a circle",
       .size = "radius",
       .size_flag = "--radius-m",
       .numbers = {{"--height-m", "height", 2.0}},
       .grid = {12, 48},
       .u_help = "cells from bottom to top",
       .v_help = "cells around the axis",
       .make = [](const ShapeOrder& o) { return make_cone(o.size_m, o.numbers[0], o.grid); }},
      {.name = "bumpy",
       .help = "a sphere with smooth bumps and hollows",
       .size = "radius",
       .size_help = "between the bumps",
       .size_flag = "--radius-m",
       .numbers = {{"--bump-m", "height of the bumps", 0.15}},
       .level = 5,
       .has_truth = true,
       .make = [](const ShapeOrder& o) {
         return make_bumpy_sphere(o.size_m, o.numbers[0], o.level, o.roughness);
       }}};
  return rows;
}

const std::vector<ShapeRow>& closed_shapes() {
  static const std::vector<ShapeRow> closed = [] {
    std::vector<ShapeRow> rows;
    std::ranges::copy_if(shapes(), std::back_inserter(rows), &ShapeRow::is_closed);
    return rows;
  }();
  return closed;
}

std::vector<std::string_view> names_of(const std::vector<ShapeRow>& rows) {
  std::vector<std::string_view> names;
  std::ranges::transform(rows, std::back_inserter(names), &ShapeRow::name);
  return names;
}

std::string meaning_of_size() {
  std::map<std::string_view, std::vector<std::string_view>> names;
  for (const ShapeRow& row : shapes()) names[row.size].push_back(row.name);
  std::vector<std::string> parts;
  for (const auto& [size, of] : names) parts.push_back(fmt::format("{} ({})", size, fmt::join(of, ", ")));
  return fmt::format("{}", fmt::join(parts, ", "));
}

ShapeOrder order_of(const ShapeRow& row, double size_m, int detail) {
  ShapeOrder order{.size_m = size_m, .numbers = {}, .level = 0, .grid = {}, .roughness = {}};
  for (const ShapeNumber& number : row.numbers)
    order.numbers.push_back(number.kind == count ? number.value : size_m * number.value);
  const auto finer = [detail](int cells) { return (cells << detail) >> base_detail; };
  if (row.level > 0) order.level = row.level + detail - base_detail;
  order.grid = {finer(row.grid.u_cells), finer(row.grid.v_cells)};
  return order;
}

Shape made_shape(const ShapeRow& row, double size_m, int detail) {
  return row.make(order_of(row, size_m, detail));
}

}  // namespace offing::mesh_shapes

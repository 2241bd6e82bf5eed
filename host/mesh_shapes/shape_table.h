// The table of made shapes: what `offing-mesh generate` and the `shape` keys of scenes offer.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "host/mesh_shapes/shape.h"

namespace offing::mesh_shapes {

/// All that a shape may be made from; each takes what its row names.
struct ShapeOrder {
  double size_m = 1.0;
  std::vector<double> numbers;  ///< in the order of ShapeRow::numbers
  int level = 0;                ///< of an icosphere
  Grid grid;
  Roughness roughness;
};

/// A value of a shape beside its size.
struct ShapeNumber {
  /// A length in metres, or a whole number.
  enum class Kind { length, count };
  std::string_view flag;  ///< of `offing-mesh generate`
  std::string_view help;
  double value;  ///< of a length in sizes
  Kind kind = Kind::length;
};

/// One shape. A grid that has no second help has cells of one number.
struct ShapeRow {
  std::string_view name;
  std::string_view other_name = {};  ///< that `offing-mesh generate` takes too
  std::string_view help;
  std::string_view size;            ///< what the size is: "radius"
  std::string_view size_help = {};  ///< which one, where that is not plain: "of the skull"
  std::string_view size_flag;       ///< of `offing-mesh generate`
  std::vector<ShapeNumber> numbers = {};
  int level = 0;  ///< at detail 2; 0: the shape has a grid
  Grid grid = {};
  std::string_view u_help = {}, v_help = {};
  int generated_detail = 2;  ///< of `offing-mesh generate`
  bool is_closed = true;
  bool has_truth = false;  ///< and takes a roughness
  Shape (*make)(const ShapeOrder&);
};

/// Scenes keep a shape as its index here.
const std::vector<ShapeRow>& shapes();
/// Those that enclose something, in the same order: clouds fill them.
const std::vector<ShapeRow>& closed_shapes();
std::vector<std::string_view> names_of(const std::vector<ShapeRow>& rows);
/// What the size of each shape is, for a help text: "radius (knot, sphere), length (ship)".
std::string meaning_of_size();

/// All of a row's own values, at this size; one more detail has four times the faces.
ShapeOrder order_of(const ShapeRow& row, double size_m, int detail);
/// Throws Error(bad_usage) as the function of the shape does.
Shape made_shape(const ShapeRow& row, double size_m, int detail);

}  // namespace offing::mesh_shapes

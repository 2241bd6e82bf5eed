#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/io/meshes/text_lines.h"

/// PLY files: the header, and the values after it.
namespace offing::meshes {

/// The types of values in a PLY.
enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
/// How the values of a PLY are written.
enum class PlyEncoding { text, little_endian, big_endian };

std::size_t bytes_of(PlyType type);

/// A value, or a list of values, that each row of an element has.
struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  ///< of a list: the whole number before its values
};

/// A table of a PLY, such as its vertices: rows of the same properties.
struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;  ///< never empty where count > 0
};

/// What a PLY says about its values before they begin.
struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  ///< where the values begin
  std::size_t lines = 0;  ///< of the header
};

/// The header of a PLY. Throws Error(bad_input) with the line for what is none, and for properties of an
/// element with the same name. Counts are what the file says: they may lie.
PlyHeader parse_ply_header(std::string_view text, std::string_view file_name);

/// The values of a PLY after its header, one after the other, in text or binary.
class PlyValues {
 public:
  PlyValues(std::string_view text, std::string_view file_name, const PlyHeader& header);

  /// The next value; each type fits a double exactly. In text it must be a finite number, in binary it may be
  /// a NaN. Throws Error(bad_input) at the end of the file.
  double next(PlyType type);
  /// The next length of a list; throws Error(bad_input) for one that the rest of the file cannot hold.
  std::size_t next_length(const PlyProperty& list);
  /// Passes over a value or a list.
  void skip(const PlyProperty& property);

  /// Throws Error(bad_input) if the rest of the file cannot hold all of an element: a header that lies must
  /// not make anybody allocate.
  void require_room(const PlyElement& element) const;
  std::size_t bytes_left() const;
  /// After the last value: bytes that belong to nothing, but for blanks at the end of a text.
  std::size_t bytes_over();

  /// Throws Error(bad_input) that names the line, or the element's number where the file is binary.
  [[noreturn]] void fail(std::string_view expected, std::string_view got) const;
  /// Which one is being read, for fail().
  void at(std::string_view element, std::size_t index) {
    element_ = element;
    index_ = index;
  }

 private:
  PlyEncoding encoding_;
  std::string file_name_;
  TextLines lines_;          // in text
  std::string_view binary_;  // what is left of it
  std::string_view element_;
  std::size_t index_ = 0;
};

}  // namespace offing::meshes

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace offing::meshes {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };
enum class PlyEncoding { text, little_endian, big_endian };

std::size_t bytes_of(PlyType type);

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  ///< of a list: the whole number before its values
};

struct PlyElement {
  std::string name;
  std::size_t count = 0;
  std::vector<PlyProperty> properties;  ///< never empty where count > 0
};

struct PlyHeader {
  PlyEncoding encoding = PlyEncoding::text;
  std::vector<PlyElement> elements;
  std::size_t bytes = 0;  ///< where the values begin
  std::size_t lines = 0;  ///< of the header
};

/// The header of a PLY. Throws Error(bad_input) with the line for what is none, and for properties of an
/// element with the same name. Counts are what the file says: they may lie.
PlyHeader parse_ply_header(std::string_view text, std::string_view file_name);

}  // namespace offing::meshes

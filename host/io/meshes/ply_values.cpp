#include "host/io/meshes/ply_values.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::meshes {
namespace {

static_assert(std::endian::native == std::endian::little, "numbers are taken as they lie in memory");

template <typename Value>
double value_of(const std::array<char, 8>& bytes) {
  Value value;
  std::memcpy(&value, bytes.data(), sizeof(value));
  return static_cast<double>(value);
}

double value_of(PlyType type, const std::array<char, 8>& bytes) {
  switch (type) {
    case PlyType::int8:
      return value_of<std::int8_t>(bytes);
    case PlyType::uint8:
      return value_of<std::uint8_t>(bytes);
    case PlyType::int16:
      return value_of<std::int16_t>(bytes);
    case PlyType::uint16:
      return value_of<std::uint16_t>(bytes);
    case PlyType::int32:
      return value_of<std::int32_t>(bytes);
    case PlyType::uint32:
      return value_of<std::uint32_t>(bytes);
    case PlyType::float32:
      return value_of<float>(bytes);
    case PlyType::float64:
      break;
  }
  return value_of<double>(bytes);
}

}  // namespace

PlyValues::PlyValues(std::string_view text, std::string_view file_name, const PlyHeader& header)
    : encoding_(header.encoding),
      file_name_(file_name),
      lines_(text.substr(header.bytes), file_name, header.lines),
      binary_(text.substr(header.bytes)) {}

double PlyValues::next(PlyType type) {
  if (encoding_ == PlyEncoding::text) {
    if (lines_.is_at_end() && !lines_.next_line()) fail("more values", "the end of the file");
    return lines_.number("a number");
  }
  const std::size_t size = bytes_of(type);
  if (binary_.size() < size) fail("more values", "the end of the file");
  std::array<char, 8> bytes{};
  std::memcpy(bytes.data(), binary_.data(), size);
  binary_.remove_prefix(size);
  if (encoding_ == PlyEncoding::big_endian)
    std::reverse(bytes.begin(), bytes.begin() + static_cast<int>(size));
  return value_of(type, bytes);
}

std::size_t PlyValues::next_length(const PlyProperty& list) {
  const double length = next(*list.count_type);
  const std::size_t least_bytes = encoding_ == PlyEncoding::text ? 2 : bytes_of(list.type);
  // In a text the last value may end without a blank.
  if (!(length >= 0.0) || length != std::floor(length) ||
      length > static_cast<double>((bytes_left() + 1) / least_bytes)) {
    fail(fmt::format("a length of {} that the file holds", printable(list.name)),
         fmt::format("{:g}", length));
  }
  return static_cast<std::size_t>(length);
}

void PlyValues::skip(const PlyProperty& property) {
  const std::size_t count = property.count_type ? next_length(property) : 1;
  for (std::size_t i = 0; i < count; ++i) next(property.type);
}

void PlyValues::require_room(const PlyElement& element) const {
  std::size_t least_bytes = 0;
  for (const PlyProperty& property : element.properties) {
    least_bytes += encoding_ == PlyEncoding::text ? 2 : bytes_of(property.count_type.value_or(property.type));
  }
  if (element.count == 0 || element.count <= (bytes_left() + 1) / least_bytes) return;
  throw mesh_error(file_name_, 0, fmt::format("{} of the element {}", element.count, printable(element.name)),
                   fmt::format("a file with room for {}", bytes_left() / least_bytes));
}

std::size_t PlyValues::bytes_left() const {
  return encoding_ == PlyEncoding::text ? lines_.bytes_left() : binary_.size();
}

std::size_t PlyValues::bytes_over() {
  if (encoding_ != PlyEncoding::text) return binary_.size();
  return lines_.is_at_end() && !lines_.next_line() ? 0 : lines_.bytes_left();
}

void PlyValues::fail(std::string_view expected, std::string_view got) const {
  if (encoding_ == PlyEncoding::text) lines_.fail(expected, got);
  throw mesh_error(fmt::format("{}: {} {}", file_name_, printable(element_), index_), 0, expected, got);
}

}  // namespace offing::meshes

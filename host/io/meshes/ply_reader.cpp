#include "host/io/meshes/ply_reader.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/meshes/text_lines.h"

namespace offing::meshes {
namespace {

constexpr std::size_t most_names = 1000;  // a header that never ends takes no time

struct NamedType {
  std::string_view name, other_name;
  PlyType type;
};

constexpr std::array<NamedType, 8> types = {{{"char", "int8", PlyType::int8},
                                             {"uchar", "uint8", PlyType::uint8},
                                             {"short", "int16", PlyType::int16},
                                             {"ushort", "uint16", PlyType::uint16},
                                             {"int", "int32", PlyType::int32},
                                             {"uint", "uint32", PlyType::uint32},
                                             {"float", "float32", PlyType::float32},
                                             {"double", "float64", PlyType::float64}}};

/// "comment" and "obj_info" lines may hold a #, which TextLines takes for the begin of a comment: no matter.
class HeaderParser {
 public:
  HeaderParser(std::string_view text, std::string_view file_name) : text_(text), lines_(text, file_name) {}

  PlyHeader parse() {
    lines_.need_line("ply");
    if (const std::string_view first = lines_.word(); first != "ply") fail("ply in the first line", first);
    bool has_format = false;
    for (;;) {
      lines_.need_line("end_header");
      const std::string_view keyword = lines_.word();
      if (keyword == "end_header") {
        if (!lines_.is_at_end()) fail("nothing after end_header", lines_.word());
        break;
      }
      if (keyword == "comment" || keyword == "obj_info") continue;
      if (keyword == "format") {
        read_format();
        has_format = true;
      } else if (keyword == "element") {
        read_element();
      } else if (keyword == "property") {
        read_property();
      } else {
        fail("a line of a PLY header", keyword);
      }
      if (!lines_.is_at_end()) fail(fmt::format("the end of the line after {}", keyword), lines_.word());
    }
    if (!has_format) lines_.fail("a format line in the header", "none");
    for (const PlyElement& element : header_.elements) {
      if (element.count > 0 && element.properties.empty()) {
        lines_.fail(fmt::format("properties of the element {}", printable(element.name)), "none");
      }
    }
    header_.bytes = text_.size() - lines_.bytes_left();
    header_.lines = lines_.line_number();
    return std::move(header_);
  }

 private:
  [[noreturn]] void fail(std::string_view expected, std::string_view word) const {
    lines_.fail(expected, word.empty() ? "the end of the line" : '"' + printable(word) + '"');
  }

  void read_format() {
    const std::string_view name = lines_.word();
    if (name == "ascii") {
      header_.encoding = PlyEncoding::text;
    } else if (name == "binary_little_endian") {
      header_.encoding = PlyEncoding::little_endian;
    } else if (name == "binary_big_endian") {
      header_.encoding = PlyEncoding::big_endian;
    } else {
      fail("ascii, binary_little_endian or binary_big_endian", name);
    }
    if (const std::string_view version = lines_.word(); version != "1.0") fail("version 1.0", version);
  }

  void read_element() {
    const std::string_view name = lines_.word();
    const std::int64_t count = lines_.whole("a count of elements");
    if (count < 0) lines_.fail("a count of elements", fmt::format("{}", count));
    if (header_.elements.size() == most_names) lines_.fail("at most 1000 elements", "more");
    header_.elements.push_back({std::string(name), static_cast<std::size_t>(count), {}});
  }

  PlyType read_type() {
    const std::string_view name = lines_.word();
    const auto* const found = std::find_if(types.begin(), types.end(), [&](const NamedType& candidate) {
      return name == candidate.name || name == candidate.other_name;
    });
    if (found == types.end()) fail("a type such as float, uchar or int", name);
    return found->type;
  }

  void read_property() {
    if (header_.elements.empty()) lines_.fail("an element before its properties", "a property");
    PlyProperty property;
    if (TextLines ahead = lines_; ahead.word() == "list") {
      lines_ = ahead;
      property.count_type = read_type();
      if (*property.count_type == PlyType::float32 || *property.count_type == PlyType::float64) {
        lines_.fail("a whole-numbered type for the length of a list", "a real one");
      }
    }
    property.type = read_type();
    property.name = lines_.word();
    if (property.name.empty()) fail("the name of a property", "");
    std::vector<PlyProperty>& known = header_.elements.back().properties;
    if (known.size() == most_names) lines_.fail("at most 1000 properties of an element", "more");
    if (std::any_of(known.begin(), known.end(), [&](const auto& p) { return p.name == property.name; })) {
      fail("names of properties that differ", property.name);
    }
    known.push_back(std::move(property));
  }

  std::string_view text_;
  TextLines lines_;
  PlyHeader header_;
};

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

std::size_t bytes_of(PlyType type) {
  switch (type) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::int32:
    case PlyType::uint32:
    case PlyType::float32:
      return 4;
    case PlyType::float64:
      break;
  }
  return 8;
}

PlyHeader parse_ply_header(std::string_view text, std::string_view file_name) {
  return HeaderParser(text, file_name).parse();
}

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

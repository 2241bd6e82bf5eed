#include "host/io/meshes/stl_mesh.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/vec3.hpp>

#include "host/base/error.h"
#include "host/base/mesh_neighbours.h"
#include "host/io/file_mark.h"
#include "host/io/meshes/polygon_soup.h"
#include "host/io/meshes/text_lines.h"

namespace offing::meshes {
namespace {

constexpr std::size_t header_bytes = 84, facet_bytes = 50;

std::uint32_t facet_count(std::string_view bytes) {
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + header_bytes - sizeof(count), sizeof(count));
  return count;
}

bool is_text(std::string_view bytes) {
  if (bytes.size() >= header_bytes && bytes.size() == header_bytes + facet_bytes * facet_count(bytes))
    return false;
  std::string_view begin = without_byte_order_mark(bytes.substr(0, 4096));
  begin.remove_prefix(std::min(begin.find_first_not_of(" \t\r\n"), begin.size()));
  return begin.starts_with("solid") &&
         (begin.find("facet") != std::string_view::npos || begin.find("endsolid") != std::string_view::npos);
}

/// Three corners a facet.
using Corners = std::vector<glm::dvec3>;

class TextStl {
 public:
  TextStl(std::string_view text, std::string_view file_name) : lines_(text, file_name) {}

  Corners parse() {
    while (lines_.next_line()) {
      expect("solid");
      pass_over_line();
      for (;;) {
        lines_.need_line("facet or endsolid");
        const std::string_view word = lines_.word();
        if (word == "endsolid") break;
        if (word != "facet") fail("facet or endsolid", word);
        read_facet();
      }
      pass_over_line();
    }
    return std::move(corners_);
  }

 private:
  [[noreturn]] void fail(std::string_view expected, std::string_view word) const {
    lines_.fail(expected, '"' + printable(word) + '"');
  }

  void expect(std::string_view expected) {
    if (const std::string_view word = lines_.word(); word != expected) fail(expected, word);
  }

  void pass_over_line() {
    while (!lines_.is_at_end()) lines_.word();
  }

  void expect_line(std::string_view first, std::string_view second = {}) {
    lines_.need_line(first);
    expect(first);
    if (!second.empty()) expect(second);
    if (!lines_.is_at_end()) fail("the end of the line", lines_.word());
  }

  void read_facet() {
    pass_over_line();  // the normal, often a NaN
    expect_line("outer", "loop");
    for (int i = 0; i < 3; ++i) {
      lines_.need_line("vertex");
      expect("vertex");
      glm::dvec3 corner;
      for (int axis = 0; axis < 3; ++axis) corner[axis] = lines_.number("a corner: x y z");
      if (!lines_.is_at_end()) fail("three numbers in a corner", lines_.word());
      corners_.push_back(corner);
    }
    expect_line("endloop");
    expect_line("endfacet");
  }

  TextLines lines_;
  Corners corners_;
};

Corners parse_binary(std::string_view bytes, std::string_view file_name, PolygonSoup& soup) {
  if (bytes.size() < header_bytes) {
    throw mesh_error(file_name, 0, "an STL: solid, or a header of 84 bytes",
                     fmt::format("{} bytes", bytes.size()));
  }
  const std::size_t count = facet_count(bytes), room = (bytes.size() - header_bytes) / facet_bytes;
  if (count > room) {
    throw mesh_error(file_name, 0, fmt::format("{} facets", count),
                     fmt::format("a file with room for {}", room));
  }
  soup.leave_out("bytes after the end", bytes.size() - header_bytes - facet_bytes * count);
  Corners corners;
  corners.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i) {
    std::array<float, 12> numbers;  // normal, corners
    std::memcpy(numbers.data(), bytes.data() + header_bytes + facet_bytes * i, sizeof(numbers));
    for (std::size_t corner = 3; corner < 12; corner += 3) {
      corners.emplace_back(numbers[corner], numbers[corner + 1], numbers[corner + 2]);
    }
  }
  return corners;
}

void add_facets(const Corners& corners, std::string_view file_name, PolygonSoup& soup) {
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& p = corners[i];
    // What is no number is at no place.
    if (p.x == p.x && p.y == p.y && p.z == p.z) continue;
    throw mesh_error(file_name, 0, fmt::format("numbers in facet {}", i / 3), "a NaN");
  }
  const std::vector<std::uint32_t> first = first_at_place(corners);
  std::vector<std::uint32_t> numbers(corners.size());
  for (std::uint32_t i = 0; i < corners.size(); ++i) {
    if (first[i] == i) {
      numbers[i] = static_cast<std::uint32_t>(soup.positions_m.size());
      soup.positions_m.push_back(corners[i]);
    } else {
      numbers[i] = numbers[first[i]];
      ++soup.report.merged_corners;
    }
    if (i % 3 == 2) soup.add_face(std::span(numbers).subspan(i - 2, 3));
  }
}

}  // namespace

MeshFile parse_stl(std::string_view bytes, std::string_view file_name) {
  PolygonSoup soup(file_name);
  const bool is_words = is_text(bytes);
  soup.report.format = is_words ? "STL, text" : "STL, binary";
  const Corners corners = is_words ? TextStl(bytes, file_name).parse() : parse_binary(bytes, file_name, soup);
  if (corners.size() > most_vertices) throw mesh_error(file_name, 0, "fewer than 2^32 corners", "more");
  add_facets(corners, file_name, soup);
  return std::move(soup).finish();
}

}  // namespace offing::meshes

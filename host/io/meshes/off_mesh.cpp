#include "host/io/meshes/off_mesh.h"

#include <cstdint>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/meshes/polygon_soup.h"
#include "host/io/meshes/text_lines.h"

namespace offing::meshes {
namespace {

/// What stands behind the position of a vertex.
struct VertexFields {
  enum class Presence { absent, present };
  Presence normal = Presence::absent, colour = Presence::absent, texture = Presence::absent;
};

bool take_prefix(std::string_view& word, std::string_view prefix) {
  if (!word.starts_with(prefix)) return false;
  word.remove_prefix(prefix.size());
  return true;
}

class OffParser {
 public:
  OffParser(std::string_view text, std::string_view file_name) : lines_(text, file_name), soup_(file_name) {
    soup_.report.format = "OFF";
  }

  MeshFile parse() {
    lines_.need_line("OFF and the counts of vertices and faces");
    read_keyword();
    const std::size_t vertices = read_count("the count of vertices"),
                      faces = read_count("the count of faces");
    if (!lines_.is_at_end()) lines_.whole("the count of edges, a whole number");
    if (!lines_.is_at_end()) lines_.fail("three counts: of vertices, faces, edges", "more");
    // A line takes two bytes: a count that the file cannot hold allocates nothing.
    if (vertices <= lines_.bytes_left() / 2) soup_.positions_m.reserve(vertices);
    for (std::size_t i = 0; i < vertices; ++i) read_vertex(i, vertices);
    for (std::size_t i = 0; i < faces; ++i) read_face(i, faces);
    if (lines_.next_line()) lines_.fail(fmt::format("the end after {} faces", faces), "more");
    return std::move(soup_).finish();
  }

 private:
  void read_keyword() {
    TextLines ahead = lines_;
    std::string_view word = ahead.word();
    if (!is_off_keyword(word)) return;  // counts at once
    lines_ = ahead;
    using enum VertexFields::Presence;
    if (take_prefix(word, "ST")) fields_.texture = present;
    if (take_prefix(word, "C")) fields_.colour = present;
    if (take_prefix(word, "N")) fields_.normal = present;
    if (word != "OFF") lines_.fail("OFF in three dimensions", '"' + printable(word) + '"');
    if (lines_.is_at_end()) {
      lines_.need_line("the counts of vertices and faces");
    } else if (TextLines next = lines_; next.word() == "BINARY") {
      lines_.fail("OFF in text", "its binary kind");
    }
  }

  std::size_t read_count(std::string_view expected) {
    const std::int64_t count = lines_.whole(expected);
    if (count < 0 || count > static_cast<std::int64_t>(most_vertices)) {
      lines_.fail(fmt::format("{} within 0 ... 2^32 - 1", expected), fmt::format("{}", count));
    }
    return static_cast<std::size_t>(count);
  }

  glm::dvec3 read_vector(std::string_view expected) {
    glm::dvec3 vector;
    for (int axis = 0; axis < 3; ++axis) vector[axis] = lines_.number(expected);
    return vector;
  }

  void read_vertex(std::size_t index, std::size_t count) {
    if (!lines_.next_line()) {
      lines_.fail(fmt::format("{} vertices", count), fmt::format("the end of the file after {}", index));
    }
    using enum VertexFields::Presence;
    soup_.positions_m.push_back(read_vector("a vertex: x y z"));
    if (fields_.normal == present) soup_.normals.push_back(read_vector("a normal: three numbers"));
    if (lines_.is_at_end()) return;
    // Colours come without being announced, too.
    const bool is_texture_alone = fields_.texture == present && fields_.colour == absent;
    soup_.leave_out(is_texture_alone ? "texture coordinates of vertices" : "colours of vertices");
    constexpr int most_more = 6;
    for (int more = 0; !lines_.is_at_end(); ++more) {
      if (more == most_more) lines_.fail("one vertex per line", "more");
      lines_.number("a number");
    }
  }

  void read_face(std::size_t index, std::size_t count) {
    if (!lines_.next_line()) {
      lines_.fail(fmt::format("{} faces", count), fmt::format("the end of the file after {}", index));
    }
    const std::int64_t size = lines_.whole("a count of corners");
    if (size < 0) lines_.fail("a count of corners", fmt::format("{}", size));
    corners_.clear();
    for (std::int64_t i = 0; i < size; ++i) {
      if (lines_.is_at_end()) {
        lines_.fail(fmt::format("{} corners in a line", size), fmt::format("{}", i));
      }
      const std::int64_t corner = lines_.whole("a vertex number");
      if (corner < 0 || corner >= static_cast<std::int64_t>(soup_.positions_m.size())) {
        lines_.fail(fmt::format("vertex numbers within 0 ... {}", soup_.positions_m.size() - 1),
                    fmt::format("{}", corner));
      }
      corners_.push_back(static_cast<std::uint32_t>(corner));
    }
    soup_.add_face(corners_);
    if (lines_.is_at_end()) return;
    soup_.leave_out("colours of faces");
    while (!lines_.is_at_end()) lines_.number("a number of a colour");
  }

  TextLines lines_;
  PolygonSoup soup_;
  VertexFields fields_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

bool is_off_keyword(std::string_view word) {
  return word.size() <= 8 && word.ends_with("OFF");
}

MeshFile parse_off(std::string_view text, std::string_view file_name) {
  return OffParser(text, file_name).parse();
}

}  // namespace offing::meshes

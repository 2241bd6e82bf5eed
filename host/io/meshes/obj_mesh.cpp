#include "host/io/meshes/obj_mesh.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdint>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/meshes/polygon_soup.h"
#include "host/io/meshes/text_lines.h"

namespace offing::meshes {
namespace {

constexpr std::uint32_t none = 0xffffffff;

/// Statements that say nothing about vertices and faces: names, groups, materials, display, and what belongs
/// to free-form geometry.
constexpr std::array<std::string_view, 35> passed_over = {
    "vp",       "g",        "o",          "s",         "mg",    "usemtl", "mtllib", "usemap", "maplib",
    "bevel",    "lod",      "cstype",     "deg",       "bmat",  "step",   "parm",   "trim",   "hole",
    "scrv",     "sp",       "end",        "con",       "bsp",   "bzp",    "cdc",    "cdp",    "res",
    "c_interp", "d_interp", "shadow_obj", "trace_obj", "ctech", "stech",  "call"};

constexpr std::array<std::string_view, 3> free_forms = {"curv", "curv2", "surf"};

template <std::size_t count>
bool contains(const std::array<std::string_view, count>& words, std::string_view word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

/// An index of the file before all vertices are known: from 0 on.
struct HighestIndex {
  std::uint32_t index = 0;
  std::size_t line_number = 0;
};

struct Corner {
  std::uint32_t vertex, normal;
};

class ObjParser {
 public:
  ObjParser(std::string_view text, std::string_view file_name)
      : file_name_(file_name), lines_(text, file_name), soup_(file_name) {
    soup_.report.format = "OBJ";
  }

  MeshFile parse() {
    while (lines_.next_line()) statement(lines_.word());
    check(highest_corner_, soup_.positions_m.size(), "vertices (v)");
    check(highest_normal_, normals_.size(), "normals (vn)");
    give_normals();
    return std::move(soup_).finish();
  }

 private:
  void statement(std::string_view keyword) {
    if (keyword == "v") {
      read_vertex();
    } else if (keyword == "vn") {
      normals_.push_back(read_vector("a normal: three numbers"));
      if (!lines_.is_at_end()) lines_.fail("three numbers in a normal", "more");
    } else if (keyword == "f" || keyword == "fo") {
      read_face();
    } else if (keyword == "vt") {
      leave_out("texture coordinates");
    } else if (keyword == "l") {
      leave_out("lines");
    } else if (keyword == "p") {
      leave_out("points");
    } else if (contains(free_forms, keyword)) {
      leave_out("free-form curves and surfaces");
    } else if (contains(passed_over, keyword)) {
      pass_over();
    } else {
      lines_.fail("a statement of an OBJ such as v, vn or f", '"' + printable(keyword) + '"');
    }
  }

  void leave_out(std::string_view what) {
    soup_.leave_out(what);
    pass_over();
  }

  void pass_over() {
    while (!lines_.is_at_end()) next_word();
  }

  /// A statement goes on in the next line where a backslash ends this one. Empty for a lone backslash.
  std::string_view next_word() {
    std::string_view word = lines_.word();
    if (lines_.is_at_end() && word.ends_with('\\')) {
      word.remove_suffix(1);
      lines_.need_line("the rest of a statement");
    }
    return word;
  }

  glm::dvec3 read_vector(std::string_view expected) {
    glm::dvec3 vector;
    for (int axis = 0; axis < 3; ++axis) vector[axis] = lines_.number(expected);
    return vector;
  }

  /// Behind x y z there may be a weight, or a colour.
  void read_vertex() {
    if (soup_.positions_m.size() == most_vertices) lines_.fail("fewer than 2^32 vertices", "more");
    soup_.positions_m.push_back(read_vector("a vertex: x y z"));
    constexpr int most_more = 5;
    int more = 0;
    for (; !lines_.is_at_end(); ++more) {
      if (more == most_more) lines_.fail("at most eight numbers in a vertex", "more");
      lines_.number("numbers in a vertex");
    }
    if (more >= 3) soup_.leave_out("vertex colours");
  }

  void read_face() {
    corners_.clear();
    corner_normals_.clear();
    while (!lines_.is_at_end()) {
      if (const std::string_view word = next_word(); !word.empty()) read_corner(word);
    }
    soup_.add_face(corners_);
    if (corners_.size() < 3) return;
    vertex_normals_.resize(soup_.positions_m.size(), none);
    for (std::size_t i = 0; i < corners_.size(); ++i) note_normal({corners_[i], corner_normals_[i]});
  }

  /// v, v/vt, v//vn or v/vt/vn.
  void read_corner(std::string_view word) {
    const std::string_view whole_word = word;
    corners_.push_back(take_index(word, whole_word, soup_.positions_m.size(), highest_corner_));
    corner_normals_.push_back(none);
    if (word.empty()) return;
    word.remove_prefix(1);
    if (!word.starts_with('/')) {
      HighestIndex of_no_interest;
      take_index(word, whole_word, most_vertices, of_no_interest);
      if (word.empty()) return;
    }
    word.remove_prefix(1);
    corner_normals_.back() = take_index(word, whole_word, normals_.size(), highest_normal_);
    if (!word.empty()) bad_corner(whole_word);
  }

  /// Takes an index off the front of `rest`, which then is empty or begins with a slash.
  std::uint32_t take_index(std::string_view& rest, std::string_view whole_word, std::size_t count,
                           HighestIndex& highest) {
    std::int64_t number = 0;
    const auto [end, status] = std::from_chars(rest.data(), rest.data() + rest.size(), number);
    rest.remove_prefix(static_cast<std::size_t>(end - rest.data()));
    const auto last = static_cast<std::int64_t>(count);
    if (status != std::errc() || (!rest.empty() && rest[0] != '/')) bad_corner(whole_word);
    if (number == 0 || number < -last || number > static_cast<std::int64_t>(most_vertices)) {
      lines_.fail(fmt::format("indices from 1 on, or down to -{} from the last", count),
                  '"' + printable(whole_word) + '"');
    }
    const auto index = static_cast<std::uint32_t>(number > 0 ? number - 1 : last + number);
    if (highest.line_number == 0 || index > highest.index) highest = {index, lines_.line_number()};
    return index;
  }

  [[noreturn]] void bad_corner(std::string_view word) const {
    lines_.fail("corners such as 7, 7/2, 7//5 or 7/2/5", '"' + printable(word) + '"');
  }

  void check(const HighestIndex& highest, std::size_t count, std::string_view of_what) const {
    if (highest.line_number == 0 || highest.index < count) return;
    throw mesh_error(file_name_, highest.line_number, fmt::format("indices up to {}, the {}", count, of_what),
                     fmt::format("{}", std::uint64_t{highest.index} + 1));
  }

  /// A vertex keeps its normal while all its corners agree. Vertices that are still to come have to wait: an
  /// index may be any number.
  void note_normal(const Corner& corner) {
    corners_without_normal_ += corner.normal == none;
    if (corner.vertex >= vertex_normals_.size()) {
      early_.push_back(corner);
      return;
    }
    std::uint32_t& noted = vertex_normals_[corner.vertex];
    if (noted == none) {
      noted = corner.normal;
    } else if (noted != corner.normal) {
      differing_.push_back({noted, corner.normal});
    }
  }

  void give_normals() {
    if (normals_.empty()) return;
    vertex_normals_.resize(soup_.positions_m.size(), none);
    for (const Corner& corner : early_) note_normal(corner);
    // Exporters repeat equal normals under numbers of their own.
    const bool all_agree = std::all_of(differing_.begin(), differing_.end(), [&](const auto& pair) {
      return pair[0] != none && pair[1] != none && normals_[pair[0]] == normals_[pair[1]];
    });
    // Vertices without a face have the normal of their own number, if the file counts them alike.
    if (normals_.size() == vertex_normals_.size()) {
      for (std::uint32_t i = 0; i < vertex_normals_.size(); ++i) {
        if (vertex_normals_[i] == none) vertex_normals_[i] = i;
      }
    }
    const bool all_have_one =
        std::find(vertex_normals_.begin(), vertex_normals_.end(), none) == vertex_normals_.end();
    if (!all_agree || !all_have_one || corners_without_normal_ > 0) {
      soup_.leave_out("normals, since some vertices have none or several", normals_.size());
      return;
    }
    soup_.normals.reserve(vertex_normals_.size());
    for (const std::uint32_t normal : vertex_normals_) soup_.normals.push_back(normals_[normal]);
  }

  std::string_view file_name_;
  TextLines lines_;
  PolygonSoup soup_;
  std::vector<glm::dvec3> normals_;
  std::vector<std::uint32_t> corners_, corner_normals_;  // of the face at hand
  std::vector<std::uint32_t> vertex_normals_;            // the first normal of each vertex
  std::vector<std::array<std::uint32_t, 2>> differing_;  // pairs of normals that one vertex has
  std::vector<Corner> early_;                            // before their vertex
  std::size_t corners_without_normal_ = 0;
  HighestIndex highest_corner_, highest_normal_;
};

}  // namespace

MeshFile parse_obj(std::string_view text, std::string_view file_name) {
  return ObjParser(text, file_name).parse();
}

}  // namespace offing::meshes

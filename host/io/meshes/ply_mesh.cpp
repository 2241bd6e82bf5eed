#include "host/io/meshes/ply_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "host/io/meshes/ply_reader.h"
#include "host/io/meshes/polygon_soup.h"

namespace offing::meshes {
namespace {

std::string format_name(PlyEncoding encoding) {
  switch (encoding) {
    case PlyEncoding::text:
      return "PLY, text";
    case PlyEncoding::little_endian:
      return "PLY, binary little-endian";
    case PlyEncoding::big_endian:
      break;
  }
  return "PLY, binary big-endian";
}

std::optional<std::size_t> find(const PlyElement& element, std::string_view name) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    if (element.properties[i].name == name && !element.properties[i].count_type) return i;
  }
  return std::nullopt;
}

/// What a property beside places, normals and lists of corners says, for the list of what is left out.
std::string_view kind_of(std::string_view property) {
  constexpr std::array colours{"red", "green", "blue", "alpha", "r", "g", "b", "a"};
  constexpr std::array places{"s", "t", "u", "v", "texture_u", "texture_v", "texcoord"};
  const std::size_t prefix = property.find('_');
  if (std::find(colours.begin(), colours.end(), property) != colours.end() ||
      (prefix != std::string_view::npos &&
       std::find(colours.begin(), colours.begin() + 4, property.substr(prefix + 1)) != colours.begin() + 4)) {
    return "colours";
  }
  return std::find(places.begin(), places.end(), property) != places.end() ? "texture coordinates"
                                                                           : "other values";
}

class PlyParser {
 public:
  PlyParser(std::string_view text, std::string_view file_name, std::span<const std::string_view> wanted)
      : file_name_(file_name),
        header_(parse_ply_header(text, file_name)),
        values_(text, file_name, header_),
        wanted_(wanted),
        columns_(wanted.size()),
        soup_(file_name) {
    soup_.report.format = format_name(header_.encoding);
  }

  PlyMesh parse() {
    for (const PlyElement& element : header_.elements) {
      values_.at(element.name, 0);
      values_.require_room(element);
      if (element.name == "vertex") {
        read_vertices(element);
      } else if (element.name == "face") {
        read_lists(element, &PlyParser::add_face);
      } else if (element.name == "tristrips") {
        read_lists(element, &PlyParser::add_strips);
      } else {
        pass_over(element);
      }
    }
    soup_.leave_out("bytes after the end", values_.bytes_over());
    return {std::move(soup_).finish(), std::move(columns_)};
  }

 private:
  using AddList = void (PlyParser::*)(std::span<const double>);

  /// Counts each kind of properties that nobody reads once for each of the element.
  void leave_out_unread(const PlyElement& element, std::string_view owners,
                        const std::vector<std::size_t>& read) {
    std::set<std::string_view> kinds;
    for (std::size_t i = 0; i < element.properties.size(); ++i) {
      if (std::find(read.begin(), read.end(), i) == read.end())
        kinds.insert(kind_of(element.properties[i].name));
    }
    if (element.count == 0) return;
    for (const std::string_view kind : kinds)
      soup_.leave_out(fmt::format("{} of {}", kind, owners), element.count);
  }

  void pass_over(const PlyElement& element) {
    if (element.name == "edge") soup_.leave_out("edges", element.count);
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.at(element.name, i);
      for (const PlyProperty& property : element.properties) values_.skip(property);
    }
  }

  std::array<std::size_t, 3> need_xyz(const PlyElement& element) const {
    std::array<std::size_t, 3> indices{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::string_view name = std::string_view("xyz").substr(axis, 1);
      const std::optional<std::size_t> found = find(element, name);
      if (!found) {
        throw mesh_error(file_name_, 0, fmt::format("vertices with a property {}", name),
                         "no property of this name");
      }
      indices[axis] = *found;
    }
    return indices;
  }

  void read_vertices(const PlyElement& element) {
    if (!soup_.positions_m.empty()) throw mesh_error(file_name_, 0, "one element vertex", "two");
    if (element.count > most_vertices) throw mesh_error(file_name_, 0, "fewer than 2^32 vertices", "more");
    const std::array<std::size_t, 3> xyz = need_xyz(element);
    const std::array<std::optional<std::size_t>, 3> normal = {find(element, "nx"), find(element, "ny"),
                                                              find(element, "nz")};
    const bool has_normals = normal[0] && normal[1] && normal[2];
    std::vector<std::optional<std::size_t>> sources;
    for (const std::string_view name : wanted_) sources.push_back(find(element, name));
    std::vector<std::size_t> read(xyz.begin(), xyz.end());
    if (has_normals) read.insert(read.end(), {*normal[0], *normal[1], *normal[2]});
    for (const auto& source : sources) {
      if (source) read.push_back(*source);
    }
    leave_out_unread(element, "vertices", read);
    soup_.positions_m.reserve(element.count);
    std::vector<double> row(element.properties.size());
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.at(element.name, i);
      for (std::size_t p = 0; p < row.size(); ++p) {
        const PlyProperty& property = element.properties[p];
        if (property.count_type) {
          values_.skip(property);
        } else {
          row[p] = values_.next(property.type);
        }
      }
      soup_.positions_m.emplace_back(row[xyz[0]], row[xyz[1]], row[xyz[2]]);
      if (has_normals) soup_.normals.emplace_back(row[*normal[0]], row[*normal[1]], row[*normal[2]]);
      for (std::size_t w = 0; w < sources.size(); ++w) {
        if (sources[w]) columns_[w].push_back(row[*sources[w]]);
      }
    }
  }

  /// Calls `add` with the vertex numbers of each one of an element.
  void read_lists(const PlyElement& element, AddList add) {
    const auto is_list = [](const PlyProperty& property) {
      return property.count_type && (property.name == "vertex_indices" || property.name == "vertex_index");
    };
    const auto list = std::find_if(element.properties.begin(), element.properties.end(), is_list);
    if (element.count > 0 && list == element.properties.end()) {
      throw mesh_error(file_name_, 0, fmt::format("a list vertex_indices of each {}", element.name), "none");
    }
    leave_out_unread(element, "faces", {static_cast<std::size_t>(list - element.properties.begin())});
    std::vector<double> numbers;
    for (std::size_t i = 0; i < element.count; ++i) {
      values_.at(element.name, i);
      for (auto property = element.properties.begin(); property != element.properties.end(); ++property) {
        if (property != list) {
          values_.skip(*property);
          continue;
        }
        numbers.resize(values_.next_length(*property));
        for (double& number : numbers) number = values_.next(property->type);
      }
      (this->*add)(numbers);
    }
  }

  std::uint32_t vertex_number(double number) const {
    // The element vertex may come after the faces; what it holds is checked in the end.
    if (!(number >= 0.0) || number != std::floor(number) || number >= static_cast<double>(most_vertices)) {
      values_.fail("vertex numbers from 0 on", fmt::format("{:g}", number));
    }
    return static_cast<std::uint32_t>(number);
  }

  void add_face(std::span<const double> numbers) {
    corners_.clear();
    for (const double number : numbers) corners_.push_back(vertex_number(number));
    soup_.add_face(corners_);
  }

  /// Each number after two others makes a triangle with them, every second one the other way round.
  void add_strips(std::span<const double> numbers) {
    corners_.clear();
    bool is_turned = false;
    for (const double number : numbers) {
      if (number == -1.0) {
        corners_.clear();
        is_turned = false;
        continue;
      }
      corners_.push_back(vertex_number(number));
      if (corners_.size() < 3) continue;
      const std::array<std::uint32_t, 3> triangle = {corners_[is_turned ? 1 : 0], corners_[is_turned ? 0 : 1],
                                                     corners_[2]};
      soup_.add_face(triangle);
      corners_.erase(corners_.begin());
      is_turned = !is_turned;
    }
  }

  std::string_view file_name_;
  PlyHeader header_;
  PlyValues values_;
  std::span<const std::string_view> wanted_;
  std::vector<std::vector<double>> columns_;
  PolygonSoup soup_;
  std::vector<std::uint32_t> corners_;
};

}  // namespace

PlyMesh parse_ply(std::string_view text, std::string_view file_name,
                  std::span<const std::string_view> wanted) {
  return PlyParser(text, file_name, wanted).parse();
}

}  // namespace offing::meshes

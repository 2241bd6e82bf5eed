#include "host/io/meshes/polygon_soup.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/io/meshes/polygon_triangles.h"
#include "host/io/meshes/text_lines.h"

namespace offing::meshes {

void PolygonSoup::add_face(std::span<const std::uint32_t> corners) {
  ++report.file_faces;
  if (corners.size() < 3) {
    leave_out("faces of fewer than three corners");
    return;
  }
  corners_.insert(corners_.end(), corners.begin(), corners.end());
  sizes_.push_back(static_cast<std::uint32_t>(corners.size()));
}

void PolygonSoup::leave_out(std::string_view what, std::size_t count) {
  if (count == 0) return;
  const auto found = std::find_if(report.left_out.begin(), report.left_out.end(),
                                  [&](const LeftOut& item) { return item.what == what; });
  if (found != report.left_out.end()) {
    found->count += count;
  } else {
    report.left_out.push_back({std::string(what), count});
  }
}

MeshFile PolygonSoup::finish() && {
  check_positions();
  check_corners();
  keep_unit_normals();
  report.file_vertices = positions_m.size();
  std::vector<TriangleIndices> faces = cut_faces();
  return {{std::move(positions_m), std::move(normals), std::move(faces)}, std::move(report)};
}

void PolygonSoup::check_positions() const {
  const auto is_usable = [](double value) { return std::abs(value) <= farthest_vertex_m; };  // false of NaN
  for (std::size_t i = 0; i < positions_m.size(); ++i) {
    const glm::dvec3& p = positions_m[i];
    if (is_usable(p.x) && is_usable(p.y) && is_usable(p.z)) continue;
    throw mesh_error(file_name_, 0, "finite positions within 1e30",
                     fmt::format("vertex {} at ({:g}, {:g}, {:g})", i, p.x, p.y, p.z));
  }
}

void PolygonSoup::check_corners() const {
  if (sizes_.empty()) {
    throw mesh_error(file_name_, 0, "a mesh with faces",
                     report.file_faces == 0 ? fmt::format("{} vertices and no face", positions_m.size())
                                            : "no face of three corners or more");
  }
  const auto wrong = std::find_if(corners_.begin(), corners_.end(),
                                  [&](std::uint32_t corner) { return corner >= positions_m.size(); });
  if (wrong == corners_.end()) return;
  throw mesh_error(file_name_, 0, fmt::format("vertices 0 ... {} in faces", positions_m.size() - 1),
                   fmt::format("vertex {}", *wrong));
}

void PolygonSoup::keep_unit_normals() {
  for (glm::dvec3& normal : normals) {
    // The largest part first, so that no square is too large or too small for a double.
    const double largest = std::max({std::abs(normal.x), std::abs(normal.y), std::abs(normal.z)});
    const bool is_finite = std::isfinite(normal.x) && std::isfinite(normal.y) && std::isfinite(normal.z);
    if (!is_finite || largest == 0.0) {
      leave_out("normals, since some are no directions", normals.size());
      normals.clear();
      return;
    }
    normal = glm::normalize(normal / largest);
  }
}

std::vector<TriangleIndices> PolygonSoup::cut_faces() {
  std::vector<TriangleIndices> faces;
  faces.reserve(corners_.size() - 2 * sizes_.size());
  PolygonCutter cutter(positions_m);
  std::size_t begin = 0;
  for (const std::uint32_t size : sizes_) {
    const std::span corners = std::span(corners_).subspan(begin, size);
    if (size == 3) {
      faces.push_back({corners[0], corners[1], corners[2]});
    } else {
      ++report.polygons;
      if (!cutter.cut(corners, faces)) {
        throw mesh_error(file_name_, 0, "polygons that can be cut into triangles in seconds",
                         fmt::format("one with {} corners, after others as complex", size));
      }
    }
    begin += size;
  }
  corners_ = {};
  sizes_ = {};
  return faces;
}

}  // namespace offing::meshes

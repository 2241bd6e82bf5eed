#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "host/io/meshes/mesh_file.h"

namespace offing::meshes {

/// Farther from the origin than anything is, and near enough that products of four lengths stay finite.
inline constexpr double farthest_vertex_m = 1e30;

/// Vertices are numbered in 32 bits; the last number is left free for "none".
inline constexpr std::size_t most_vertices = 0xffffffff;

/// What a parser reads of a file: polygons by index, before they are cut into triangles.
class PolygonSoup {
 public:
  explicit PolygonSoup(std::string_view file_name) : file_name_(file_name) {}

  std::vector<glm::dvec3> positions_m;  ///< finite, within farthest_vertex_m
  std::vector<glm::dvec3> normals;      ///< one a vertex, of any length; empty if there are none
  MeshReport report;                    ///< format and merged corners are the parser's

  /// A face of the file; below three corners it is counted as left out. Corners are checked by finish().
  void add_face(std::span<const std::uint32_t> corners);
  /// Something of the file that a mesh cannot hold.
  void leave_out(std::string_view what, std::size_t count = 1);

  /// The mesh: faces in the order of the file, polygons cut by cut_polygon(), normals made unit vectors or
  /// all left out where one is none. Throws Error(bad_input) where there is no face, a corner is no vertex, a
  /// position is not usable, or polygons are too intricate (polygon_triangles.h).
  MeshFile finish() &&;

 private:
  void check_positions() const;
  void check_corners() const;
  void keep_unit_normals();
  std::vector<TriangleIndices> cut_faces();

  std::string file_name_;
  std::vector<std::uint32_t> corners_;  // of all faces, one after another
  std::vector<std::uint32_t> sizes_;    // corners of each face, at least 3
};

}  // namespace offing::meshes

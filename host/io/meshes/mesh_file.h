#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/base/triangle_mesh.h"

namespace offing {

/// Something that a file holds and a TriangleMesh cannot.
struct LeftOut {
  std::string what;  ///< plural: "lines", "faces of fewer than three corners"
  std::size_t count = 0;
};

/// What a mesh file held and what became of it. No face is lost without a line in left_out.
struct MeshReport {
  std::string format;              ///< "OBJ", "PLY, binary little-endian"
  std::size_t file_vertices = 0;   ///< as many as the mesh has, but for the corners of an STL
  std::size_t file_faces = 0;      ///< of any number of corners, left out ones included
  std::size_t polygons = 0;        ///< faces of more than three corners, cut into triangles
  std::size_t merged_corners = 0;  ///< corners of an STL that are vertices already
  std::vector<LeftOut> left_out;   ///< counts above 0
};

/// A mesh, and what reading it found.
struct MeshFile {
  TriangleMesh mesh;  ///< of a glTF at rest: without its animation
  MeshReport report;
  Deformation deformation = {};
};

}  // namespace offing

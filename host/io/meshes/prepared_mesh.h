#pragma once

#include <filesystem>

#include "host/base/triangle_mesh.h"
#include "host/io/meshes/write_mesh.h"

namespace offing {

/// A mesh with its curvatures, as `offing-mesh curvature` prepares it: a PLY whose vertices have, besides
/// x y z and nx ny nz, the properties k_max k_min (1/m, positive where convex), e_max_x/y/z, e_min_x/y/z,
/// area (m^2) and confidence (0 ... 1).
struct PreparedMesh {
  TriangleMesh mesh;  ///< with normals
  VertexCurvatures curvatures;
};

/// Writes a prepared mesh, which must have normals; `attributes` are written after the curvatures. Errors as
/// write_ply().
void write_prepared(const std::filesystem::path& path, const PreparedMesh& prepared,
                    const VertexAttributes& attributes = {}, Existing existing = Existing::replace);

/// Whether a file is a PLY with the first of these properties.
bool is_prepared(const std::filesystem::path& path);

/// Reads a prepared mesh. Throws Error(bad_input) for what read_mesh() refuses, for one that lacks a property
/// or its normals, and for values that break what VertexCurvatures promises. Directions are made unit vectors
/// again: floats hold them to 1e-7.
PreparedMesh read_prepared(const std::filesystem::path& path);

}  // namespace offing

#pragma once

#include <filesystem>
#include <vector>

namespace offing {

/// A regular grid of vertices, each cell two triangles that are anticlockwise seen from +y.
struct GridMesh {
  int columns = 0, rows = 0;         ///< vertices along x and z, at least 2
  std::vector<float> positions_xyz;  ///< [rows][columns][3] m
  std::vector<float> normals_xyz;    ///< [rows][columns][3] unit vectors
};

/// Writes a Wavefront OBJ (text; every number reads back to the same float), atomically.
/// Throws Error(bad_input) if the arrays do not match the size or hold a NaN or an infinity, Error(file) if
/// it cannot be written.
void write_obj(const std::filesystem::path& path, const GridMesh& mesh);

/// Writes a binary little-endian PLY with x y z nx ny nz and a triangle list, atomically. Errors as
/// write_obj.
void write_ply(const std::filesystem::path& path, const GridMesh& mesh);

}  // namespace offing

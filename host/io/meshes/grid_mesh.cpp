#include "host/io/meshes/grid_mesh.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/triangle_mesh.h"
#include "host/io/meshes/obj_writer.h"
#include "host/io/meshes/ply_writer.h"

namespace offing {
namespace {

void check(const std::filesystem::path& path, const GridMesh& mesh) {
  const std::size_t numbers =
      mesh.columns < 2 || mesh.rows < 2
          ? 0
          : std::size_t{3} * static_cast<unsigned>(mesh.columns) * static_cast<unsigned>(mesh.rows);
  // Readers hold vertex numbers in 32-bit signed integers.
  if (numbers == 0 || numbers / 3 > INT32_MAX || mesh.positions_xyz.size() != numbers ||
      mesh.normals_xyz.size() != numbers) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: cannot write a grid of {}x{} vertices from {} positions and {} normals",
                            path.string(), mesh.columns, mesh.rows, mesh.positions_xyz.size() / 3,
                            mesh.normals_xyz.size() / 3),
                "give at least 2x2 vertices with a position and a normal each");
  }
  const auto is_finite = [](float value) { return std::isfinite(value); };
  if (!std::all_of(mesh.positions_xyz.begin(), mesh.positions_xyz.end(), is_finite) ||
      !std::all_of(mesh.normals_xyz.begin(), mesh.normals_xyz.end(), is_finite)) {
    throw Error(ErrorKind::bad_input, fmt::format("{}: a vertex is not finite", path.string()),
                "find where the simulation made values that are not finite");
  }
}

/// Calls `put` with the three vertex indices of each triangle, row by row of cells.
template <typename Put>
void for_each_triangle(const GridMesh& mesh, Put put) {
  const auto columns = static_cast<std::uint32_t>(mesh.columns), rows = static_cast<std::uint32_t>(mesh.rows);
  for (std::uint32_t row = 0; row + 1 < rows; ++row) {
    for (std::uint32_t corner = row * columns; corner + 1 < (row + 1) * columns; ++corner) {
      const std::uint32_t below = corner + columns;
      put(TriangleIndices{corner, below, corner + 1});
      put(TriangleIndices{corner + 1, below, below + 1});
    }
  }
}

}  // namespace

void write_obj(const std::filesystem::path& path, const GridMesh& mesh) {
  check(path, mesh);
  meshes::ObjWriter file(path, fmt::format("{} x {} vertices, metres, +y up", mesh.columns, mesh.rows));
  const auto put_vectors = [&](const char* keyword, const std::vector<float>& xyz) {
    for (std::size_t i = 0; i < xyz.size(); i += 3) {
      file.put_vector(keyword, glm::vec3(xyz[i], xyz[i + 1], xyz[i + 2]));
    }
  };
  put_vectors("v", mesh.positions_xyz);
  put_vectors("vn", mesh.normals_xyz);
  for_each_triangle(mesh, [&](const TriangleIndices& corners) {
    file.put_triangle(corners, meshes::ObjWriter::Normals::same_index);
  });
  file.commit();
}

void write_ply(const std::filesystem::path& path, const GridMesh& mesh) {
  check(path, mesh);
  const std::size_t vertices = mesh.positions_xyz.size() / 3;
  const std::size_t triangles =
      std::size_t{2} * static_cast<unsigned>(mesh.columns - 1) * static_cast<unsigned>(mesh.rows - 1);
  std::vector<meshes::PlyColumn> columns;
  for (const char* name : {"x", "y", "z", "nx", "ny", "nz"}) columns.push_back({"float", name});
  meshes::PlyWriter file(path, {"metres, +y up"}, columns, {vertices, triangles});
  for (std::size_t i = 0; i < 3 * vertices; i += 3) {
    file.put(&mesh.positions_xyz[i], 3);
    file.put(&mesh.normals_xyz[i], 3);
  }
  for_each_triangle(mesh, [&](const TriangleIndices& corners) { file.put_triangle(corners); });
  file.commit();
}

}  // namespace offing

#include "host/io/grid_mesh.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <string>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/atomic_file.h"

namespace offing {
namespace {

static_assert(std::endian::native == std::endian::little, "write_ply copies numbers as they lie in memory");

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
                "find out where the simulation left the finite numbers");
  }
}

/// Calls `write_triangle` with the three vertex indices of each triangle of one row of cells.
template <typename WriteTriangle>
void for_each_triangle(const GridMesh& mesh, int row, WriteTriangle write_triangle) {
  for (int column = 0; column + 1 < mesh.columns; ++column) {
    const std::int32_t corner = row * mesh.columns + column;
    const std::int32_t below = corner + mesh.columns;
    write_triangle(std::array{corner, below, corner + 1});
    write_triangle(std::array{corner + 1, below, below + 1});
  }
}

}  // namespace

void write_obj(const std::filesystem::path& path, const GridMesh& mesh) {
  check(path, mesh);
  AtomicFile file(path);
  file.write(fmt::format("# {} x {} vertices, metres, +y up\n", mesh.columns, mesh.rows));
  std::string text;
  const std::size_t row_numbers = std::size_t{3} * static_cast<unsigned>(mesh.columns);
  const auto write_vectors = [&](const char* keyword, const std::vector<float>& xyz) {
    for (std::size_t begin = 0; begin < xyz.size(); begin += row_numbers) {
      text.clear();
      for (std::size_t i = begin; i < begin + row_numbers; i += 3) {
        fmt::format_to(std::back_inserter(text), "{} {} {} {}\n", keyword, xyz[i], xyz[i + 1], xyz[i + 2]);
      }
      file.write(text);
    }
  };
  write_vectors("v", mesh.positions_xyz);
  write_vectors("vn", mesh.normals_xyz);
  for (int row = 0; row + 1 < mesh.rows; ++row) {
    text.clear();
    for_each_triangle(mesh, row, [&](const std::array<std::int32_t, 3>& v) {
      fmt::format_to(std::back_inserter(text), "f {0}//{0} {1}//{1} {2}//{2}\n", v[0] + 1, v[1] + 1,
                     v[2] + 1);
    });
    file.write(text);
  }
  file.commit();
}

void write_ply(const std::filesystem::path& path, const GridMesh& mesh) {
  check(path, mesh);
  AtomicFile file(path);
  const std::size_t vertices = mesh.positions_xyz.size() / 3;
  const std::size_t triangles =
      std::size_t{2} * static_cast<unsigned>(mesh.columns - 1) * static_cast<unsigned>(mesh.rows - 1);
  file.write(
      fmt::format("ply\nformat binary_little_endian 1.0\ncomment metres, +y up\nelement vertex {}\n"
                  "property float x\nproperty float y\nproperty float z\n"
                  "property float nx\nproperty float ny\nproperty float nz\n"
                  "element face {}\nproperty list uchar int vertex_indices\nend_header\n",
                  vertices, triangles));
  for (std::size_t i = 0; i < 3 * vertices; i += 3) {
    file.write(&mesh.positions_xyz[i], 3 * sizeof(float));
    file.write(&mesh.normals_xyz[i], 3 * sizeof(float));
  }
  constexpr char corners = 3;
  for (int row = 0; row + 1 < mesh.rows; ++row) {
    for_each_triangle(mesh, row, [&](const std::array<std::int32_t, 3>& v) {
      file.write(&corners, 1);
      file.write(v.data(), sizeof(v));
    });
  }
  file.commit();
}

}  // namespace offing

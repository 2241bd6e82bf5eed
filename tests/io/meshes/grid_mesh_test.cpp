#include "host/io/meshes/grid_mesh.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

/// 4 x 3 vertices of a tilted plane, spacing 0.5 m, with numbers that have no short decimal form.
GridMesh tilted_plane() {
  GridMesh mesh{4, 3, {}, {}};
  for (int row = 0; row < 3; ++row) {
    for (int column = 0; column < 4; ++column) {
      const float x = 0.5f * static_cast<float>(column), z = 0.5f * static_cast<float>(row);
      mesh.positions_xyz.insert(mesh.positions_xyz.end(), {x, x / 3.0f - z / 7.0f, z});
      mesh.normals_xyz.insert(mesh.normals_xyz.end(), {-0.3f, 0.9f, 0.1f});
    }
  }
  return mesh;
}

using Triangle = std::array<int, 3>;

/// Fails if a triangle is turned over, or the triangles do not cover the grid once: y of their summed cross
/// products is twice the covered area, 2 * 1.5 m * 1 m.
void expect_covering(const GridMesh& mesh, const std::vector<Triangle>& triangles) {
  ASSERT_EQ(triangles.size(), 2u * 3u * 2u);
  const auto at = [&](int vertex, int axis) { return double{mesh.positions_xyz.at(3 * vertex + axis)}; };
  double sum = 0.0;
  for (const auto& [a, b, c] : triangles) {
    const double up =
        (at(b, 2) - at(a, 2)) * (at(c, 0) - at(a, 0)) - (at(b, 0) - at(a, 0)) * (at(c, 2) - at(a, 2));
    EXPECT_DOUBLE_EQ(up, 0.25);
    sum += up;
  }
  EXPECT_DOUBLE_EQ(sum, 3.0);
}

std::string content(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

// Fails if a float does not read back exactly, counts are off or faces look down.
TEST(GridMesh, ObjReadsBack) {
  const TemporaryFolder folder;
  const GridMesh mesh = tilted_plane();
  write_obj(folder.path() / "a.obj", mesh);
  std::istringstream lines(content(folder.path() / "a.obj"));
  std::vector<float> positions, normals;
  std::vector<Triangle> triangles;
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string keyword, word;
    words >> keyword;
    if (keyword == "f") {
      Triangle triangle;
      for (int& vertex : triangle) {
        words >> word;
        int normal = 0;
        ASSERT_EQ(std::sscanf(word.c_str(), "%d//%d", &vertex, &normal), 2);
        ASSERT_EQ(vertex, normal);
        --vertex;
      }
      triangles.push_back(triangle);
    } else if (keyword == "v" || keyword == "vn") {
      while (words >> word) (keyword == "v" ? positions : normals).push_back(std::stof(word));
    }
  }
  EXPECT_EQ(positions, mesh.positions_xyz);
  EXPECT_EQ(normals, mesh.normals_xyz);
  expect_covering(mesh, triangles);
}

// Fails if the header's counts, the layout of a vertex or the face list differ from what PLY readers expect.
TEST(GridMesh, PlyReadsBack) {
  const TemporaryFolder folder;
  const GridMesh mesh = tilted_plane();
  write_ply(folder.path() / "a.ply", mesh);
  const std::string bytes = content(folder.path() / "a.ply");
  EXPECT_THAT(bytes, ::testing::StartsWith("ply\nformat binary_little_endian 1.0\n"));
  EXPECT_THAT(bytes, ::testing::HasSubstr("element vertex 12\n"));
  EXPECT_THAT(bytes, ::testing::HasSubstr("element face 12\n"));
  const std::string end = "end_header\n";
  const std::size_t body = bytes.find(end) + end.size();
  ASSERT_EQ(bytes.size() - body, 12u * 24u + 12u * 13u);
  for (std::size_t vertex = 0; vertex < 12; ++vertex) {
    float numbers[6];
    std::memcpy(numbers, bytes.data() + body + 24 * vertex, sizeof(numbers));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      EXPECT_EQ(numbers[axis], mesh.positions_xyz[3 * vertex + axis]);
      EXPECT_EQ(numbers[axis + 3], mesh.normals_xyz[3 * vertex + axis]);
    }
  }
  std::vector<Triangle> triangles(12);
  for (std::size_t face = 0; face < 12; ++face) {
    const char* const record = bytes.data() + body + std::size_t{12} * 24 + 13 * face;
    EXPECT_EQ(record[0], 3);
    std::memcpy(triangles[face].data(), record + 1, 12);
  }
  expect_covering(mesh, triangles);
}

// Fails if a grid without cells, arrays of the wrong length or a NaN are written.
TEST(GridMesh, BadInputIsRefused) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "a.obj";
  GridMesh mesh = tilted_plane();
  mesh.positions_xyz[7] = std::nanf("");
  EXPECT_THROW(write_obj(path, mesh), Error);
  mesh = tilted_plane();
  mesh.normals_xyz.pop_back();
  EXPECT_THROW(write_ply(path, mesh), Error);
  EXPECT_THROW(write_ply(path, GridMesh{1, 3, std::vector<float>(9), std::vector<float>(9)}), Error);
  EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
}

}  // namespace
}  // namespace offing

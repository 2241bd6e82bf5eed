#include "host/io/meshes/prepared_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <fstream>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/io/meshes/mesh_bytes.h"
#include "host/io/meshes/ply_mesh.h"

namespace offing {
namespace {

constexpr std::array<std::string_view, 10> names = {"k_max",   "k_min",   "e_max_x", "e_max_y", "e_max_z",
                                                    "e_min_x", "e_min_y", "e_min_z", "area",    "confidence"};

Error unprepared(const std::filesystem::path& path, std::string_view expected, std::string_view got) {
  return {ErrorKind::bad_input,
          fmt::format("{}: expected {}, got {}", one_line(path.string()), expected, got),
          "prepare the mesh with `offing-mesh curvature`"};
}

/// Checks and keeps the values of one vertex after the other.
class CurvatureReader {
 public:
  CurvatureReader(const std::filesystem::path& path, const std::vector<std::vector<double>>& columns)
      : path_(path), columns_(columns) {}

  VertexCurvatures read(std::size_t vertices) {
    VertexCurvatures curvatures;
    for (std::size_t i = 0; i < vertices; ++i) {
      for (const std::vector<double>& column : columns_) {
        if (!std::isfinite(column[i])) fail(i, "finite curvatures", "others");
      }
      const double k_max = columns_[0][i], k_min = columns_[1][i];
      if (k_max < k_min) fail(i, "k_max >= k_min", fmt::format("{:g} < {:g}", k_max, k_min));
      curvatures.k_max_per_m.push_back(k_max);
      curvatures.k_min_per_m.push_back(k_min);
      curvatures.e_max.push_back(direction(i, 2));
      curvatures.e_min.push_back(direction(i, 5));
      if (columns_[8][i] < 0.0) fail(i, "an area from 0 on", fmt::format("{:g}", columns_[8][i]));
      curvatures.area_m2.push_back(columns_[8][i]);
      const double confidence = columns_[9][i];
      if (confidence < 0.0 || confidence > 1.0)
        fail(i, "a confidence within 0 ... 1", fmt::format("{:g}", confidence));
      curvatures.confidence.push_back(confidence);
    }
    return curvatures;
  }

 private:
  [[noreturn]] void fail(std::size_t vertex, std::string_view expected, std::string_view got) const {
    throw unprepared(path_, fmt::format("{} at vertex {}", expected, vertex), got);
  }

  glm::dvec3 direction(std::size_t vertex, std::size_t column) const {
    const glm::dvec3 vector(columns_[column][vertex], columns_[column + 1][vertex],
                            columns_[column + 2][vertex]);
    const double length = glm::length(vector);
    if (length == 0.0) return vector;
    constexpr double tolerance = 1e-3;  // of files that were written with few digits
    if (!(std::abs(length - 1.0) < tolerance))
      fail(vertex, "unit directions", fmt::format("a length of {:g}", length));
    return vector / length;
  }

  const std::filesystem::path& path_;
  const std::vector<std::vector<double>>& columns_;
};

std::vector<double> axis_of(const std::vector<glm::dvec3>& vectors, int axis) {
  std::vector<double> values(vectors.size());
  std::transform(vectors.begin(), vectors.end(), values.begin(), [axis](const auto& v) { return v[axis]; });
  return values;
}

}  // namespace

void write_prepared(const std::filesystem::path& path, const PreparedMesh& prepared,
                    const VertexAttributes& attributes, Existing existing) {
  if (prepared.mesh.normals.empty()) throw unprepared(path, "normals", "none");
  const VertexCurvatures& curvatures = prepared.curvatures;
  std::array<std::vector<double>, 6> parts;
  for (int axis = 0; axis < 3; ++axis) {
    parts[static_cast<std::size_t>(axis)] = axis_of(curvatures.e_max, axis);
    parts[static_cast<std::size_t>(axis + 3)] = axis_of(curvatures.e_min, axis);
  }
  const std::array<std::span<const double>, 10> values = {curvatures.k_max_per_m,
                                                          curvatures.k_min_per_m,
                                                          parts[0],
                                                          parts[1],
                                                          parts[2],
                                                          parts[3],
                                                          parts[4],
                                                          parts[5],
                                                          curvatures.area_m2,
                                                          curvatures.confidence};
  VertexAttributes all;
  for (std::size_t i = 0; i < names.size(); ++i) all.properties.push_back({std::string(names[i]), values[i]});
  all.properties.insert(all.properties.end(), attributes.properties.begin(), attributes.properties.end());
  all.colours = attributes.colours;
  all.comments = {"k_max, k_min in 1/m, positive where the surface is convex; area in m^2"};
  all.comments.insert(all.comments.end(), attributes.comments.begin(), attributes.comments.end());
  write_ply(path, prepared.mesh, all, existing);
}

bool is_prepared(const std::filesystem::path& path) {
  std::string start(std::size_t{1} << 16, '\0');  // longer than any header that people or programs write
  std::ifstream file(path, std::ios::binary);
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  const std::size_t end = start.find("end_header");
  return start.starts_with("ply") && start.find(fmt::format(" {}", names.front())) < end;
}

PreparedMesh read_prepared(const std::filesystem::path& path) {
  meshes::PlyMesh ply = meshes::parse_mesh_file(
      path, [&](std::string_view bytes) { return meshes::parse_ply(bytes, path.string(), names); });
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (ply.columns[i].empty())
      throw unprepared(path, fmt::format("a property {} of vertices", names[i]), "none");
  }
  if (ply.file.mesh.normals.empty()) throw unprepared(path, "unit normals nx ny nz of vertices", "none");
  const std::size_t vertices = ply.file.mesh.positions_m.size();
  return {std::move(ply.file.mesh), CurvatureReader(path, ply.columns).read(vertices)};
}

}  // namespace offing

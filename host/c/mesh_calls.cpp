#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <string>
#include <system_error>
#include <utility>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "host/c/arrays.h"
#include "host/c/handles.h"
#include "host/highlights/curvature/diffused_curvature.h"
#include "host/io/atomic_file.h"
#include "host/io/meshes/polygon_soup.h"
#include "host/io/meshes/read_mesh.h"
#include "host/io/meshes/write_mesh.h"

using offing::Error;
using offing::ErrorKind;
using offing::TriangleMesh;
using offing::c::require;
using offing::c::run;
using offing::c::write_values;
using offing::c::write_vector;

namespace {

constexpr int usual_rounds = 3;

glm::dvec3 usable_vertex(const double* vertices_m, std::size_t index) {
  const glm::dvec3 vertex_m = offing::c::vector_at(vertices_m, index);
  const auto is_usable = [](double value) {
    return std::abs(value) <= offing::meshes::farthest_vertex_m;  // false of NaN
  };
  if (is_usable(vertex_m.x) && is_usable(vertex_m.y) && is_usable(vertex_m.z)) return vertex_m;
  throw Error(ErrorKind::bad_input,
              fmt::format("vertices_m[{}]: expected finite values within {:g} m, got ({:g}, {:g}, {:g})",
                          index, offing::meshes::farthest_vertex_m, vertex_m.x, vertex_m.y, vertex_m.z),
              "give the vertex a place, or leave out the triangles that name it and the vertex");
}

offing::TriangleIndices usable_triangle(const std::uint32_t* triangles, std::size_t index,
                                        std::size_t vertex_count) {
  const offing::TriangleIndices corners{triangles[3 * index], triangles[3 * index + 1],
                                        triangles[3 * index + 2]};
  const std::uint32_t highest = *std::max_element(corners.begin(), corners.end());
  if (highest < vertex_count) return corners;
  throw Error(
      ErrorKind::bad_input,
      fmt::format("triangles[{}]: expected vertices 0 ... {}, got {}", index, vertex_count - 1, highest),
      "count vertices from 0 on, and give all vertices that triangles name");
}

TriangleMesh mesh_of(const double* vertices_m, std::size_t vertex_count, const std::uint32_t* triangles,
                     std::size_t triangle_count) {
  if (vertex_count == 0 || vertex_count > offing::meshes::most_vertices || triangle_count == 0) {
    throw Error(ErrorKind::bad_input,
                fmt::format("mesh: expected 1 to {} vertices and at least 1 triangle, got {} and {}",
                            offing::meshes::most_vertices, vertex_count, triangle_count),
                "leave out meshes without triangles, and cut larger ones into parts");
  }
  TriangleMesh mesh;
  mesh.positions_m.reserve(vertex_count);
  for (std::size_t i = 0; i < vertex_count; ++i) mesh.positions_m.push_back(usable_vertex(vertices_m, i));
  mesh.faces.reserve(triangle_count);
  for (std::size_t i = 0; i < triangle_count; ++i)
    mesh.faces.push_back(usable_triangle(triangles, i, vertex_count));
  return mesh;
}

OffingMeshInfo info_of_mesh(const OffingMesh& mesh) {
  const auto& positions_m = mesh.mesh.positions_m;
  OffingMeshInfo info{};
  info.size = sizeof info;
  info.vertex_count = positions_m.size();
  info.triangle_count = mesh.mesh.faces.size();
  glm::dvec3 lowest_m = positions_m.front(), highest_m = lowest_m;
  for (const glm::dvec3& position_m : positions_m) {
    lowest_m = glm::min(lowest_m, position_m);
    highest_m = glm::max(highest_m, position_m);
  }
  write_vector(info.lowest_m, 0, lowest_m);
  write_vector(info.highest_m, 0, highest_m);
  info.format = mesh.format.c_str();
  return info;
}

void write_curvatures(const OffingCurvatures& target, const offing::VertexCurvatures& found) {
  const auto copy = [](const std::vector<double>& values, double* array) {
    if (array != nullptr) std::copy(values.begin(), values.end(), array);
  };
  copy(found.k_max_per_m, target.k_max_per_m);
  copy(found.k_min_per_m, target.k_min_per_m);
  copy(found.area_m2, target.area_m2);
  copy(found.confidence, target.confidence);
  for (std::size_t i = 0; i < found.e_max.size(); ++i) {
    write_vector(target.e_max, i, found.e_max[i]);
    write_vector(target.e_min, i, found.e_min[i]);
    write_vector(target.normal, i, glm::cross(found.e_max[i], found.e_min[i]));
  }
}

}  // namespace

OffingStatus offing_open_mesh(const char* file, const OffingMeshOptions* options, OffingMesh** mesh) {
  return run([&] {
    require(file, "file");
    require(mesh, "mesh");
    const bool is_untrusted = offing::c::read_struct(options, "options").is_untrusted != 0;
    offing::MeshFile found =
        offing::read_mesh_file(file, is_untrusted ? offing::Trust::untrusted : offing::Trust::trusted);
    offing::warn_of_left_out(file, found.report);
    *mesh = new OffingMesh{std::move(found.mesh), std::move(found.report.format)};
  });
}

OffingStatus offing_make_mesh(const double* vertices_m, size_t vertex_count, const uint32_t* triangles,
                              size_t triangle_count, OffingMesh** mesh) {
  return run([&] {
    require(vertices_m, "vertices_m");
    require(triangles, "triangles");
    require(mesh, "mesh");
    *mesh = new OffingMesh{mesh_of(vertices_m, vertex_count, triangles, triangle_count), ""};
  });
}

void offing_free_mesh(OffingMesh* mesh) {
  delete mesh;
}

OffingStatus offing_get_mesh_info(const OffingMesh* mesh, OffingMeshInfo* info) {
  return run([&] {
    require(mesh, "mesh");
    offing::c::write_struct(info, "info", info_of_mesh(*mesh));
  });
}

OffingStatus offing_read_mesh(const OffingMesh* mesh, double* vertices_m, size_t vertex_count,
                              uint32_t* triangles, size_t triangle_count) {
  return run([&] {
    require(mesh, "mesh");
    const auto& [positions_m, normals, faces] = mesh->mesh;
    if (vertices_m != nullptr) offing::c::require_count("vertex_count", vertex_count, positions_m.size());
    if (triangles != nullptr) offing::c::require_count("triangle_count", triangle_count, faces.size());
    for (std::size_t i = 0; i < positions_m.size(); ++i) write_vector(vertices_m, i, positions_m[i]);
    for (std::size_t i = 0; i < faces.size(); ++i)
      write_values(triangles, i, {faces[i][0], faces[i][1], faces[i][2]});
  });
}

OffingStatus offing_save_mesh(const OffingMesh* mesh, const char* file, int replace) {
  return run([&] {
    require(mesh, "mesh");
    require(file, "file");
    std::error_code ignored;
    if (replace == 0 && std::filesystem::exists(std::filesystem::symlink_status(file, ignored))) {
      offing::refuse_existing(file, "set replace to 1, or name another file");
    }
    offing::write_mesh(file, mesh->mesh, replace == 0 ? offing::Existing::keep : offing::Existing::replace);
  });
}

OffingStatus offing_compute_curvatures(const OffingDevice* device, const OffingMesh* mesh,
                                       const OffingCurvatureOptions* options, size_t count,
                                       const OffingCurvatures* curvatures) {
  return run([&] {
    require(device, "device");
    require(mesh, "mesh");
    require(curvatures, "curvatures");
    const OffingCurvatureOptions asked = offing::c::read_struct(options, "options");
    const OffingCurvatures wanted = offing::c::read_struct(curvatures, "curvatures");
    offing::c::require_count("count", count, mesh->mesh.positions_m.size());
    write_curvatures(
        wanted, offing::highlights::diffused_curvatures(device->device, mesh->mesh,
                                                        asked.rounds == 0 ? usual_rounds : asked.rounds));
  });
}

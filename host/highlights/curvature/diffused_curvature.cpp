#include "host/highlights/curvature/diffused_curvature.h"

#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/base/mesh_neighbours.h"
#include "host/ocl/program.h"

namespace offing::highlights {
namespace {

using Sides = std::array<std::int32_t, 2>;

/// Both faces of an edge as seen from one of its ends, for kernels/highlights/ring_tensor.cl.
Sides sides_of(const MeshNeighbours& mesh, std::uint32_t edge, std::uint32_t vertex) {
  const auto faces = mesh.edge_faces.row(edge);
  if (faces.size() != 2) return {0, 0};
  const auto runs_from_vertex = [&](std::uint32_t face) {
    return mesh.runs_along(face, edge) == (mesh.edges[edge][0] == vertex);
  };
  const bool is_first_left = runs_from_vertex(faces[0]);
  const auto first = static_cast<std::int32_t>(faces[0]);
  auto second = static_cast<std::int32_t>(faces[1]);
  if (runs_from_vertex(faces[1]) == is_first_left) second = ~second;
  return is_first_left ? Sides{first, second} : Sides{second, first};
}

/// A list may be empty where no device buffer can.
template <typename T>
ocl::Buffer<T> upload(const ocl::Device& device, std::vector<T> values, std::string_view name) {
  if (values.empty()) values.emplace_back();
  return ocl::Buffer<T>(device, values, name);
}

void require_valid(const TriangleMesh& mesh, int rounds) {
  if (rounds < 0 || rounds > 1000) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("diffused curvature: expected 0 ... 1000 rounds, found {}", rounds),
                "3 rounds suit most meshes");
  }
  if (mesh.positions_m.empty() || mesh.faces.empty()) {
    throw Error(ErrorKind::bad_usage, "diffused curvature: expected a mesh with faces, found none",
                "leave out meshes without faces");
  }
}

}  // namespace

DiffusedCurvature::DiffusedCurvature(const ocl::Device& device, const TriangleMesh& mesh, int rounds)
    : device_(device), rounds_(rounds) {
  require_valid(mesh, rounds);
  std::vector<std::uint32_t> first = first_at_place(mesh.positions_m);
  MeshNeighbours neighbours = mesh_neighbours(first.size(), welded_faces(mesh.faces, first));
  std::vector<Sides> sides;
  std::vector<std::uint8_t> on_border(first.size(), 0);
  for (std::uint32_t vertex = 0; vertex < first.size(); ++vertex) {
    for (const std::uint32_t edge : neighbours.vertex_edges.row(vertex)) {
      sides.push_back(sides_of(neighbours, edge, vertex));
      if (neighbours.edge_faces.row(edge).size() != 2) on_border[vertex] = 1;
    }
  }
  std::vector<std::uint32_t> corners;
  for (const TriangleIndices& face : neighbours.faces)
    corners.insert(corners.end(), face.begin(), face.end());

  const std::size_t vertices = first.size(), faces = mesh.faces.size();
  corners_ = upload(device, std::move(corners), "mesh corners");
  first_ = upload(device, std::move(first), "mesh places");
  faces_begin_ = upload(device, std::move(neighbours.vertex_faces.begin), "mesh face lists");
  faces_ = upload(device, std::move(neighbours.vertex_faces.entries), "mesh faces of vertices");
  edges_begin_ = upload(device, std::move(neighbours.vertex_edges.begin), "mesh edge lists");
  neighbours_ = upload(device, std::move(neighbours.neighbours), "mesh neighbours");
  sides_ = upload(device, std::move(sides), "mesh faces of edges");
  on_border_ = upload(device, std::move(on_border), "mesh borders");
  shares_ = ocl::Buffer<std::array<float, 8>>(device, vertices, "curvature tensors");
  averaged_ = ocl::Buffer<std::array<float, 8>>(device, vertices, "averaged curvature tensors");
  face_normals_ = ocl::Buffer<Float4>(device, faces, "face normals");
  ring_normals_ = ocl::Buffer<Float4>(device, vertices, "ring normals");
  curvatures_ = ocl::Buffer<Float4>(device, vertices, "curvatures");
  e_max_ = ocl::Buffer<Float4>(device, vertices, "curvature directions");
  normals_ = ocl::Buffer<Float4>(device, vertices, "vertex normals");

  face_kernel_ = ocl::Program::build(device, "highlights/face_normal.cl").kernel("face_normal");
  ring_kernel_ = ocl::Program::build(device, "highlights/ring_tensor.cl").kernel("ring_tensor");
  average_kernel_ = ocl::Program::build(device, "highlights/share_average.cl").kernel("share_average");
  principal_kernel_ =
      ocl::Program::build(device, "highlights/principal_curvature.cl").kernel("principal_curvature");
}

void DiffusedCurvature::at(const ocl::Buffer<float>& positions_m) {
  const std::size_t vertices = vertex_count();
  if (positions_m.size() != 3 * vertices) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("diffused curvature: expected {} coordinates, 3 per vertex, found {}",
                            3 * vertices, positions_m.size()),
                "give the positions of all vertices of the mesh");
  }
  face_kernel_.launch({{face_normals_.size()}}, positions_m, corners_, face_normals_);
  ring_kernel_.launch({{vertices}}, positions_m, face_normals_, faces_begin_, faces_, edges_begin_,
                      neighbours_, sides_, shares_, ring_normals_);
  for (int round = 0; round < rounds_; ++round) {
    average_kernel_.launch({{vertices}}, edges_begin_, neighbours_, shares_, averaged_);
    std::swap(shares_, averaged_);
  }
  principal_kernel_.launch({{vertices}}, positions_m, first_, edges_begin_, neighbours_, on_border_, shares_,
                           ring_normals_, rounds_, curvatures_, e_max_, normals_);
}

VertexCurvatures DiffusedCurvature::read() const {
  const std::vector<Float4> curvatures = curvatures_.read(), e_max = e_max_.read(), normals = normals_.read();
  const auto vector = [](const Float4& value) { return glm::dvec3(value[0], value[1], value[2]); };
  VertexCurvatures result;
  for (std::size_t i = 0; i < curvatures.size(); ++i) {
    const auto& [k_max_per_m, k_min_per_m, area_m2, confidence] = curvatures[i];
    result.k_max_per_m.push_back(static_cast<double>(k_max_per_m));
    result.k_min_per_m.push_back(static_cast<double>(k_min_per_m));
    result.e_max.push_back(vector(e_max[i]));
    result.e_min.push_back(glm::cross(vector(normals[i]), vector(e_max[i])));
    result.area_m2.push_back(static_cast<double>(area_m2));
    result.confidence.push_back(static_cast<double>(confidence));
  }
  return result;
}

VertexCurvatures DiffusedCurvature::of(const std::vector<glm::dvec3>& positions_m) {
  glm::dvec3 middle_m(0.0);
  for (const glm::dvec3& position_m : positions_m) middle_m += position_m;
  middle_m /= static_cast<double>(positions_m.size());
  double farthest_m = 0.0;
  for (const glm::dvec3& position_m : positions_m) {
    for (int axis = 0; axis < 3; ++axis)
      farthest_m = std::max(farthest_m, std::abs(position_m[axis] - middle_m[axis]));
  }
  // Floats near 1 have squares and products of lengths that are floats, too.
  const int exponent = farthest_m > 0.0 ? std::ilogb(farthest_m) : 0;
  std::vector<float> scaled;
  scaled.reserve(3 * positions_m.size());
  for (const glm::dvec3& position_m : positions_m) {
    for (int axis = 0; axis < 3; ++axis)
      scaled.push_back(static_cast<float>(std::ldexp(position_m[axis] - middle_m[axis], -exponent)));
  }
  if (positions_m_.empty()) positions_m_ = ocl::Buffer<float>(device_, scaled.size(), "positions");
  positions_m_.write(scaled);
  at(positions_m_);
  VertexCurvatures result = read();
  for (double& k_per_m : result.k_max_per_m) k_per_m = std::ldexp(k_per_m, -exponent);
  for (double& k_per_m : result.k_min_per_m) k_per_m = std::ldexp(k_per_m, -exponent);
  for (double& area_m2 : result.area_m2) area_m2 = std::ldexp(area_m2, 2 * exponent);
  return result;
}

VertexCurvatures diffused_curvatures(const ocl::Device& device, const TriangleMesh& mesh, int rounds) {
  return DiffusedCurvature(device, mesh, rounds).of(mesh.positions_m);
}

}  // namespace offing::highlights

#include "host/highlights/search/highlight_surface.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/disjoint_sets.h"
#include "host/base/error.h"
#include "host/base/mesh_neighbours.h"
#include "host/base/parameter_check.h"
#include "host/highlights/search/unit_vector.h"
#include "host/ocl/tuning.h"
#include "kernels/shared/highlights.h"

namespace offing::highlights {
namespace {

/// For each vertex of a face the first one at its place: copies of one vertex, however many, are compared to
/// none of the others. Vertices of no face are left out.
std::vector<std::uint32_t> places_of_faces(const TriangleMesh& mesh, DisjointSets& sets) {
  const std::vector<std::uint32_t> first = first_at_place(mesh.positions_m);
  std::vector<std::uint32_t> places;
  for (const TriangleIndices& face : mesh.faces) {
    for (const std::uint32_t corner : face) {
      places.push_back(first[corner]);
      sets.join(first[corner], corner);
    }
  }
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  return places;
}

/// Joins vertices of faces within the distance. Sorted along a line that no surface is likely to be built
/// across, each is compared to those that are not farther along it.
DisjointSets joined(const TriangleMesh& mesh, double distance_m) {
  const std::vector<glm::dvec3>& positions_m = mesh.positions_m;
  const glm::dvec3 line = glm::normalize(glm::dvec3(0.5377, 0.7103, 0.4543));
  DisjointSets sets(positions_m.size());
  std::vector<std::pair<double, std::uint32_t>> order;  // m along the line
  for (const std::uint32_t vertex : places_of_faces(mesh, sets)) {
    order.emplace_back(glm::dot(line, positions_m[vertex]), vertex);
  }
  std::ranges::sort(order);
  for (std::size_t i = 0; i < order.size(); ++i) {
    const auto [along_m, vertex] = order[i];
    for (std::size_t j = i + 1; j < order.size() && order[j].first <= along_m + distance_m; ++j) {
      const std::uint32_t other = order[j].second;
      if (glm::distance(positions_m[vertex], positions_m[other]) <= distance_m) sets.join(vertex, other);
    }
  }
  return sets;
}

[[noreturn]] void refuse(const std::string& what, const std::string& hint) {
  throw Error(ErrorKind::bad_input, "highlights: mesh: " + what, hint);
}

bool is_finite(const glm::dvec3& v) {
  return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

void require_vectors(const char* name, const std::vector<glm::dvec3>& vectors, std::size_t count) {
  if (vectors.size() != count)
    refuse(fmt::format("{}: expected one for each of {} vertices, found {}", name, count, vectors.size()),
           "give every vertex one");
  for (std::size_t i = 0; i < count; ++i) {
    if (!is_finite(vectors[i]))
      refuse(fmt::format("{}: vertex {}: expected finite numbers", name, i),
             "repair the mesh: offing-mesh repair");
  }
}

void require_numbers(const char* name, const std::vector<double>& values, std::size_t count) {
  if (values.size() != count)
    refuse(fmt::format("{}: expected one for each of {} vertices, found {}", name, count, values.size()),
           "compute the curvatures of this mesh");
  for (std::size_t i = 0; i < count; ++i) {
    if (!std::isfinite(values[i]))
      refuse(fmt::format("{}: vertex {}: expected a finite number", name, i), "compute the curvatures again");
  }
}

void require_vertices(const TriangleMesh& mesh, const VertexCurvatures& curvatures, std::size_t count) {
  require_vectors("positions", mesh.positions_m, count);
  if (!mesh.normals.empty()) require_vectors("normals", mesh.normals, count);
  require_vectors("e_max", curvatures.e_max, count);
  require_numbers("k_max", curvatures.k_max_per_m, count);
  require_numbers("k_min", curvatures.k_min_per_m, count);
}

TriangleMesh checked(TriangleMesh mesh, const VertexCurvatures& curvatures) {
  const std::size_t count = mesh.positions_m.size();
  constexpr std::size_t most = std::numeric_limits<std::int32_t>::max() / 4;
  if (count == 0 || count > most || mesh.faces.size() > most)
    refuse(fmt::format("expected 1 to {} vertices and as many faces at most, found {} and {}", most, count,
                       mesh.faces.size()),
           "give a mesh with vertices, or parts of it one by one");
  require_vertices(mesh, curvatures, count);
  for (std::size_t face = 0; face < mesh.faces.size(); ++face) {
    for (const std::uint32_t corner : mesh.faces[face]) {
      if (corner >= count)
        refuse(fmt::format("face {}: expected corners below {}, found {}", face, count, corner),
               "remove the face or add the vertex");
    }
  }
  return mesh;
}

double diagonal(const std::vector<glm::dvec3>& positions_m) {
  glm::dvec3 low = positions_m.front(), high = low;
  for (const glm::dvec3& p : positions_m) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return glm::distance(low, high);
}

/// Normals of the faces around each place, weighted by their angles there (Thuermer & Wuethrich 1998), so
/// that they do not depend on how a surface is cut into triangles.
std::vector<glm::dvec3> normals_of_faces(const TriangleMesh& mesh,
                                         const std::vector<glm::dvec3>& face_normals,
                                         const VertexLinks& links) {
  std::vector<glm::dvec3> at_places(links.place_count(), glm::dvec3(0.0));
  std::vector<double> angles_rad(links.place_count(), 0.0);
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) {
    const TriangleIndices& face = mesh.faces[f];
    for (std::size_t i = 0; i < 3; ++i) {
      const glm::dvec3& p = mesh.positions_m[face[i]];
      const glm::dvec3 a = unit_or_zero(mesh.positions_m[face[(i + 1) % 3]] - p);
      const glm::dvec3 b = unit_or_zero(mesh.positions_m[face[(i + 2) % 3]] - p);
      const double angle_rad = std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
      at_places[links.place_of(face[i])] += angle_rad * face_normals[f];
      angles_rad[links.place_of(face[i])] += angle_rad;
    }
  }
  std::vector<glm::dvec3> normals;
  for (std::uint32_t vertex = 0; vertex < mesh.positions_m.size(); ++vertex) {
    const glm::dvec3& sum = at_places[links.place_of(vertex)];
    // Faces back to back cancel but for rounding.
    const bool is_known = glm::length(sum) > 1e-6 * angles_rad[links.place_of(vertex)];
    normals.push_back(is_known ? glm::normalize(sum) : glm::dvec3(0.0));
  }
  return normals;
}

/// Where there is no normal, as on a sheet whose faces lie back to back, that of the largest face has to do,
/// the first of equals.
void fill_with_faces(const TriangleMesh& mesh, const std::vector<glm::dvec3>& face_normals,
                     const VertexLinks& links, std::vector<glm::dvec3>& normals) {
  for (std::uint32_t vertex = 0; vertex < normals.size(); ++vertex) {
    if (normals[vertex] != glm::dvec3(0.0)) continue;
    double largest_m2 = 0.0;
    for (const std::uint32_t f : links.faces_at(links.place_of(vertex))) {
      const TriangleIndices& face = mesh.faces[f];
      const glm::dvec3& p = mesh.positions_m[face[0]];
      const double area_m2 =
          0.5 * glm::length(glm::cross(mesh.positions_m[face[1]] - p, mesh.positions_m[face[2]] - p));
      if (!(area_m2 > largest_m2)) continue;
      largest_m2 = area_m2;
      normals[vertex] = face_normals[f];
    }
  }
}

/// Each normal and the mean of those at the other ends of its edges, half and half.
void smooth(const TriangleMesh& mesh, const VertexLinks& links, std::vector<glm::dvec3>& normals) {
  std::vector<glm::dvec3> around(links.place_count(), glm::dvec3(0.0));
  for (const TriangleIndices& face : mesh.faces) {
    const glm::dvec3 sum = normals[face[0]] + normals[face[1]] + normals[face[2]];
    for (const std::uint32_t corner : face) around[links.place_of(corner)] += sum - normals[corner];
  }
  for (std::uint32_t vertex = 0; vertex < normals.size(); ++vertex) {
    const glm::dvec3 mean = unit_or_zero(around[links.place_of(vertex)]);
    const glm::dvec3 smoothed = unit_or_zero(normals[vertex] + mean);
    if (smoothed != glm::dvec3(0.0)) normals[vertex] = smoothed;
  }
}

}  // namespace

VertexLinks::VertexLinks(const TriangleMesh& mesh, double distance_m) {
  DisjointSets sets = joined(mesh, distance_m);
  places_.resize(mesh.positions_m.size());
  std::uint32_t count = 0;
  for (std::uint32_t vertex = 0; vertex < places_.size(); ++vertex) {
    const std::uint32_t root = sets.root_of(vertex).index;
    places_[vertex] = root == vertex ? count++ : places_[root];
  }
  first_face_.assign(count + 1, 0);
  for (const TriangleIndices& face : mesh.faces) {
    for (const std::uint32_t corner : face) ++first_face_[places_[corner] + 1];
  }
  std::partial_sum(first_face_.begin(), first_face_.end(), first_face_.begin());
  faces_.resize(3 * mesh.faces.size());
  std::vector<std::uint32_t> next(first_face_.begin(), first_face_.end() - 1);
  for (std::uint32_t face = 0; face < mesh.faces.size(); ++face) {
    for (const std::uint32_t corner : mesh.faces[face]) faces_[next[places_[corner]]++] = face;
  }
}

HighlightSurface::HighlightSurface(const ocl::Device& device, TriangleMesh mesh, VertexCurvatures curvatures,
                                   const SurfaceOptions& options)
    : device_(device),
      smoothing_rounds_(options.smoothing_rounds),
      mesh_(checked(std::move(mesh), curvatures)),
      curvatures_(std::move(curvatures)),
      links_(mesh_, options.touching_share * diagonal(mesh_.positions_m)) {
  require_within("highlights.smoothing_rounds", options.smoothing_rounds, 0, 1000);
  require_within("highlights.touching_share", options.touching_share, 0.0, 0.01);
  measure();
  set_normals();
  upload_vertices();
  upload_faces();
}

void HighlightSurface::deform(std::vector<glm::dvec3> positions_m, std::vector<glm::dvec3> normals,
                              VertexCurvatures curvatures) {
  TriangleMesh moved{.positions_m = std::move(positions_m), .normals = std::move(normals), .faces = {}};
  require_vertices(moved, curvatures, mesh_.positions_m.size());
  if (at_rest_m_.empty()) at_rest_m_ = std::move(mesh_.positions_m);
  mesh_.positions_m = std::move(moved.positions_m);
  mesh_.normals = std::move(moved.normals);
  curvatures_ = std::move(curvatures);
  measure();
  set_normals();
  upload_vertices();
  ++revision_;
}

void HighlightSurface::measure() {
  diagonal_m_ = diagonal(mesh_.positions_m);
  middle_m_ = glm::dvec3(0.0);
  face_normals_.clear();
  for (const glm::dvec3& p : mesh_.positions_m) middle_m_ += p;
  middle_m_ /= static_cast<double>(mesh_.positions_m.size());
  double edges_m = 0.0;
  for (const TriangleIndices& face : mesh_.faces) {
    const glm::dvec3 &a = mesh_.positions_m[face[0]], &b = mesh_.positions_m[face[1]],
                     &c = mesh_.positions_m[face[2]];
    face_normals_.push_back(unit_or_zero(glm::cross(b - a, c - a)));
    edges_m += glm::distance(a, b) + glm::distance(b, c) + glm::distance(c, a);
  }
  mean_edge_m_ = mesh_.faces.empty() ? 0.0 : edges_m / (3.0 * static_cast<double>(mesh_.faces.size()));
}

void HighlightSurface::set_normals() {
  for (glm::dvec3& normal : mesh_.normals) normal = unit_or_zero(normal);
  if (mesh_.normals.empty()) mesh_.normals = normals_of_faces(mesh_, face_normals_, links_);
  fill_with_faces(mesh_, face_normals_, links_, mesh_.normals);
  for (int round = 0; round < smoothing_rounds_; ++round) smooth(mesh_, links_, mesh_.normals);
}

void HighlightSurface::upload_vertices() {
  const std::size_t count = mesh_.positions_m.size();
  const std::size_t pitch = (count + ocl::widest_lanes - 1) / ocl::widest_lanes * ocl::widest_lanes;
  pitch_ = static_cast<int>(pitch);
  std::vector<float> rows(HIGHLIGHT_VERTEX_ROWS * pitch, 0.0f);
  const auto set_vector = [&](std::size_t row, std::size_t vertex, const glm::dvec3& v) {
    for (int axis = 0; axis < 3; ++axis) rows[(row + axis) * pitch + vertex] = static_cast<float>(v[axis]);
  };
  for (std::size_t vertex = 0; vertex < count; ++vertex) {
    set_vector(HIGHLIGHT_POSITION, vertex, mesh_.positions_m[vertex] - middle_m_);
    set_vector(HIGHLIGHT_NORMAL, vertex, mesh_.normals[vertex]);
    set_vector(HIGHLIGHT_E_MAX, vertex, curvatures_.e_max[vertex]);
    rows[HIGHLIGHT_K_MAX * pitch + vertex] = static_cast<float>(curvatures_.k_max_per_m[vertex]);
    rows[HIGHLIGHT_K_MIN * pitch + vertex] = static_cast<float>(curvatures_.k_min_per_m[vertex]);
  }
  if (vertex_rows_.empty()) vertex_rows_ = ocl::Buffer<float>(device_, rows.size(), "highlight vertices");
  vertex_rows_.write(rows);
}

void HighlightSurface::upload_faces() {
  std::vector<std::int32_t> corners(3 * std::max<std::size_t>(mesh_.faces.size(), 1), 0);
  for (std::size_t face = 0; face < mesh_.faces.size(); ++face) {
    for (std::size_t i = 0; i < 3; ++i) {
      corners[i * mesh_.faces.size() + face] = static_cast<std::int32_t>(mesh_.faces[face][i]);
    }
  }
  face_rows_ = ocl::Buffer<std::int32_t>(device_, corners, "highlight faces");
}

}  // namespace offing::highlights

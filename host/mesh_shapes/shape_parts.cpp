#include "host/mesh_shapes/shape_parts.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "kernels/shared/random.h"

namespace offing::mesh_shapes {
namespace {

int row_length(const Grid& grid, GridEnds ends) {
  return ends == GridEnds::open ? grid.v_cells + 1 : grid.v_cells;
}

/// 0 for a surface with a direction of its own, as VertexCurvatures has it.
double confidence_of(double k_max, double k_min) {
  const double sum = std::abs(k_max) + std::abs(k_min);
  return sum > 0.0 ? (k_max - k_min) / sum : 0.0;
}

}  // namespace

void require_shape_value(std::string_view name, double value, double least, double most) {
  if (std::isfinite(value) && value >= least && value <= most) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("{}: expected a value within {:g} ... {:g}, found {:g}", name, least, most, value),
              fmt::format("choose {} within that range", name));
}

void require_roughness(const Roughness& roughness) {
  require_shape_value("jitter", roughness.jitter, 0.0, largest_jitter);
  require_shape_value("normal noise", roughness.normal_noise, 0.0, largest_noise);
}

void require_shape_size(std::string_view name, double size_m) {
  require_shape_value(name, size_m, smallest_size_m, largest_size_m);
}

void require_grid(const Grid& grid, int least) {
  require_shape_value("cells along u", grid.u_cells, least, most_cells);
  require_shape_value("cells along v", grid.v_cells, least, most_cells);
}

ShapeRandom::ShapeRandom(std::uint64_t seed, std::size_t index) {
  const auto block = [&](int draw) {
    return philox_block(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                        OFFING_STREAM_SHAPES, static_cast<int>(index), draw, 0);
  };
  const PhiloxBlock first = block(0), second = block(1);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    within_one_[axis] = 2.0 * static_cast<double>(uniform_open01(first.v[axis])) - 1.0;
  }
  // Box & Muller 1958.
  const double radius = std::sqrt(-2.0 * std::log(static_cast<double>(uniform_open01(second.v[0]))));
  gaussian_ = radius * std::cos(2.0 * std::numbers::pi * static_cast<double>(uniform_open01(second.v[1])));
}

SurfacePoint level_set_point(const glm::dvec3& position_m, const glm::dvec3& gradient,
                             const SymmetricTensor& hessian) {
  const double slope = glm::length(gradient);
  const glm::dvec3 normal = gradient / slope;
  // The shape operator is the tangential part of the second derivatives over the slope.
  const TangentEigen eigen = tangent_eigen(hessian, normal);
  return {.position_m = position_m,
          .normal = normal,
          .k_max_per_m = eigen.larger / slope,
          .k_min_per_m = eigen.smaller / slope,
          .e_max = eigen.of_larger,
          .e_min = eigen.of_smaller};
}

Shape shape_of(const std::vector<SurfacePoint>& points, std::vector<TriangleIndices> faces, double noise_m,
               std::uint64_t seed) {
  Shape shape;
  TriangleMesh& mesh = shape.mesh;
  VertexCurvatures& truth = shape.truth.emplace();
  truth.area_m2.assign(points.size(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const SurfacePoint& point = points[i];
    const double off_m = noise_m > 0.0 ? noise_m * ShapeRandom(seed, i).gaussian() : 0.0;
    mesh.positions_m.push_back(point.position_m + off_m * point.normal);
    mesh.normals.push_back(point.normal);
    truth.k_max_per_m.push_back(point.k_max_per_m);
    truth.k_min_per_m.push_back(point.k_min_per_m);
    truth.e_max.push_back(point.e_max);
    truth.e_min.push_back(point.e_min);
    truth.confidence.push_back(confidence_of(point.k_max_per_m, point.k_min_per_m));
  }
  mesh.faces = std::move(faces);
  for (const auto& [a, b, c] : mesh.faces) {
    const glm::dvec3 across =
        glm::cross(mesh.positions_m[b] - mesh.positions_m[a], mesh.positions_m[c] - mesh.positions_m[a]);
    for (const std::uint32_t corner : {a, b, c}) truth.area_m2[corner] += glm::length(across) / 6.0;
  }
  return shape;
}

std::vector<TriangleIndices> grid_faces(const Grid& grid, GridEnds ends, std::uint64_t seed) {
  const int columns = ends == GridEnds::open ? grid.u_cells + 1 : grid.u_cells;
  const int rows = row_length(grid, ends);
  const auto vertex = [&](int u, int v) { return static_cast<std::uint32_t>(u % columns * rows + v % rows); };
  std::vector<TriangleIndices> faces;
  faces.reserve(2 * static_cast<std::size_t>(grid.u_cells) * static_cast<std::size_t>(grid.v_cells));
  for (int u = 0; u < grid.u_cells; ++u) {
    for (int v = 0; v < grid.v_cells; ++v) {
      const std::uint32_t a = vertex(u, v), b = vertex(u + 1, v), c = vertex(u + 1, v + 1),
                          d = vertex(u, v + 1);
      // Cells draw from behind the vertices.
      const std::size_t cell = faces.size() / 2 + (std::size_t{1} << 30);
      if (grid.diagonals == Diagonals::random && ShapeRandom(seed, cell).coin()) {
        faces.insert(faces.end(), {{a, b, d}, {b, c, d}});
      } else {
        faces.insert(faces.end(), {{a, b, c}, {a, c, d}});
      }
    }
  }
  return faces;
}

TriangleMesh lofted(const Grid& grid, const std::function<glm::dvec3(int, int)>& at) {
  TriangleMesh mesh;
  const auto ring_size = static_cast<std::uint32_t>(grid.v_cells),
             first_of_last = static_cast<std::uint32_t>(grid.u_cells) * ring_size;
  for (int ring = 0; ring <= grid.u_cells; ++ring) {
    for (int point = 0; point < grid.v_cells; ++point) mesh.positions_m.push_back(at(ring, point));
  }
  const std::uint32_t begin = first_of_last + ring_size, end = begin + 1;
  for (const std::uint32_t first : {0u, first_of_last}) {
    glm::dvec3 sum(0.0);
    for (std::uint32_t i = 0; i < ring_size; ++i) sum += mesh.positions_m[first + i];
    mesh.positions_m.push_back(sum / static_cast<double>(ring_size));
  }
  for (std::uint32_t i = 0; i < ring_size; ++i) {
    const std::uint32_t next = (i + 1) % ring_size;
    mesh.faces.push_back({begin, next, i});
    for (std::uint32_t first = 0; first < first_of_last; first += ring_size) {
      const std::uint32_t a = first + i, b = first + ring_size + i, c = first + ring_size + next,
                          d = first + next;
      mesh.faces.insert(mesh.faces.end(), {{a, c, b}, {a, d, c}});
    }
    mesh.faces.push_back({end, first_of_last + i, first_of_last + next});
  }
  return mesh;
}

}  // namespace offing::mesh_shapes

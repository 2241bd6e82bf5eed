#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string_view>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/tangent_plane.h"
#include "host/base/triangle_mesh.h"
#include "host/mesh_shapes/shape.h"

namespace offing::mesh_shapes {

/// Throws Error(bad_usage) unless the value is finite and within the range.
void require_shape_value(std::string_view name, double value, double least, double most);
void require_roughness(const Roughness& roughness);
void require_shape_size(std::string_view name, double size_m);
/// At least `least` cells each way, at most most_cells.
void require_grid(const Grid& grid, int least);

/// What is drawn for a vertex or a cell: numbers depend on the seed and on the index alone.
class ShapeRandom {
 public:
  ShapeRandom(std::uint64_t seed, std::size_t index);

  double within_one(int axis) const {
    return within_one_[static_cast<std::size_t>(axis)];
  }  ///< uniform in -1 ... 1; axes 0 ... 2
  double gaussian() const { return gaussian_; }
  bool coin() const { return within_one_[0] < 0.0; }

 private:
  std::array<double, 3> within_one_{};
  double gaussian_ = 0.0;
};

/// A place of a smooth surface: where, which way is out, how it bends.
struct SurfacePoint {
  glm::dvec3 position_m{}, normal{};
  double k_max_per_m = 0.0, k_min_per_m = 0.0;
  glm::dvec3 e_max{}, e_min{};  ///< e_max x e_min = normal
};

/// The place of a level set whose function grows outward, from its gradient and its second derivatives there.
SurfacePoint level_set_point(const glm::dvec3& position_m, const glm::dvec3& gradient,
                             const SymmetricTensor& hessian);

/// The mesh and truth of surface points, moved off the surface by Gaussian noise of this standard deviation.
Shape shape_of(const std::vector<SurfacePoint>& points, std::vector<TriangleIndices> faces, double noise_m,
               std::uint64_t seed);

/// Which ends of a grid are one.
enum class GridEnds { open, u_and_v_closed };

/// Two triangles a cell, anticlockwise seen from where u x v points; vertex (u, v) is at u * row_length + v,
/// a row having v_cells vertices where it is closed, else one more.
std::vector<TriangleIndices> grid_faces(const Grid& grid, GridEnds ends, std::uint64_t seed);

/// A closed surface of u_cells + 1 rings of v_cells points each, at(ring, point), each end closed by a fan
/// about its middle. Its outside is where v x u points, v along a ring.
TriangleMesh lofted(const Grid& grid, const std::function<glm::dvec3(int, int)>& at);

/// Unit vectors and faces of an icosphere. Corners move by up to jitter mean edge lengths along each axis
/// before they return to the sphere.
struct Icosphere {
  std::vector<glm::dvec3> directions;
  std::vector<TriangleIndices> faces;
  double edge = 0.0;  ///< mean length of an edge
};
Icosphere icosphere(int level, const Roughness& roughness);

}  // namespace offing::mesh_shapes

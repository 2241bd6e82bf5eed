#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "host/base/triangle_mesh.h"

namespace offing::mesh_shapes {

/// A mesh made by a formula.
struct Shape {
  TriangleMesh mesh;  ///< with the normals of the smooth surface where truth is known, else with none
  /// What the smooth surface has where the vertices lie (before noise); areas are those of the mesh. Absent
  /// where no formula gives it.
  std::optional<VertexCurvatures> truth;
};

/// Sizes that single precision and a renderer can still handle.
inline constexpr double smallest_size_m = 1e-6, largest_size_m = 1e9;
inline constexpr int most_cells = 1 << 13;  ///< of a grid, each way
inline constexpr int finest_level = 9;      ///< of an icosphere
inline constexpr int most_windings = 64;    ///< of a knot, each way
/// With more, neighbours in a grid could pass one another and turn their faces over.
inline constexpr double largest_jitter = 0.45;
inline constexpr double largest_noise = 1.0;

/// How far vertices are from where an even mesh would have them. Drawn from the seed, vertex by vertex.
struct Roughness {
  double jitter = 0.0;        ///< along the surface, up to this many edge lengths a direction
  double normal_noise = 0.0;  ///< off the surface: the standard deviation in edge lengths
  std::uint64_t seed = 1;
};

/// Which way squares of a grid are cut into triangles.
enum class Diagonals { parallel, random };

/// A grid of cells over two parameters.
struct Grid {
  int u_cells = 0, v_cells = 0;
  Diagonals diagonals = Diagonals::parallel;
};

/// Icospheres of 20 * 4^level faces, whose edges are split in halves. All shapes throw
/// Error(bad_usage) for sizes that are not positive and finite, and for what is not within the ranges said
/// here.
Shape make_sphere(double radius_m, int level, const Roughness& roughness = {});

/// An icosphere, stretched to three semi-axes.
Shape make_ellipsoid(const glm::dvec3& semi_axes_m, int level, const Roughness& roughness = {});

/// A sphere with smooth bumps and hollows up to this height, at most 0.3 radii.
Shape make_bumpy_sphere(double radius_m, double height_m, int level, const Roughness& roughness = {});

/// About the z axis; u runs around it, v around the tube. The edge length of the roughness is that of a cell,
/// along u and along v; noise counts in edges along v. tube_radius_m < radius_m; 3 cells or more each way.
Shape make_torus(double radius_m, double tube_radius_m, const Grid& grid, const Roughness& roughness = {});

/// A tube along the knot that winds `around` times about the z axis and `through` times through the hole of a
/// torus: (2, 3) is the trefoil. Sizes as a torus; the tube must be thin enough not to bend onto itself.
struct TorusKnot {
  int around = 2, through = 3;
  double radius_m = 1.0;        ///< of the torus that it lies on
  double winding_m = 0.45;      ///< radius of that torus's tube
  double tube_radius_m = 0.18;  ///< of the knot's own tube
};
/// 120 x 12 cells are 2,880 faces.
Shape make_torus_knot(const TorusKnot& knot, const Grid& grid, const Roughness& roughness = {});

/// The patch z = (0.75 x^2 - 0.4 y^2 + 0.1 x^3 / s) / s over |x|, |y| <= s = half_width_m, with its border;
/// no jitter on the border across it.
Shape make_saddle(double half_width_m, const Grid& grid, const Roughness& roughness = {});

/// A blob with skull, brow, nose, cheeks, chin, ears and neck, star-shaped about its middle: the level set of
/// a sum of Gaussians, looking toward +z with +y up. radius_m is about that of the skull.
Shape make_head(double radius_m, int level, const Roughness& roughness = {});

/// A hull with its deck: a closed surface of u_cells sections of v_cells quads and a fan at each end, bow
/// toward +x, +y up. Its edges (sheer, stem, transom) have no curvature, so that there is no truth. Beam and
/// depth follow from the length.
Shape make_ship(double length_m, const Grid& grid);

/// An open boat with a deck at each end, bow toward +x, +y up: a closed surface of an outer and an inner
/// skin, whose sections have v_cells quads, half of them outside; 8 or more. No truth, as for ships.
Shape make_boat(double length_m, const Grid& grid);

/// A box about the origin, each side of so many cells a side. No truth, for its edges.
Shape make_box(const glm::dvec3& sides_m, int cells);

/// A closed cylinder about the y axis, its middle at the origin: u_cells rings of cells from its bottom to
/// its top, v_cells around it, 3 or more each; a fan closes each end. No truth, for its edges.
Shape make_cylinder(double radius_m, double height_m, const Grid& grid);

/// A closed cone about the y axis, its apex up and half of its height above the origin; cells as a
/// cylinder's, the last of which are a fan about the apex.
Shape make_cone(double radius_m, double height_m, const Grid& grid);

/// A bird that soars toward +x, +y up, its wings raised: a closed surface of u_cells ellipses of v_cells
/// points from tip to tip along z, and a fan at each tip; no truth, for its beak has edges.
Shape make_bird(double span_m, const Grid& grid);

}  // namespace offing::mesh_shapes

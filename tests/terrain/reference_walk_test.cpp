// The reference itself, against all cells of a map one by one: no order of cells, no crossings, no early end.
#include "tests/terrain/reference_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include <gtest/gtest.h>

namespace offing::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Smallest t >= 0 at which a ray meets the patch of a cell: the quadratic of T6, whose constant and whose
/// last term of b the print has wrong, and its roots within the patch (T7).
double patch_hit_m(const HeightMap& map, const terrain::Ray& ray, int column, int row) {
  // In cells from the patch's corner, and metres up; long double, as nothing here is done to save digits.
  using Real = long double;
  const Real px = (ray.origin_m.x - map.grid.origin_x_m) / map.grid.spacing_x_m - column;
  const Real pz = (ray.origin_m.z - map.grid.origin_z_m) / map.grid.spacing_z_m - row;
  const Real py = ray.origin_m.y;
  const Real ex = ray.direction.x / map.grid.spacing_x_m, ez = ray.direction.z / map.grid.spacing_z_m;
  const Real ey = ray.direction.y;
  const auto height_m = [&](int right, int down) { return Real(map.at(column + right, row + down)); };
  const Real z00 = height_m(0, 0), b1 = height_m(1, 0) - z00, c1 = height_m(0, 1) - z00;
  const Real a1 = height_m(1, 1) - height_m(0, 1) - height_m(1, 0) + z00;
  const Real a = ex * ez * a1;
  const Real b = (ex * pz + ez * px) * a1 + ex * b1 + ez * c1 - ey;
  const Real c = px * pz * a1 + px * b1 + pz * c1 + z00 - py;
  std::array<Real, 2> roots{infinity, infinity};
  if (a == 0.0L) {
    if (b != 0.0L) roots[0] = -c / b;
  } else if (const Real discriminant = b * b - 4.0L * a * c; discriminant >= 0.0L) {
    const Real q = -0.5L * (b + std::copysign(std::sqrt(discriminant), b));
    roots[0] = q / a;
    if (q != 0.0L) roots[1] = c / q;
  }
  Real first = infinity;
  constexpr Real slack = 1e-12L;  // of a cell: neighbours share their border
  for (const Real root : roots) {
    const Real u = px + root * ex, v = pz + root * ez;
    const bool is_within = u >= -slack && u <= 1.0L + slack && v >= -slack && v <= 1.0L + slack;
    if (root >= 0.0L && is_within) first = std::min(first, root);
  }
  return static_cast<double>(first);
}

double first_hit_m(const HeightMap& map, const terrain::Ray& ray) {
  double first_m = infinity;
  for (int row = 0; row + 1 < map.grid.rows; ++row) {
    for (int column = 0; column + 1 < map.grid.columns; ++column) {
      first_m = std::min(first_m, patch_hit_m(map, ray, column, row));
    }
  }
  return first_m;
}

// Fails if the reference leaves out a cell or a root, or takes a later one. Rays that start below the ground
// or come in through its side meet the surface from below, which the reference does not: they are left out.
// Gate 1e-9 of the distance across the surface: the reference is in double precision.
TEST(ReferenceWalkTest, FindsTheFirstOfAllCells) {
  for (const HeightMap& map : example_maps()) {
    int hits = 0;
    for (const terrain::Ray& ray : example_rays(map, 400, 21)) {
      const ReferenceHit found = reference_hit(map, ray);
      if (found.kind == TERRAIN_INSIDE || found.kind == TERRAIN_SIDE) continue;
      const double expected_m = first_hit_m(map, ray);
      if (std::isinf(expected_m) || std::isinf(found.distance_m)) {
        EXPECT_EQ(expected_m, found.distance_m) << map.name;
      } else {
        EXPECT_NEAR(found.distance_m, expected_m, 1e-9 * std::max(1.0, expected_m) / found.facing)
            << map.name;
        ++hits;
      }
    }
    EXPECT_GT(hits, 40) << map.name;
  }
}

}  // namespace
}  // namespace offing::test

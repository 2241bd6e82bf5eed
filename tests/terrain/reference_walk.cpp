#include "tests/terrain/reference_walk.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

namespace offing::test {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// One horizontal axis in cells: place = start + t along, between 0 and `cells`.
struct Axis {
  double start, along;
  int cells;

  double entry() const {
    return along == 0.0 ? (is_within() ? -infinity : infinity) : std::min(at(0), at(cells));
  }
  double exit() const {
    return along == 0.0 ? (is_within() ? infinity : -infinity) : std::max(at(0), at(cells));
  }
  bool is_within() const { return start >= 0.0 && start <= cells; }
  double at(int border) const { return (border - start) / along; }
  int cell_at(double t) const {
    const double place = along == 0.0 ? start : start + t * along;
    return std::clamp(static_cast<int>(std::floor(place)), 0, cells - 1);
  }
};

/// All t between entry and exit at which the ray crosses a border of cells, in order.
std::vector<double> crossings(const std::array<Axis, 2>& axes, double entry, double exit) {
  std::vector<double> all{entry, exit};
  for (const Axis& axis : axes) {
    if (axis.along == 0.0) continue;
    const auto [first, last] = std::minmax({axis.cell_at(entry), axis.cell_at(std::min(exit, 1e9))});
    for (int border = first; border <= last + 1; ++border) {
      const double t = axis.at(border);
      if (t > entry && t < exit) all.push_back(t);
    }
  }
  std::sort(all.begin(), all.end());
  return all;
}

/// Smallest s in 0 ... length with f0 + f1 s + f2 s^2 <= 0.
double first_root(double f0, double f1, double f2, double length) {
  if (f0 <= 0.0) return 0.0;
  std::array<double, 2> roots{infinity, infinity};
  const double discriminant = f1 * f1 - 4.0 * f2 * f0;
  if (discriminant >= 0.0) {
    const double q = -0.5 * (f1 + std::copysign(std::sqrt(discriminant), f1));
    if (f2 != 0.0) roots[0] = q / f2;
    if (q != 0.0) roots[1] = f0 / q;
  }
  double first = infinity;
  for (const double root : roots) {
    if (root >= 0.0 && root <= length) first = std::min(first, root);
  }
  if (first == infinity && f0 + length * (f1 + length * f2) < 0.0) return length;
  return first;
}

}  // namespace

ReferenceHit reference_hit(const HeightMap& map, const terrain::Ray& ray, double raised_m) {
  const auto& grid = map.grid;
  const std::array axes{Axis{(ray.origin_m.x - grid.origin_x_m) / grid.spacing_x_m,
                             ray.direction.x / grid.spacing_x_m, grid.columns - 1},
                        Axis{(ray.origin_m.z - grid.origin_z_m) / grid.spacing_z_m,
                             ray.direction.z / grid.spacing_z_m, grid.rows - 1}};
  const double entry = std::max({0.0, axes[0].entry(), axes[1].entry()});
  const double exit = std::min({axes[0].exit(), axes[1].exit(), ray.limit_m, 1e15});
  if (!(entry <= exit)) return {.distance_m = infinity};
  const std::vector<double> borders = crossings(axes, entry, exit);
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const double from = borders[i], length = borders[i + 1] - from;
    // A middle within the farthest that matters: vertical rays never leave their cell.
    const double middle = from + 0.5 * std::min(length, 1e6);
    const int column = axes[0].cell_at(middle), row = axes[1].cell_at(middle);
    const double h0 = static_cast<double>(map.at(column, row)) + raised_m;
    const double a = static_cast<double>(map.at(column + 1, row)) + raised_m - h0;
    const double b = static_cast<double>(map.at(column, row + 1)) + raised_m - h0;
    const double c = static_cast<double>(map.at(column + 1, row + 1)) + raised_m - h0 - a - b;
    const double dx = axes[0].along, dz = axes[1].along;
    const double u = axes[0].start + from * dx - column, v = axes[1].start + from * dz - row;
    const double f0 = ray.origin_m.y + from * ray.direction.y - (h0 + a * u + b * v + c * u * v);
    const double f1 = ray.direction.y - (a * dx + b * dz + c * (u * dz + v * dx));
    const double way = first_root(f0, f1, -c * dx * dz, length);
    if (way == infinity) continue;
    const bool starts_below = i == 0 && f0 <= 0.0;
    const double slope_x = (a + c * (v + way * dz)) / grid.spacing_x_m,
                 slope_z = (b + c * (u + way * dx)) / grid.spacing_z_m;
    const double facing = std::abs(ray.direction.y - slope_x * ray.direction.x - slope_z * ray.direction.z) /
                          std::sqrt(1.0 + slope_x * slope_x + slope_z * slope_z);
    if (starts_below && entry == 0.0) return {0.0, TERRAIN_INSIDE, 1.0};
    if (starts_below) {
      const bool comes_along_x = axes[0].entry() > axes[1].entry();
      return {from, TERRAIN_SIDE, std::abs(comes_along_x ? ray.direction.x : ray.direction.z)};
    }
    return {from + way, TERRAIN_SURFACE, facing};
  }
  return {.distance_m = infinity};
}

}  // namespace offing::test

#include "tests/terrain/analysis/sight_reference.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace offing::test {
namespace {

/// Shares of the way at which it crosses a border of cells, in order.
std::vector<double> crossings(double start_x, double way_x, double start_z, double way_z) {
  std::vector<double> all{0.0, 1.0};
  const auto add = [&](double start, double way) {
    const double end = start + way;
    for (double border = std::floor(std::min(start, end)) + 1.0; border < std::max(start, end); ++border) {
      all.push_back((border - start) / way);
    }
  };
  add(start_x, way_x);
  add(start_z, way_z);
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace

double reference_clearance_m(const HeightMap& map, const terrain::ViewshedParameters& parameters, int column,
                             int row) {
  const auto& grid = map.grid;
  const double start_x = (parameters.observer_x_m - grid.origin_x_m) / grid.spacing_x_m;
  const double start_z = (parameters.observer_z_m - grid.origin_z_m) / grid.spacing_z_m;
  const double way_x = column - start_x, way_z = row - start_z;
  const double distance_m = std::hypot(way_x * grid.spacing_x_m, way_z * grid.spacing_z_m);
  const double bend_m = parameters.curve.bend_perm() * distance_m * distance_m;
  struct Patch {
    double h, a, b, c;
  };
  const auto patch_at = [&](double x, double z) -> std::pair<Patch, std::pair<double, double>> {
    const int left = std::clamp(static_cast<int>(x), 0, grid.columns - 2);
    const int top = std::clamp(static_cast<int>(z), 0, grid.rows - 2);
    const double h = map.at(left, top), a = map.at(left + 1, top) - h, b = map.at(left, top + 1) - h;
    return {{h, a, b, map.at(left + 1, top + 1) - h - a - b}, {left, top}};
  };
  const auto surface_m = [](const Patch& patch, double u, double v) {
    return patch.h + patch.a * u + patch.b * v + patch.c * u * v;
  };
  const auto [under, place] = patch_at(start_x, start_z);
  const double eye_m =
      surface_m(under, start_x - place.first, start_z - place.second) + parameters.observer_height_m;
  const double rise_m = map.at(column, row) + parameters.target_height_m - eye_m - bend_m;

  // A crossing nearer to an end is as good as on it.
  constexpr double nearest = 1e-6;
  const double cells = std::hypot(way_x, way_z);
  double clearance_m = std::numeric_limits<double>::infinity();
  const std::vector<double> borders = crossings(start_x, way_x, start_z, way_z);
  for (std::size_t i = 0; i + 1 < borders.size(); ++i) {
    const double from = borders[i], length = borders[i + 1] - from, middle = from + 0.5 * length;
    const auto [patch, corner] = patch_at(start_x + middle * way_x, start_z + middle * way_z);
    const double u = start_x + from * way_x - corner.first, v = start_z + from * way_z - corner.second;
    const double f0 = eye_m + from * (rise_m + from * bend_m) - surface_m(patch, u, v);
    const double f1 = rise_m + 2.0 * from * bend_m -
                      (patch.a * way_x + patch.b * way_z + patch.c * (u * way_z + v * way_x));
    const double f2 = bend_m - patch.c * way_x * way_z;
    const auto look_at = [&](double s) {
      const double from_end = std::min(from + s, 1.0 - from - s) * cells;
      if (from_end < nearest) return;
      clearance_m = std::min(clearance_m, (f0 + s * (f1 + s * f2)) / std::min(1.0, from_end));
    };
    look_at(0.0);
    look_at(length);
    if (f2 > 0.0 && f1 < 0.0 && f1 + 2.0 * f2 * length > 0.0) look_at(-0.5 * f1 / f2);
  }
  return clearance_m;
}

}  // namespace offing::test

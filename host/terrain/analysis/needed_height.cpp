#include "host/terrain/analysis/needed_height.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "host/base/parallel_for.h"
#include "host/terrain/field/post_grid.h"
#include "host/terrain/field/terrain_posts.h"

namespace offing::terrain {
namespace {

/// Lines from an eye over a map. Places are in cells, t is the share of the way to a post.
class HorizonWalk {
 public:
  HorizonWalk(const HeightMap& map, const ViewshedParameters& parameters)
      : map_(map),
        x_(parameters.observer_x_m / map.spacing_x_m),
        z_(parameters.observer_z_m / map.spacing_z_m),
        eye_m_(terrain_at(map, parameters.observer_x_m, parameters.observer_z_m)->height_m +
               parameters.observer_height_m),
        is_on_ground_(parameters.observer_height_m == 0.0),
        bend_perm_(parameters.curve.bend_perm()),
        radius_m_(parameters.radius_m) {}

  float needed_m(int column, int row) const {
    const double dx = column - x_, dz = row - z_;
    const double plan_m = std::hypot(dx * map_.spacing_x_m, dz * map_.spacing_z_m);
    if (plan_m > radius_m_) return std::numeric_limits<float>::quiet_NaN();
    const double fall_m = bend_perm_ * plan_m * plan_m;
    // Rise over the whole way of the steepest line from the eye to ground on it.
    double steepest_m = height_m(column, row) - fall_m - eye_m_;
    const double rise_m = steepest_m;
    const double step_x = dx != 0.0 ? 1.0 / std::abs(dx) : infinite,
                 step_z = dz != 0.0 ? 1.0 / std::abs(dz) : infinite;
    double next_x = first_line(x_, dx), next_z = first_line(z_, dz);
    for (double from = 0.0; from < 1.0;) {
      const double to = std::min({next_x, next_z, 1.0});
      if (to > from) steepest_m = std::max(steepest_m, steepest_between(from, to, dx, dz, fall_m));
      if (next_x <= to) next_x += step_x;
      if (next_z <= to) next_z += step_z;
      from = to;
    }
    // The post's own ground is on the line to it, but for rounding.
    constexpr double rounding_m = 1e-9;
    const double needed_m = steepest_m - rise_m;
    return needed_m > rounding_m ? static_cast<float>(needed_m) : 0.0f;
  }

 private:
  static constexpr double infinite = std::numeric_limits<double>::infinity();

  /// Where a line that goes `way` cells from `start` first meets a line of posts.
  static double first_line(double start, double way) {
    if (way == 0.0) return infinite;
    const double line = way > 0.0 ? std::floor(start) + 1.0 : std::ceil(start) - 1.0;
    return (line - start) / way;
  }

  double height_m(int column, int row) const {
    return static_cast<double>(map_.heights_m[map_.index(column, row)]);
  }

  /// The same within one cell: the ground is a t^2 + b t + c, its slope from the eye a t + b + (c - eye) / t.
  double steepest_between(double from, double to, double dx, double dz, double fall_m) const {
    const double middle = 0.5 * (from + to);
    const int column = std::clamp(static_cast<int>(x_ + middle * dx), 0, map_.columns - 2);
    const int row = std::clamp(static_cast<int>(z_ + middle * dz), 0, map_.rows - 2);
    const double corner_m = height_m(column, row);
    const double east_m = height_m(column + 1, row) - corner_m,
                 south_m = height_m(column, row + 1) - corner_m;
    const double twist_m = height_m(column + 1, row + 1) - corner_m - east_m - south_m;
    const double u = x_ - column, v = z_ - row;
    const double a = twist_m * dx * dz - fall_m;
    const double b = east_m * dx + south_m * dz + twist_m * (u * dz + v * dx);
    // An eye on the ground has none below it, whatever rounding says.
    const double below_m =
        from == 0.0 && is_on_ground_ ? 0.0 : corner_m + east_m * u + south_m * v + twist_m * u * v - eye_m_;
    const auto slope_at = [&](double t) { return a * t + b + below_m / t; };
    double steepest_m = slope_at(to);
    // At the eye itself there is ground only where the eye lies on it: lines rise like it there.
    if (from > 0.0) steepest_m = std::max(steepest_m, slope_at(from));
    if (from == 0.0 && is_on_ground_) steepest_m = std::max(steepest_m, b);
    if (below_m < 0.0 && a < 0.0) {
      const double top = std::sqrt(below_m / a);
      if (top > from && top < to) steepest_m = std::max(steepest_m, slope_at(top));
    }
    return steepest_m;
  }

  const HeightMap& map_;
  double x_, z_, eye_m_;
  bool is_on_ground_;
  double bend_perm_, radius_m_;
};

}  // namespace

std::vector<float> needed_heights(const HeightMap& map, const ViewshedParameters& parameters,
                                  const CancelToken& cancel) {
  require_valid(parameters, post_grid(map));
  const HorizonWalk walk(map, parameters);
  std::vector<float> needed_m(map.heights_m.size());
  parallel_rows(map.rows, [&](int row) {
    cancel.throw_if_cancelled();
    for (int column = 0; column < map.columns; ++column)
      needed_m[map.index(column, row)] = walk.needed_m(column, row);
  });
  return needed_m;
}

}  // namespace offing::terrain

#include "host/terrain/analysis/sight_clearance.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

namespace offing::terrain {
namespace {

constexpr double light_mps = 299'792'458.0;

/// A line by its share t of the way, 0 ... 1.
class ClearLine {
 public:
  ClearLine(const TerrainPosts& posts, const EarthCurve& curve, const SightEnd& from, const SightEnd& to)
      : posts_(posts),
        from_(from),
        to_(to),
        distance_m_(LineOfSight(posts, curve, from, to).distance_m()),
        bend_perm_(curve.bend_perm()),
        plan_m_(std::hypot(to.x_m - from.x_m, to.z_m - from.z_m)),
        from_m_(ground_m(0.0) + from.height_m),
        to_m_(ground_m(1.0) + to.height_m - bend_perm_ * plan_m_ * plan_m_) {}

  double distance_m() const { return distance_m_; }
  double x_m(double t) const { return std::lerp(from_.x_m, to_.x_m, t); }
  double z_m(double t) const { return std::lerp(from_.z_m, to_.z_m, t); }
  double ground_m(double t) const { return terrain_at(posts_, x_m(t), z_m(t))->height_m; }
  double clearance_m(double t) const {
    const double way_m = t * plan_m_;
    return std::lerp(from_m_, to_m_, t) + bend_perm_ * way_m * way_m - ground_m(t);
  }

  /// Shares at which the line goes from cell to cell, and both ends.
  std::vector<double> cell_edges() const {
    std::vector<double> edges{0.0, 1.0};
    const auto add = [&edges](double from, double to) {
      const double low = std::min(from, to), high = std::max(from, to);
      for (double line = std::floor(low) + 1.0; line < high; line += 1.0)
        edges.push_back((line - from) / (to - from));
    };
    add(from_.x_m / posts_.spacing_x_m, to_.x_m / posts_.spacing_x_m);
    add(from_.z_m / posts_.spacing_z_m, to_.z_m / posts_.spacing_z_m);
    std::ranges::sort(edges);
    return edges;
  }

 private:
  const TerrainPosts& posts_;
  SightEnd from_, to_;
  double distance_m_, bend_perm_, plan_m_, from_m_, to_m_;
};

/// Where a parabola through three places that are h apart, the first at t, is lowest; t where the parabola
/// has no lowest place.
double lowest_at(double t, double h, double first, double middle, double last) {
  const double curvature = first - 2.0 * middle + last;
  if (!(curvature > 0.0)) return t;
  return t + h * std::clamp(1.0 + 0.5 * (first - last) / curvature, 0.0, 2.0);
}

}  // namespace

SightClearance sight_clearance(const TerrainPosts& posts, const EarthCurve& curve, const SightEnd& from,
                               const SightEnd& to) {
  const ClearLine line(posts, curve, from, to);
  double lowest_m = std::numeric_limits<double>::infinity(), at = 0.0;
  const auto look = [&](double t) {
    const double clearance_m = line.clearance_m(t);
    if (clearance_m < lowest_m) {
      lowest_m = clearance_m;
      at = t;
    }
    return clearance_m;
  };
  const std::vector<double> edges = line.cell_edges();
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const double h = 0.5 * (edges[i + 1] - edges[i]);
    const double first = look(edges[i]), middle = line.clearance_m(edges[i] + h), last = look(edges[i + 1]);
    look(lowest_at(edges[i], h, first, middle, last));
  }
  return {lowest_m, at * line.distance_m(), line.x_m(at), line.z_m(at), line.ground_m(at)};
}

FresnelClearance fresnel_clearance(const TerrainPosts& posts, const EarthCurve& curve, const SightEnd& from,
                                   const SightEnd& to, double frequency_hz) {
  const ClearLine line(posts, curve, from, to);
  const double wave_m = light_mps / frequency_hz;
  const auto radius_m = [&](double t) { return std::sqrt(wave_m * line.distance_m() * t * (1.0 - t)); };
  const auto share = [&](double t) { return line.clearance_m(t) / radius_m(t); };
  constexpr int samples = 8;
  // At an end on the ground both are 0.
  constexpr double end = 1e-6;
  double low = end, high = 1.0 - end, lowest = std::numeric_limits<double>::infinity();
  const std::vector<double> edges = line.cell_edges();
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const double step = (edges[i + 1] - edges[i]) / samples;
    for (int sample = 0; sample <= samples; ++sample) {
      const double t = std::clamp(edges[i] + sample * step, end, 1.0 - end);
      const double found = share(t);
      if (found >= lowest) continue;
      lowest = found;
      low = std::max(end, t - step);
      high = std::min(1.0 - end, t + step);
    }
  }
  // Golden section, from two samples of a cell down to 1e-8 of them.
  constexpr double golden = 0.6180339887498949;
  for (int i = 0; i < 40; ++i) {
    const double left = high - golden * (high - low), right = low + golden * (high - low);
    if (share(left) < share(right)) {
      high = right;
    } else {
      low = left;
    }
  }
  const double at = 0.5 * (low + high);
  return {share(at), at * line.distance_m(), radius_m(at)};
}

}  // namespace offing::terrain

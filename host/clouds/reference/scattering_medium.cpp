#include "host/clouds/reference/scattering_medium.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/base/error.h"
#include "host/clouds/light/field_albedo.h"

namespace offing::clouds {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
// Estimates of transmittance below this go on with a chance in proportion: most of what they would walk is
// dark.
constexpr double least_sure_share = 0.05;

/// Distances at which a ray enters and leaves a <= coordinate <= b, from 0 on; empty if first > second.
std::pair<double, double> span_between(double from, double direction, double a, double b) {
  if (direction == 0.0) return from >= a && from <= b ? std::pair{0.0, infinity} : std::pair{1.0, 0.0};
  const double first = (a - from) / direction, second = (b - from) / direction;
  return {std::max(0.0, std::min(first, second)), std::max(first, second)};
}

}  // namespace

double SlabMedium::next_collision(const Ray& ray, PathRandom& random) const {
  const auto [enter, leave] = span_between(ray.origin_m.y, ray.direction.y, bottom_m_, top_m_);
  const double distance = enter - std::log(random.next()) / extinction_per_m_;
  return enter <= leave && distance < leave ? distance : infinity;
}

double SlabMedium::transmittance(const Ray& ray, PathRandom&) const {
  const auto [enter, leave] = span_between(ray.origin_m.y, ray.direction.y, bottom_m_, top_m_);
  return std::exp(-extinction_per_m_ * std::max(0.0, leave - enter));
}

VolumeMedium::VolumeMedium(const CloudVolume& volume)
    : origin_m_(volume.origin_m), cell_m_(volume.cell_m), size_(volume.bricks) {
  if (!volume.albedo.empty()) albedo_ = volume;
  constexpr int edge = CloudVolume::brick_cells;
  const auto cell = [&](int x, int y, int z) -> double {
    if (x < 0 || y < 0 || z < 0 || x >= edge * size_[0] || y >= edge * size_[1] || z >= edge * size_[2])
      return 0.0;
    const int brick = ((z / edge) * size_[1] + y / edge) * size_[0] + x / edge;
    const std::int32_t kept = volume.brick_of[static_cast<std::size_t>(brick)];
    if (kept == CloudVolume::no_brick) return 0.0;
    const auto inside = static_cast<std::size_t>(((z % edge) * edge + y % edge) * edge + x % edge);
    return volume.density[static_cast<std::size_t>(kept) * CloudVolume::cells_of_brick + inside];
  };
  brick_of_.assign(volume.brick_of.size(), CloudVolume::no_brick);
  glm::dvec3 low(infinity), high(-infinity);
  for (int index = 0; index < static_cast<int>(brick_of_.size()); ++index) {
    const int bx = index % size_[0], by = index / size_[0] % size_[1], bz = index / size_[0] / size_[1];
    Brick brick;
    std::size_t at = 0;
    for (int z = -1; z <= edge; ++z) {
      for (int y = -1; y <= edge; ++y) {
        for (int x = -1; x <= edge; ++x) {
          const double value = cell(edge * bx + x, edge * by + y, edge * bz + z) * volume.extinction_per_m;
          if (!(value >= 0.0 && value < infinity)) {
            throw Error(
                ErrorKind::bad_input,
                fmt::format("volume: expected densities of 0 or more, got {} in brick {}", value, index));
          }
          brick.extinction_per_m[at++] = static_cast<float>(value);
          brick.most_per_m = std::max(brick.most_per_m, double{brick.extinction_per_m[at - 1]});
        }
      }
    }
    if (brick.most_per_m == 0.0) continue;
    brick_of_[static_cast<std::size_t>(index)] = static_cast<std::int32_t>(bricks_.size());
    brick.corner_m = origin_m_ + cell_m_ * edge * glm::dvec3(bx, by, bz);
    low = glm::min(low, brick.corner_m);
    high = glm::max(high, brick.corner_m + cell_m_ * edge);
    most_sums_.push_back((most_sums_.empty() ? 0.0 : most_sums_.back()) + brick.most_per_m);
    bricks_.push_back(brick);
  }
  // Interpolation keeps the sum over cells.
  for (const float density : volume.density)
    optical_mass_m2_ += density * volume.extinction_per_m * cell_m_ * cell_m_ * cell_m_;
  if (bricks_.empty())
    throw Error(ErrorKind::bad_input, "volume: expected some density, found none",
                "make the cells smaller, or the cloud denser");
  middle_m_ = 0.5 * (low + high);
  radius_m_ = 0.5 * glm::length(high - low);
}

double VolumeMedium::extinction(const Brick& brick, const glm::dvec3& cells_in_brick) const {
  // Cell middles are at halves, and the apron shifts by one.
  const glm::dvec3 at = glm::clamp(cells_in_brick + 0.5, glm::dvec3(0.0), glm::dvec3(apron_cells - 1.001));
  const int x = static_cast<int>(at.x), y = static_cast<int>(at.y), z = static_cast<int>(at.z);
  const double fx = at.x - x, fy = at.y - y, fz = at.z - z;
  const float* row = brick.extinction_per_m.data() + (z * apron_cells + y) * apron_cells + x;
  const auto along_x = [&](const float* first) { return first[0] + fx * (double{first[1]} - first[0]); };
  const double below = along_x(row) + fy * (along_x(row + apron_cells) - along_x(row));
  row += apron_cells * apron_cells;
  const double above = along_x(row) + fy * (along_x(row + apron_cells) - along_x(row));
  return below + fz * (above - below);
}

double VolumeMedium::extinction(const glm::dvec3& place_m) const {
  const glm::dvec3 cells = (place_m - origin_m_) / cell_m_, brick = glm::floor(cells / 8.0);
  for (int axis = 0; axis < 3; ++axis)
    if (!(brick[axis] >= 0.0 && brick[axis] < size_[static_cast<std::size_t>(axis)])) return 0.0;
  const auto index = static_cast<std::size_t>((brick.z * size_[1] + brick.y) * size_[0] + brick.x);
  const std::int32_t kept = brick_of_[index];
  return kept == CloudVolume::no_brick
             ? 0.0
             : extinction(bricks_[static_cast<std::size_t>(kept)], cells - 8.0 * brick);
}

glm::dvec3 VolumeMedium::albedo(const glm::dvec3& place_m, const glm::dvec3& of_look) const {
  if (!albedo_) return of_look;
  const auto [red, green, blue] = albedo_at(*albedo_, place_m);
  return {red, green, blue};
}

glm::dvec3 VolumeMedium::random_place(PathRandom& random) const {
  for (;;) {
    const auto above =
        std::upper_bound(most_sums_.begin(), most_sums_.end(), random.next() * most_sums_.back());
    const Brick& brick =
        bricks_[std::min(static_cast<std::size_t>(above - most_sums_.begin()), bricks_.size() - 1)];
    glm::dvec3 cells;
    for (int axis = 0; axis < 3; ++axis) cells[axis] = random.next() * CloudVolume::brick_cells;
    if (random.next() * brick.most_per_m < extinction(brick, cells)) return brick.corner_m + cell_m_ * cells;
  }
}

template <typename Visit>
void VolumeMedium::walk(const Ray& ray, const Visit& visit) const {
  // Amanatides & Woo 1987, "A fast voxel traversal algorithm", in bricks.
  const double brick_m = cell_m_ * CloudVolume::brick_cells;
  const glm::dvec3 from = (ray.origin_m - origin_m_) / brick_m, way = ray.direction / brick_m;
  double enter = 0.0, leave = infinity;
  for (int axis = 0; axis < 3; ++axis) {
    const auto span = span_between(from[axis], way[axis], 0.0, size_[static_cast<std::size_t>(axis)]);
    enter = std::max(enter, span.first);
    leave = std::min(leave, span.second);
  }
  if (!(enter < leave)) return;
  std::array<int, 3> at{}, step{};
  glm::dvec3 next(infinity), spacing(infinity);
  for (int axis = 0; axis < 3; ++axis) {
    const auto i = static_cast<std::size_t>(axis);
    const double place = from[axis] + enter * way[axis];
    at[i] = std::clamp(static_cast<int>(std::floor(place)), 0, size_[i] - 1);
    step[i] = way[axis] < 0.0 ? -1 : 1;
    if (way[axis] == 0.0) continue;
    spacing[axis] = std::abs(1.0 / way[axis]);
    next[axis] = (at[i] + (way[axis] > 0.0 ? 1 : 0) - from[axis]) / way[axis];
  }
  for (double t = enter; t < leave;) {
    const int axis = next.x < next.y ? (next.x < next.z ? 0 : 2) : (next.y < next.z ? 1 : 2);
    const double end = std::min(next[axis], leave);
    const std::int32_t kept =
        brick_of_[static_cast<std::size_t>((at[2] * size_[1] + at[1]) * size_[0] + at[0])];
    if (kept != CloudVolume::no_brick && end > t) {
      const glm::dvec3 corner(at[0], at[1], at[2]);
      const glm::dvec3 first = (from - corner) * double{CloudVolume::brick_cells},
                       a_metre = way * double{CloudVolume::brick_cells};
      const Brick& brick = bricks_[static_cast<std::size_t>(kept)];
      const auto extinction_at = [&](double distance) {
        return extinction(brick, first + distance * a_metre);
      };
      if (!visit(brick.most_per_m, extinction_at, t, end)) return;
    }
    t = end;
    const auto i = static_cast<std::size_t>(axis);
    at[i] += step[i];
    if (at[i] < 0 || at[i] >= size_[i]) return;
    next[axis] += spacing[axis];
  }
}

template <typename Collide>
void VolumeMedium::track(const Ray& ray, PathRandom& random, const Collide& collide) const {
  double depth_left = -std::log(random.next());
  walk(ray, [&](double most_per_m, const auto& extinction_at, double t, double end) {
    for (;;) {
      const double next = t + depth_left / most_per_m;
      if (next >= end) {
        depth_left -= (end - t) * most_per_m;
        return true;
      }
      t = next;
      if (!collide(t, extinction_at(t) / most_per_m)) return false;
      depth_left = -std::log(random.next());
    }
  });
}

double VolumeMedium::next_collision(const Ray& ray, PathRandom& random) const {
  double found = infinity;
  track(ray, random, [&](double distance, double share) {
    if (random.next() >= share) return true;
    found = distance;
    return false;
  });
  return found;
}

double VolumeMedium::transmittance(const Ray& ray, PathRandom& random) const {
  double kept = 1.0;
  track(ray, random, [&](double, double share) {
    kept *= 1.0 - share;
    if (kept >= least_sure_share) return true;
    if (random.next() * least_sure_share >= kept) {
      kept = 0.0;
      return false;
    }
    kept = least_sure_share;
    return true;
  });
  return kept;
}

}  // namespace offing::clouds

#include "host/terrain/analysis/sight_limits.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/vec2.hpp>

#include "host/base/error.h"
#include "host/terrain/field/terrain_posts.h"
#include "kernels/shared/terrain_sight.h"

namespace offing::terrain {
namespace {

constexpr double turn_rad = 2.0 * std::numbers::pi, quarter_rad = 0.5 * std::numbers::pi;
// Of angles that were given in degrees.
constexpr double rounding_rad = 1e-12, half_turn_rounding_rad = 1e-9;

/// In plan: east, south.
glm::dvec2 direction_of(double azimuth_rad) {
  return {std::sin(azimuth_rad), -std::cos(azimuth_rad)};
}

/// Above 0 where b is clockwise of a, by less than half a turn.
double clockwise(const glm::dvec2& a, const glm::dvec2& b) {
  return a.x * b.y - a.y * b.x;
}

/// A sector of azimuths.
class Sector {
 public:
  explicit Sector(const SightLimits& limits)
      : from_(direction_of(limits.azimuth_from_rad)), to_(direction_of(limits.azimuth_to_rad)) {
    const double width_rad = limits.azimuth_to_rad - limits.azimuth_from_rad;
    is_whole_ = std::abs(std::abs(width_rad) - turn_rad) <= rounding_rad;
    double turned_rad = std::fmod(width_rad, turn_rad);
    if (turned_rad < 0.0) turned_rad += turn_rad;
    // Of half a turn both ends are in one line, whose middle is known to rounding only.
    is_wide_ = turned_rad > std::numbers::pi - half_turn_rounding_rad;
  }
  bool is_whole() const { return is_whole_; }
  bool has(const glm::dvec2& way) const {
    if (is_whole_ || (way.x == 0.0 && way.y == 0.0)) return true;
    const double rounding = rounding_rad * (std::abs(way.x) + std::abs(way.y));
    const bool is_after = clockwise(from_, way) >= -rounding, is_before = clockwise(way, to_) >= -rounding;
    // The edges are within; the direction opposite to a narrow sector's middle is not.
    if (is_wide_) return is_after || is_before;
    return is_after && is_before && from_.x * way.x + from_.y * way.y + to_.x * way.x + to_.y * way.y >= 0.0;
  }

 private:
  glm::dvec2 from_, to_;
  bool is_whole_ = true, is_wide_ = false;
};

double ground_m(const PostGrid& grid, std::span<const float> heights_m, double x_m, double z_m) {
  const TerrainPosts posts{
      grid.columns,
      grid.rows,
      grid.spacing_x_m,
      grid.spacing_z_m,
      [&](int column, int row) {
        return heights_m[static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.columns) +
                         static_cast<std::size_t>(column)];
      },
      {}};
  return terrain_at(posts, x_m, z_m)->height_m;
}

}  // namespace

void require_valid(const SightLimits& limits) {
  const auto require = [](bool is_valid, const char* name, const char* expected, double found_rad) {
    if (is_valid) return;
    throw Error(ErrorKind::bad_input,
                fmt::format("viewshed: {}: expected {}, found {:g} degrees", name, expected,
                            found_rad * 180.0 / std::numbers::pi),
                "give azimuths clockwise from north, and a lowest angle below the highest one");
  };
  require(std::abs(limits.azimuth_from_rad) <= turn_rad + rounding_rad, "azimuth_from",
          "-360 ... 360 degrees", limits.azimuth_from_rad);
  require(std::abs(limits.azimuth_to_rad) <= turn_rad + rounding_rad, "azimuth_to", "-360 ... 360 degrees",
          limits.azimuth_to_rad);
  require(limits.lowest_rad >= -quarter_rad - rounding_rad && limits.lowest_rad <= quarter_rad, "lowest",
          "-90 ... 90 degrees", limits.lowest_rad);
  require(limits.highest_rad > limits.lowest_rad && limits.highest_rad <= quarter_rad + rounding_rad,
          "highest", "an angle above the lowest one, up to 90 degrees", limits.highest_rad);
}

void mark_outside(const PostGrid& grid, std::span<const float> heights_m,
                  const ViewshedParameters& parameters, const SightLimits& limits, std::uint8_t outside,
                  std::span<std::uint8_t> seen) {
  require_valid(parameters, grid);
  require_valid(limits);
  const Sector sector(limits);
  const bool has_lowest = limits.lowest_rad > -quarter_rad + rounding_rad,
             has_highest = limits.highest_rad < quarter_rad - rounding_rad;
  const bool has_heights = has_lowest || has_highest;
  const bool has_radius = std::isfinite(parameters.radius_m);
  if (sector.is_whole() && !has_heights && !has_radius) return;
  const double x_m = parameters.observer_x_m - grid.origin_x_m,
               z_m = parameters.observer_z_m - grid.origin_z_m;
  const double eye_m = ground_m(grid, heights_m, x_m, z_m) + parameters.observer_height_m;
  const double lowest = std::tan(limits.lowest_rad), highest = std::tan(limits.highest_rad);
  const double radius_squared = parameters.radius_m * parameters.radius_m,
               bend_perm = parameters.curve.bend_perm();
  const auto columns = static_cast<std::size_t>(grid.columns);
  const auto is_within = [&](double east_m, double south_m, float height_m, bool is_seen) {
    const double plan_squared = east_m * east_m + south_m * south_m;
    // The kernel rounds the radius: what it found visible is within.
    if (has_radius && plan_squared > radius_squared && !is_seen) return false;
    if (!sector.has({east_m, south_m})) return false;
    if (!has_heights) return true;
    const double rise_m =
        static_cast<double>(height_m) + parameters.target_height_m - eye_m - bend_perm * plan_squared;
    const double plan_m = std::sqrt(plan_squared);
    // Straight up and down is no multiple of the way in plan.
    return (!has_lowest || rise_m >= lowest * plan_m) && (!has_highest || rise_m <= highest * plan_m);
  };
  const bool has_only_radius = sector.is_whole() && !has_heights;
  for (int row = 0; row < grid.rows; ++row) {
    const double south_m = row * grid.spacing_z_m - z_m;
    const std::size_t begin = static_cast<std::size_t>(row) * columns;
    const std::span<std::uint8_t> of_row = seen.subspan(begin, columns);
    // Columns that may be within the radius: some more, so that no rounding matters.
    int first = 0, end = grid.columns;
    if (has_radius) {
      constexpr double spare = 2.0, rounding = 4e-7;
      const double reach =
          std::sqrt(std::max(radius_squared - south_m * south_m, 0.0) + rounding * radius_squared) /
              grid.spacing_x_m +
          spare;
      const double middle = x_m / grid.spacing_x_m, last = grid.columns;
      first = static_cast<int>(std::clamp(middle - reach, 0.0, last));
      end = static_cast<int>(std::clamp(middle + reach + 1.0, 0.0, last));
      std::ranges::fill(of_row.first(static_cast<std::size_t>(first)), outside);
      std::ranges::fill(of_row.subspan(static_cast<std::size_t>(end)), outside);
    }
    for (int column = first; column < end; ++column) {
      // Of a radius alone only the ends of its columns are in doubt.
      constexpr int in_doubt = 6;
      if (has_only_radius && column == first + in_doubt) column = std::max(column, end - in_doubt);
      if (column >= end) break;
      const auto post = static_cast<std::size_t>(column);
      if (!is_within(column * grid.spacing_x_m - x_m, south_m, heights_m[begin + post],
                     of_row[post] == SIGHT_VISIBLE))
        of_row[post] = outside;
    }
  }
}

}  // namespace offing::terrain

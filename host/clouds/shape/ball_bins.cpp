#include "host/clouds/shape/ball_bins.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <glm/common.hpp>

#include "host/base/error.h"

namespace offing::clouds {
namespace {

// 256 MiB of places of bricks; 8 GiB of cells; 1 GiB of pairs of brick and ball.
constexpr double most_bricks = 1 << 26;
constexpr std::size_t most_kept_bricks = std::size_t{1} << 22;
constexpr std::size_t most_pairs = std::size_t{1} << 28;

[[noreturn]] void refuse(const char* what, double found, double most, double cell_m) {
  throw Error(
      ErrorKind::bad_input,
      fmt::format("cloud: cell_m {:g} gives {:.4g} {}, expected at most {:.4g}", cell_m, found, what, most),
      fmt::format("take larger cells, such as {:.2g} m", cell_m * 1.1 * std::cbrt(found / most)));
}

/// Calls visit(brick) for the bricks of the grid in which a ball has density: those with the middle of a cell
/// inside it.
template <typename Visit>
void for_bricks(const BrickGrid& grid, const CloudBall& ball, const Visit& visit) {
  const double brick_m = grid.cell_m * CLOUD_BRICK_CELLS, rim_m = 0.5 * grid.cell_m;
  const std::array centre{static_cast<double>(ball.x), static_cast<double>(ball.y),
                          static_cast<double>(ball.z)};
  // A little more than the kernel can see, whose places are rounded.
  const double radius_m = static_cast<double>(ball.radius) * (1.0 + 1e-6);
  std::array<int, 3> first, last;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double most = grid.bricks[axis] - 1;
    first[axis] =
        static_cast<int>(std::clamp(std::floor((centre[axis] - radius_m) / brick_m), 0.0, most + 1.0));
    last[axis] = static_cast<int>(std::clamp(std::floor((centre[axis] + radius_m) / brick_m), -1.0, most));
  }
  const auto beyond = [&](int brick, std::size_t axis) {  // squared distance along an axis
    const double low = brick * brick_m + rim_m, high = (brick + 1) * brick_m - rim_m;
    const double distance = std::fmax(0.0, std::fmax(low - centre[axis], centre[axis] - high));
    return distance * distance;
  };
  for (int z = first[2]; z <= last[2]; ++z) {
    for (int y = first[1]; y <= last[1]; ++y) {
      const double across = beyond(z, 2) + beyond(y, 1);
      for (int x = first[0]; x <= last[0]; ++x) {
        if (across + beyond(x, 0) >= radius_m * radius_m) continue;
        visit((static_cast<std::size_t>(z) * static_cast<std::size_t>(grid.bricks[1]) +
               static_cast<std::size_t>(y)) *
                  static_cast<std::size_t>(grid.bricks[0]) +
              static_cast<std::size_t>(x));
      }
    }
  }
}

}  // namespace

std::size_t BrickGrid::brick_count() const {
  return static_cast<std::size_t>(bricks[0]) * static_cast<std::size_t>(bricks[1]) *
         static_cast<std::size_t>(bricks[2]);
}

BrickGrid grid_around(const glm::dvec3& low_m, const glm::dvec3& high_m, double cell_m) {
  const double brick_m = cell_m * CLOUD_BRICK_CELLS;
  const glm::dvec3 first = glm::floor(low_m / brick_m), past = glm::ceil(high_m / brick_m);
  const glm::dvec3 bricks = glm::max(past - first, glm::dvec3(1.0));
  const double count = bricks.x * bricks.y * bricks.z;
  if (!(count <= most_bricks)) refuse("bricks", count, most_bricks, cell_m);
  return {first * brick_m,
          cell_m,
          {static_cast<int>(bricks.x), static_cast<int>(bricks.y), static_cast<int>(bricks.z)}};
}

BallBins ball_bins(const BrickGrid& grid, std::span<const CloudBall> balls) {
  std::vector<std::uint32_t> counts(grid.brick_count(), 0);
  std::size_t pairs = 0;
  for (const CloudBall& ball : balls) {
    for_bricks(grid, ball, [&](std::size_t brick) {
      ++counts[brick];
      ++pairs;
    });
    if (pairs > most_pairs) {
      refuse("pairs of brick and ball", static_cast<double>(pairs), static_cast<double>(most_pairs),
             grid.cell_m);
    }
  }
  BallBins bins;
  bins.begin.push_back(0);
  for (std::size_t brick = 0; brick < counts.size(); ++brick) {
    if (counts[brick] == 0) continue;
    bins.brick_index.push_back(static_cast<std::uint32_t>(brick));
    bins.begin.push_back(bins.begin.back() + counts[brick]);
    counts[brick] = bins.begin[bins.begin.size() - 2];  // from now on: where its next ball goes
  }
  bins.balls.resize(pairs);
  for (std::size_t ball = 0; ball < balls.size(); ++ball) {
    for_bricks(grid, balls[ball],
               [&](std::size_t brick) { bins.balls[counts[brick]++] = static_cast<std::uint32_t>(ball); });
  }
  return bins;
}

void require_holdable(std::size_t bricks, double cell_m) {
  if (bricks <= most_kept_bricks) return;
  refuse("bricks with density", static_cast<double>(bricks), static_cast<double>(most_kept_bricks), cell_m);
}

}  // namespace offing::clouds

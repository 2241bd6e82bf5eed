#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/exponential.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "host/base/error.h"
#include "host/base/parallel_for.h"
#include "host/clouds/reference/scattering_medium.h"

namespace offing::clouds {

/// How many paths are traced, and how.
struct TraceOptions {
  int samples = 1024;  ///< paths of a ray, a pixel, a view or a light
  std::uint64_t seed = 1;
  int orders = 8;   ///< kept apart, 1 or more; the last has all further ones too
  int threads = 0;  ///< 0: as many as there are processors
};

/// A mean over paths.
struct Traced {
  /// [orders + 1] light scattered 0, 1, ... times; 0 is what sky and ground show through the cloud.
  std::vector<glm::dvec3> by_order;
  glm::dvec3 scattered{0.0};       ///< the sum from order 1 on
  glm::dvec3 standard_error{0.0};  ///< of `scattered`
};

// Paths of a block are summed in their order, and blocks in theirs: the sum does not depend on threads.
inline constexpr int paths_of_block = 256;
// Paths that carry less than this go on with a chance in proportion.
inline constexpr double least_sure_weight = 0.01;

inline void require_valid(const TraceOptions& options) {
  if (options.samples >= 1 && options.orders >= 1) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("trace: expected samples and orders of 1 or more, got {} and {}", options.samples,
                          options.orders));
}

/// `direction` turned by an angle of this cosine, and around by `around_rad`. Frame: Duff et al. 2017,
/// "Building an orthonormal basis, revisited".
inline glm::dvec3 turned(const glm::dvec3& direction, double cosine, double around_rad) {
  const double sign = std::copysign(1.0, direction.z), a = -1.0 / (sign + direction.z),
               b = direction.x * direction.y * a;
  const glm::dvec3 right(1.0 + sign * direction.x * direction.x * a, sign * b, -sign * direction.x),
      up(b, sign + direction.y * direction.y * a, -direction.y);
  const double sine = std::sqrt(std::max(0.0, 1.0 - cosine * cosine));
  return glm::normalize(sine * std::cos(around_rad) * right + sine * std::sin(around_rad) * up +
                        cosine * direction);
}

inline double greatest(const glm::dvec3& value) {
  return std::max({value.x, value.y, value.z});
}

/// Whether a path goes on; its weight grows by what the chance of that takes.
inline bool survives(glm::dvec3& weight, PathRandom& random) {
  const double most = greatest(weight);
  if (most >= least_sure_weight) return true;
  weight *= least_sure_weight / std::max(most, 1e-300);
  return random.next() * least_sure_weight < most;
}

/// Sums over paths: `make(path, by_order)` gives the light of one.
struct PathSums {
  std::vector<glm::dvec3> by_order, squares_by_order;
  glm::dvec3 scattered{0.0}, squares{0.0};

  explicit PathSums(std::size_t orders = 0) : by_order(orders), squares_by_order(orders) {}

  void add(const std::vector<glm::dvec3>& path) {
    glm::dvec3 sum(0.0);
    for (std::size_t order = 0; order < path.size(); ++order) {
      by_order[order] += path[order];
      squares_by_order[order] += path[order] * path[order];
      if (order > 0) sum += path[order];
    }
    scattered += sum;
    squares += sum * sum;
  }
  void add(const PathSums& other) {
    for (std::size_t order = 0; order < by_order.size(); ++order) {
      by_order[order] += other.by_order[order];
      squares_by_order[order] += other.squares_by_order[order];
    }
    scattered += other.scattered;
    squares += other.squares;
  }
};

/// The mean over all paths, times `scale`, and, where asked for, the mean squares [orders + 1] of unscaled
/// orders.
template <typename Make>
Traced mean_over_paths(const TraceOptions& options, double scale, const Make& make,
                       std::vector<glm::dvec3>* squares = nullptr) {
  require_valid(options);
  const auto orders = static_cast<std::size_t>(options.orders) + 1;
  const int blocks = (options.samples + paths_of_block - 1) / paths_of_block;
  std::vector<PathSums> sums(static_cast<std::size_t>(blocks));
  parallel_rows(
      blocks,
      [&](int block) {
        PathSums& sum = sums[static_cast<std::size_t>(block)];
        sum = PathSums(orders);
        std::vector<glm::dvec3> path(orders);
        const int end = std::min(options.samples, (block + 1) * paths_of_block);
        for (int i = block * paths_of_block; i < end; ++i) {
          std::fill(path.begin(), path.end(), glm::dvec3(0.0));
          PathRandom random(options.seed, static_cast<std::uint64_t>(i));
          make(random, path);
          sum.add(path);
        }
      },
      options.threads);
  PathSums all(orders);
  for (const PathSums& sum : sums) all.add(sum);
  const double count = options.samples;
  Traced traced;
  for (const glm::dvec3& order : all.by_order) traced.by_order.push_back(scale * order / count);
  if (squares != nullptr) {
    squares->clear();
    for (const glm::dvec3& sum : all.squares_by_order) squares->push_back(sum / count);
  }
  traced.scattered = scale * all.scattered / count;
  const glm::dvec3 mean = all.scattered / count;
  const glm::dvec3 variance = glm::max(all.squares / count - mean * mean, glm::dvec3(0.0));
  traced.standard_error = scale * glm::sqrt(variance / std::max(1.0, count - 1.0));
  return traced;
}

}  // namespace offing::clouds

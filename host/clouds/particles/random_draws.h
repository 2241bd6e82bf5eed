#pragma once

#include <cmath>
#include <cstdint>
#include <numbers>

#include <glm/vec3.hpp>

#include "kernels/shared/random.h"

namespace offing::clouds {

/// Random numbers one after the other: those of (seed, stream, n, m).
class RandomDraws {
 public:
  RandomDraws(std::uint64_t seed, std::uint32_t stream, int n, int m)
      : seed_(seed), stream_(stream), n_(n), m_(m) {}

  /// In (0, 1).
  double next() {
    if (index_ % 4 == 0) {
      block_ = philox_block(static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32),
                            stream_, n_, m_, index_ / 4);
    }
    return static_cast<double>(uniform_open01(block_.v[index_++ % 4]));
  }

  double between(double low, double high) { return low + (high - low) * next(); }

  /// Even on the unit sphere.
  glm::dvec3 direction() {
    const double y = between(-1.0, 1.0), angle = 2.0 * std::numbers::pi * next();
    const double across = std::sqrt(1.0 - y * y);
    return {across * std::cos(angle), y, across * std::sin(angle)};
  }

 private:
  std::uint64_t seed_;
  std::uint32_t stream_;
  int n_, m_;
  std::uint32_t index_ = 0;
  PhiloxBlock block_{};
};

}  // namespace offing::clouds

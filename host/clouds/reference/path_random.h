#pragma once

#include <cstdint>

#include "kernels/shared/random.h"

namespace offing::clouds {

/// The random numbers of one traced path: the same on any thread.
class PathRandom {
 public:
  PathRandom(std::uint64_t seed, std::uint64_t path) : seed_(seed), path_(path) {}

  /// Uniform in (0, 1), of 2^32 steps: paths draw logarithms of them, and 2^23 would end the longest at
  /// optical depth 16.
  double next() {
    if (used_ == 4) {
      block_ = philox_block(static_cast<std::uint32_t>(seed_), static_cast<std::uint32_t>(seed_ >> 32),
                            OFFING_STREAM_CLOUD_PATHS, static_cast<int>(path_ & 0xffffffffu),
                            static_cast<int>(path_ >> 32), index_++);
      used_ = 0;
    }
    return (static_cast<double>(block_.v[used_++]) + 0.5) / 4294967296.0;
  }

 private:
  std::uint64_t seed_, path_;
  std::uint32_t index_ = 0;
  int used_ = 4;
  PhiloxBlock block_{};
};

}  // namespace offing::clouds

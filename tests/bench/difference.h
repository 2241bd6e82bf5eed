// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <cmath>
#include <cstddef>
#include <string_view>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::bench {

/// Both results of a comparison must be the same, or it compares nothing: throws Error(device) unless the
/// largest difference of `count` values `stride` apart is below 1e-5 of their root mean square. Two correct
/// single-precision transforms of up to 4096 x 4096 differ by about 3e-6.
inline void require_equal(std::string_view what, const float* ours, const float* peer, std::size_t count,
                          std::size_t stride = 1) {
  constexpr double gate = 1e-5;
  double largest = 0.0, sum_of_squares = 0.0;
  bool is_finite = true;
  for (std::size_t i = 0; i < count * stride; i += stride) {
    const double difference = std::abs(static_cast<double>(ours[i]) - static_cast<double>(peer[i]));
    is_finite = is_finite && std::isfinite(difference);
    largest = std::max(largest, difference);
    sum_of_squares += static_cast<double>(peer[i]) * static_cast<double>(peer[i]);
  }
  const double rms = std::sqrt(sum_of_squares / static_cast<double>(count));
  if (is_finite && rms > 0.0 && largest <= gate * rms) return;
  throw Error(
      ErrorKind::device,
      fmt::format("{}: ours and the peer's differ by {:.3g} of their root mean square {:.3g}, expected "
                  "at most {:.0e}",
                  what, is_finite ? largest / rms : std::nan(""), rms, gate),
      "run the tests of this device: ctest -L quick");
}

}  // namespace offing::bench

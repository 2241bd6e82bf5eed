// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

namespace offing::bench {

/// Steps of rays, iterations of their walks (T11 of docs/sources.md).
struct StepStatistics {
  double mean = 0.0;
  int of_90 = 0, of_95 = 0, of_99 = 0;    ///< 90, 95 and 99 % of the rays take no more
  double within_16 = 0.0, over_80 = 0.0;  ///< shares of the rays
};

}  // namespace offing::bench

// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <cstddef>
#include <string_view>

#include <fftw3.h>

namespace offing::bench {

/// How FFTW spreads one plan over cores.
enum class Threading {
  one,     ///< not at all
  posix,   ///< FFTW's own threads, started at each loop
  openmp,  ///< FFTW's loops run by OpenMP's standing threads, the faster way for small transforms
};

std::string_view to_string(Threading threading);
/// Cores that this process may use.
int core_count();

/// An inverse two-dimensional transform of a batch by FFTW 3 in single precision, planned with FFTW_MEASURE.
class FftwPlan {
 public:
  struct Layout {
    int size = 0;   ///< n
    int batch = 1;  ///< transforms
    int pitch = 0;  ///< complex numbers from row to row, >= n
  };

  /// Planning overwrites both arrays, [batch][n][pitch] complex; `output` may be `input`. Throws
  /// Error(out_of_memory) if FFTW has no plan.
  FftwPlan(const Layout& layout, float* input, float* output, Threading threading);
  FftwPlan(FftwPlan&& other) noexcept;
  FftwPlan& operator=(FftwPlan&&) = delete;
  ~FftwPlan();

  /// On the arrays of the constructor.
  void execute() const;
  /// On other arrays, aligned alike; several threads at once may do so with a plan of one thread.
  void execute(float* input, float* output) const;

 private:
  fftwf_plan plan_;
  Threading threading_;
};

}  // namespace offing::bench

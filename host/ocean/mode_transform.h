#pragma once

#include <string_view>
#include <utility>

#include "host/fft/fft_plan.h"
#include "host/ocean/wave_modes.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"

namespace offing::ocean {

/// The two kernels that turn modes into fields: a caller's kernels joined to the passes of an inverse
/// transform, for all cascades at once. The first pass makes `half_fields` fields of the columns with kx >=
/// 0; the second makes `pair_fields` pairs of real fields from them (O10).
class ModeTransform {
 public:
  struct Request {
    std::string_view first_source, first_kernel;    ///< "ocean/spectrum_advance.cl", "spectrum_advance"
    std::string_view second_source, second_kernel;  ///< "ocean/surface_assemble.cl", "surface_assemble"
    int half_fields = 0;
    int pair_fields = 0;
  };

  ModeTransform(const ocl::Device& device, const WaveModes& modes, const Request& request);

  /// Enqueues the first pass with its own arguments, which come first.
  template <class... Args>
  void advance(const Args&... args) {
    first_.launch(first_shape_, args..., intermediate_, column_twiddles_, first_scratch_);
  }
  /// Enqueues the second pass with its own arguments, which come last.
  template <class... Args>
  void assemble(Args&&... args) {
    second_.launch(second_shape_, intermediate_, row_twiddles_, std::forward<Args>(args)...);
  }

 private:
  ocl::Kernel first_, second_;
  ocl::LaunchShape first_shape_, second_shape_;
  ocl::LocalMemory first_scratch_;
  ocl::Buffer<float> column_twiddles_, row_twiddles_;
  ocl::Buffer<float> intermediate_;  // [cascades][half_fields][n][2][pitch]
};

}  // namespace offing::ocean

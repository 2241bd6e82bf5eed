#pragma once

#include <vector>

#include "host/fft/fft_plan.h"
#include "host/ocl/buffer.h"
#include "host/ocl/device.h"
#include "host/ocl/kernel.h"
#include "kernels/shared/wake.h"

namespace offing::ocean {

/// The step of a wake window whose modes move each by itself: to modes, on by a step, and back, in the four
/// passes of two transforms (kernels/fft), so that a small window does not wait for launches.
class WakeStep {
 public:
  /// `turn` [n][n][2]: what each mode is multiplied by in a step, over n^2. Throws what Fft2d throws.
  WakeStep(const ocl::Device& device, int cells, const std::vector<float>& turn);

  /// Enqueues a step of `state` [n][n][2] under `displaced` [n][n] m; `kept` [2][n] as
  /// kernels/ocean/wakes/wake_settle_rows.cl says.
  void advance(const WakeGrid& grid, const ocl::Buffer<float>& displaced, const ocl::Buffer<float>& kept,
               ocl::Buffer<float>& state);

 private:
  WakeStep(const ocl::Device& device, const fft::FftPlan& plan, const std::vector<float>& turn);

  ocl::Kernel press_columns_, turn_rows_, inverse_columns_, settle_rows_;
  ocl::LaunchShape columns_shape_, rows_shape_;
  ocl::LocalMemory scratch_;
  ocl::Buffer<float> column_twiddles_, row_twiddles_, turn_, intermediate_, spectrum_;
};

}  // namespace offing::ocean

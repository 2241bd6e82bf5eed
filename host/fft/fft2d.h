#pragma once

#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"

namespace offing::fft {

/// Sign of the exponent. Neither direction scales: inverse(forward(x)) = n^2 x.
enum class Direction {
  forward,  ///< X(k) = sum x(j) e^(-2 pi i jk / n)
  inverse,  ///< x(j) = sum X(k) e^(+2 pi i jk / n), the sum of Lee & Lee 2007, eq. 1
};

/// Batched two-dimensional complex transforms of one size in single precision, n a power of two from 16 to
/// 4096. Arrays are interleaved complex: float [batch][n][n][2], row-major.
///
/// The root mean square error is within log2(n^2) u (1 + 4 sqrt 2), u = 2^-24, of the result (Higham 2002,
/// ch. 24); tests/fft/fft2d_test.cpp has the measured values. Sources: kernels/README.md.
class Fft2d {
 public:
  /// Throws Error(bad_input) if size is not a power of two in [16, 4096], batch < 1, or the size needs larger
  /// work-groups than the device allows (see fft_plan.h); Error(device) if the device computes wrong
  /// transforms (see sound_family.h).
  Fft2d(const ocl::Device& device, int size, int batch, Direction direction);

  /// The family of kernels that computes right transforms on this device (sound_family.h), for passes that
  /// callers join their own work to.
  static ocl::KernelShape family_for(const ocl::Device& device, int size, Direction direction);

  int size() const { return size_; }
  /// Floats that an input or output buffer must hold: batch * n * n * 2.
  std::size_t float_count() const;

  /// Enqueues the transform. `output` may be `input`. Throws Error(bad_input) if a buffer is too small.
  void transform(const ocl::Buffer<float>& input, ocl::Buffer<float>& output);

 private:
  Fft2d(const ocl::Device& device, int size, int batch, Direction direction, ocl::KernelShape family);

  int size_;
  int batch_;
  ocl::Kernel rows_;
  ocl::LaunchShape rows_shape_;
  ocl::Kernel columns_;
  ocl::LaunchShape columns_shape_;
  ocl::LocalMemory columns_scratch_;
  ocl::Buffer<float> row_twiddles_;
  ocl::Buffer<float> column_twiddles_;
  ocl::Buffer<float> intermediate_;
};

}  // namespace offing::fft

#pragma once

#include <string_view>
#include <utility>

#include "host/fft/fft_plan.h"
#include "host/ocean/surface/wave_modes.h"
#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"

namespace offing::ocean {

/// The two kernels that turn modes into fields: a caller's kernels joined to the passes of an inverse
/// transform, for all cascades at once. The first pass makes `half_fields` fields of the columns with kx >=
/// 0; the second makes `pair_fields` pairs of real fields from them (O10).
class ModeTransform {
 public:
  /// Samples along a side, and the columns with kx >= 0 that carry waves: as WaveModes says, if the transform
  /// has as many rows as the modes.
  struct Grid {
    int size, columns, cascade_count;
  };

  /// Which kernels, for how many fields.
  struct Request {
    std::string_view first_source, first_kernel;    ///< "ocean/spectrum_advance.cl", "spectrum_advance"
    std::string_view second_source, second_kernel;  ///< "ocean/surface_assemble.cl", "surface_assemble"
    int half_fields = 0;
    int pair_fields = 0;
    /// Of the modes, where they are not those of the transform: the kernels' MODE_ROWS, which come with
    /// MAP_FIELDS for half_fields.
    int mode_rows = 0;
    /// The relative error of a transform of one cascade against a reference on the host, such as
    /// surface_self_test(): what decides about the family of kernels (see host/fft/sound_family.h).
    double (*self_test)(const ocl::Device& device, ModeTransform& transform, const Grid& grid,
                        const Request& request) = nullptr;
  };

  /// Takes the family of kernels that suits the device best and passes the self-test. Throws Error(device) if
  /// none does.
  ModeTransform(const ocl::Device& device, const WaveModes& modes, const Request& request);
  /// The same for another grid than that of the modes.
  ModeTransform(const ocl::Device& device, const Grid& grid, const Request& request);
  /// Takes this family, untested.
  ModeTransform(const ocl::Device& device, const Grid& grid, const Request& request, ocl::KernelShape family);

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
  static ocl::KernelShape family_for(const ocl::Device& device, Grid grid, const Request& request);

  ocl::Kernel first_, second_;
  ocl::LaunchShape first_shape_, second_shape_;
  ocl::LocalMemory first_scratch_;
  ocl::Buffer<float> column_twiddles_, row_twiddles_;
  ocl::Buffer<float> intermediate_;  // [cascades][half_fields][n][2][pitch]
};

}  // namespace offing::ocean

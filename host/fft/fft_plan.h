#pragma once

#include <cstddef>
#include <vector>

#include "host/ocl/device_list.h"
#include "host/ocl/kernel.h"
#include "host/ocl/program.h"
#include "host/ocl/tuning.h"

namespace offing::fft {

/// How one pass is built and launched: what kernels/fft/rows.clh and columns.clh expect.
struct PassPlan {
  ocl::Defines defines;
  /// Table in the order that the kernel reads: see columns.clh, rows.clh and workgroup_stages.clh of
  /// kernels/fft.
  std::vector<float> twiddles;
  ocl::LaunchShape shape;         ///< for one transform
  std::size_t scratch_bytes = 0;  ///< __local memory of a work-group (columns only)
  int batch_dimension = 1;        ///< dimension of the global size that counts transforms

  /// The launch shape for `batch` transforms.
  ocl::LaunchShape shape_for(int batch) const;
};

/// What a caller joins to the two passes.
struct PlanRequest {
  int size = 0;     ///< n, a power of two, 16 ... 4096
  int columns = 0;  ///< columns that the first pass transforms: n, or n/2 when the rest follows by symmetry
  int result_fields = 1;  ///< complex fields that the second pass stores
};

/// The families of kernels that can do this transform on this device, the one that the tuning table names
/// first: simd, a strip of lanes a work-item, for CPUs; workgroup, a work-group a row or strip of columns,
/// for GPUs. The first needs sizes from 64 on and __local memory for a column. Where OFFING_SHAPE chooses a
/// family, the other one is there only if that one cannot do it.
///
/// Throws Error(bad_input) if the size is not a power of two in [16, 4096], or the device has neither memory
/// for the first nor work-groups of n / 8 work-items: 4096 needs 512, which a few GPUs do not allow.
std::vector<ocl::KernelShape> possible_families(const ocl::DeviceInfo& device, const PlanRequest& request);

/// The two passes of an n x n transform.
class FftPlan {
 public:
  /// `family` is one of possible_families().
  FftPlan(const ocl::DeviceInfo& device, const PlanRequest& request, ocl::KernelShape family);

  const PassPlan& columns() const { return columns_; }
  const PassPlan& rows() const { return rows_; }
  /// Floats of the intermediate array for one complex field: [n][2][pitch].
  std::size_t intermediate_floats() const { return intermediate_floats_; }

 private:
  PassPlan columns_;
  PassPlan rows_;
  std::size_t intermediate_floats_ = 0;
};

}  // namespace offing::fft

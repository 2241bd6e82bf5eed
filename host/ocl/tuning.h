#pragma once

#include <cstddef>
#include <string_view>

#include "host/ocl/device_list.h"
#include "host/ocl/kernel.h"

namespace offing::ocl {

/// How a kernel family spreads its work.
enum class KernelShape {
  simd,       ///< CPU: a work-item owns a strip of columns or rows and computes them side by side, in vectors
  workgroup,  ///< GPU: lanes are work-items, a work-group shares local memory
};

/// How kernels are built and launched on a device: what a row of the table in tuning.cpp holds.
struct KernelTuning {
  KernelShape shape = KernelShape::workgroup;
  int lanes = 1;  ///< values that a work-item computes side by side, in a vector; 1 in workgroup shape
  std::size_t group = 0;  ///< work-items of a work-group; 0 lets the driver choose
  int per_item = 1;       ///< pieces of work that a work-item does one by one; the table says which
  int digit_bits = 0;     ///< radix sort only: bits of the key that a pass sorts by
};

/// Lanes of the widest vector in OpenCL, a float16. Arrays are padded to it, so that any `lanes` can read
/// them.
inline constexpr int widest_lanes = 16;

/// The tuning of these kernels on this device: the table's row for its class, else the default row. No group
/// is larger than the device allows. For tests, OFFING_SHAPE=simd or workgroup chooses a row of that shape
/// instead, where there is one. Its earlier values strip and group still work and warn once. Throws
/// Error(bad_usage) for any other value, and if the table has no row named `kernels`.
KernelTuning tuning_for(const DeviceInfo& device, std::string_view kernels);

/// The same for kernels of this shape, whatever OFFING_SHAPE says.
KernelTuning tuning_for(const DeviceInfo& device, std::string_view kernels, KernelShape shape);

/// Work-items for `count` values in each of `rows`; each computes `lanes` times `per_item` values. They fill
/// whole groups, so kernels must skip values beyond `count`.
LaunchShape launch_shape(const KernelTuning& tuning, std::size_t count, std::size_t rows = 1);

/// Whether OFFING_SHAPE chooses the shape of all kernels.
bool shape_is_forced();

}  // namespace offing::ocl

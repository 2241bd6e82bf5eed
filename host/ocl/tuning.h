#pragma once

#include <string_view>

#include "host/ocl/device.h"

namespace offing::ocl {

/// How a kernel family spreads its work.
enum class KernelShape {
  simd,       ///< CPU: a work-item owns a strip of columns or rows and computes them side by side, in vectors
  workgroup,  ///< GPU: lanes are work-items, a work-group shares local memory
};

struct KernelTuning {
  KernelShape shape = KernelShape::workgroup;
};

/// What suits the kernels of `family` ("fft": the transforms and all that joins them; "gerstner": sums of
/// Gerstner waves; "terrain": rays; "highlights": their search; "clouds": order, light and pictures of
/// particles) on this device: a row of the table in tuning.cpp, else its default row. OFFING_SHAPE=simd or
/// workgroup overrides the shape, for tests; its earlier values strip and group still work and warn once. Any
/// other value throws Error(bad_usage).
KernelTuning tuning_for(const DeviceInfo& device, std::string_view family);

/// Whether OFFING_SHAPE chooses the shape of all kernels.
bool shape_is_forced();

}  // namespace offing::ocl

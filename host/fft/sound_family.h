#pragma once

#include <functional>
#include <vector>

#include "host/fft/fft_plan.h"
#include "host/ocl/self_test.h"

namespace offing::fft {

/// What a self-test needs to know about a transform, in one family or the other.
struct FamilyTest {
  /// The programs of both passes.
  std::function<std::vector<ocl::ProgramRecipe>(ocl::KernelShape family)> programs;
  /// The relative root mean square error of one transform against a reference on the host.
  std::function<double(ocl::KernelShape family)> error_of;
};

/// The first of possible_families() whose self-test passes: its error is below 1e-4. Rounding gives some
/// 1e-7 (measured 1e-7 ... 3e-7); a wrong twiddle, order or sign gives 1e-3 and more. The test runs once for
/// each device, driver and build of the kernels (see ocl::passes_self_test). A family that fails is reported.
///
/// Throws Error(device) if no family passes, and what possible_families() throws. Programs outside
/// kernels/fft that OFFING_KERNEL_PATH changes may compute something else: with them the first family is
/// taken untested.
ocl::KernelShape sound_family(const ocl::Device& device, const PlanRequest& request, const FamilyTest& test);

}  // namespace offing::fft

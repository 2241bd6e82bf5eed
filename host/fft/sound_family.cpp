#include "host/fft/sound_family.h"

#include <algorithm>
#include <mutex>
#include <set>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/ocl/program_source.h"

namespace offing::fft {
namespace {

constexpr double largest_error = 1e-4;

std::string_view name_of(ocl::KernelShape family) {
  return family == ocl::KernelShape::simd ? "simd" : "workgroup";
}

// A sea has several transforms, and is made anew while it is edited.
void warn_once(const std::string& message) {
  static std::mutex mutex;
  static std::set<std::string> messages;
  const std::lock_guard lock(mutex);
  if (messages.insert(message).second) spdlog::warn("{}", message);
}

bool is_changed_outside_fft(const ocl::ProgramRecipe& program) {
  const std::vector<std::string> files = ocl::replaced_files(program.source_name);
  return std::any_of(files.begin(), files.end(), [](const auto& name) { return !name.starts_with("fft/"); });
}

}  // namespace

ocl::KernelShape sound_family(const ocl::Device& device, const PlanRequest& request, const FamilyTest& test) {
  const ocl::DeviceInfo& info = device.info();
  const std::vector<ocl::KernelShape> families = possible_families(info, request);
  std::string failed;
  for (const ocl::KernelShape family : families) {
    const std::vector<ocl::ProgramRecipe> programs = test.programs(family);
    if (std::any_of(programs.begin(), programs.end(), is_changed_outside_fft)) return family;
    const bool is_sound = ocl::passes_self_test(device, programs, [&] {
      const double error = test.error_of(family);
      spdlog::debug("{}: {} transform of size {}: relative error {:.1e}", info.name, name_of(family),
                    request.size, error);
      return error < largest_error;  // false for NaN
    });
    if (is_sound) {
      if (!failed.empty()) {
        warn_once(
            fmt::format("{} (driver {}) computes {} transforms of size {} wrongly: using {} transforms, "
                        "which may be slower; a newer driver may help",
                        info.name, info.driver_version, failed, request.size, name_of(family)));
      }
      return family;
    }
    failed += (failed.empty() ? "" : " and ") + std::string(name_of(family));
  }
  throw Error(
      ErrorKind::device,
      fmt::format("{} ({}, driver {}): {} transforms of size {}: expected a relative error below {:.0e}, "
                  "the self-test found more",
                  info.name, info.platform, info.driver_version, failed, request.size, largest_error),
      "update the device's OpenCL driver, or choose another --device: offing devices lists them");
}

}  // namespace offing::fft

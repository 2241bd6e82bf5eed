#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "host/ocl/device.h"
#include "host/ocl/program.h"

namespace offing::ocl {

/// A program by what it is built from.
struct ProgramRecipe {
  std::string_view source_name;  ///< "fft/transform_rows.cl"
  Defines defines;
};

/// All that shapes what programs compute on a device: their text and options, the device and its driver.
std::string identity_of(const DeviceInfo& info, std::span<const ProgramRecipe> programs);

/// Whether these programs compute on this device what they should. `test` says so; it runs once for each
/// device, driver version and text of the programs. Its result is kept beside the compiled programs (see
/// DiskCache), and in memory for this process.
bool passes_self_test(const Device& device, std::span<const ProgramRecipe> programs,
                      const std::function<bool()>& test);

}  // namespace offing::ocl

#pragma once

#include <string_view>
#include <vector>

#include "host/ocl/device_list.h"

namespace offing::cli {

/// The device that `selector` (--device), or OFFING_DEVICE where that is empty, names for a command that uses
/// one. Throws Error(bad_usage) if it is "all", else as ocl::select_device().
ocl::DeviceInfo choose_one_device(std::string_view selector);

/// The same for a command that shares its work: "all" gives every device.
std::vector<ocl::DeviceInfo> choose_devices(std::string_view selector);

}  // namespace offing::cli

#pragma once

#include <string_view>
#include <vector>

#include "host/ocl/device.h"

namespace offing::ocl {

/// The one of `devices` (not empty) that `selector` means, by the rules of select_device() but without the
/// environment. Throws Error(no_device) that names the selector and lists the candidates.
const DeviceInfo& choose_device(const std::vector<DeviceInfo>& devices, std::string_view selector);

}  // namespace offing::ocl

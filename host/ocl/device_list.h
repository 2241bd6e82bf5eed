#pragma once

#include <vector>

#include "host/ocl/device.h"
#include "host/ocl/opencl.h"

namespace offing::ocl {

/// A device as the driver knows it, beside what it reports.
struct ListedDevice {
  cl_device_id id = nullptr;
  DeviceInfo info;
};

/// What list_devices() lists, with the driver's ids. Devices without a compiler or not available are left
/// out. Throws Error(no_device) when there is no platform or no device.
std::vector<ListedDevice> enumerate_devices();

}  // namespace offing::ocl

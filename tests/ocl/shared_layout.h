#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "host/ocl/device.h"

namespace offing::test {

/// How the device lays out a struct of kernels/shared: its size, then the offset of each of `members`, in
/// bytes. `header` is its path below kernels/, such as "shared/random.h". Compare it to the host's sizeof and
/// offsetof.
std::vector<std::size_t> device_layout(const ocl::Device& device, const std::string& header,
                                       const std::string& type, const std::vector<std::string>& members);

}  // namespace offing::test

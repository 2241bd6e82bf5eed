#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "host/ocl/device_state.h"
#include "host/ocl/kernel.h"
#include "host/ocl/kernel_argument.h"

namespace offing::ocl {

/// What the copies of a Kernel share. The argument list is read once, so that a launch asks the driver
/// nothing.
struct Kernel::State {
  State(std::shared_ptr<detail::DeviceState> on_device, Handle<cl_kernel> of_kernel, std::string of_name)
      : device(std::move(on_device)),
        kernel(std::move(of_kernel)),
        name(std::move(of_name)),
        arguments(kernel_arguments(kernel.get())) {}

  std::shared_ptr<detail::DeviceState> device;
  Handle<cl_kernel> kernel;
  std::string name;
  std::vector<KernelArgument> arguments;
};

}  // namespace offing::ocl

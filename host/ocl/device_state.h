#pragma once

#include "host/ocl/device.h"
#include "host/ocl/opencl.h"

namespace offing::ocl::detail {

/// What the copies of a Device, and all objects made from it, share.
struct DeviceState {
  DeviceInfo info;
  cl_device_id id = nullptr;
  Handle<cl_context> context;
  Handle<cl_command_queue> queue;
  bool is_profiling = false;
  bool shares_gl = false;

  ~DeviceState() {
    // A driver may otherwise run commands while its objects go.
    if (queue) clFinish(queue.get());
  }
};

}  // namespace offing::ocl::detail

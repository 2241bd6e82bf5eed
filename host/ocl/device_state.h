#pragma once

#include <map>
#include <mutex>
#include <string>
#include <utility>

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
  /// A program and all that it was built from.
  struct BuiltProgram {
    std::string identity;
    Handle<cl_program> program;
  };
  /// The last one built of each source and its options: a simulation that is made anew while it is shown does
  /// not wait for the driver, nor for other processes' turns to build. What was built before an edit of the
  /// source lives no longer than its users.
  std::map<std::pair<std::string, std::string>, BuiltProgram> programs;
  std::mutex programs_mutex;  ///< for `programs`: threads may share a device

  ~DeviceState() {
    // A driver may otherwise run commands while its objects go.
    if (queue) clFinish(queue.get());
  }
};

}  // namespace offing::ocl::detail

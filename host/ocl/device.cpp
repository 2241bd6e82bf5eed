#include "host/ocl/device.h"

#include <utility>
#include <vector>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/ocl/device_state.h"
#include "host/ocl/opencl.h"
#include "host/ocl/status.h"

namespace offing::ocl {
namespace {

// A context that shares with OpenGL, or nothing where the driver refuses.
Handle<cl_context> shared_context(cl_device_id device, std::span<const std::intptr_t> share_properties) {
  cl_platform_id platform = nullptr;
  check(clGetDeviceInfo(device, CL_DEVICE_PLATFORM, sizeof platform, &platform, nullptr), "clGetDeviceInfo",
        "platform");
  std::vector<cl_context_properties> properties{CL_CONTEXT_PLATFORM,
                                                reinterpret_cast<cl_context_properties>(platform)};
  properties.insert(properties.end(), share_properties.begin(), share_properties.end());
  properties.push_back(0);
  int status = CL_SUCCESS;
  Handle<cl_context> context(clCreateContext(properties.data(), 1, &device, nullptr, nullptr, &status));
  if (status != CL_SUCCESS) spdlog::debug("no context shared with OpenGL: {}", status_name(status));
  return context;
}

}  // namespace

Device::Device(std::shared_ptr<detail::DeviceState> state) : state_(std::move(state)) {}

Device Device::open(std::string_view selector, Profiling profiling) {
  return open(select_device(selector), profiling);
}

Device Device::open(const DeviceInfo& info, Profiling profiling) {
  return open_shared(info, profiling, {});
}

Device Device::open_shared(const DeviceInfo& info, Profiling profiling,
                           std::span<const std::intptr_t> share_properties) {
  auto state = std::make_shared<detail::DeviceState>();
  state->info = info;
  state->id = id_of(info);
  state->is_profiling = profiling == Profiling::on;
  if (info.has_gl_sharing && !share_properties.empty()) {
    state->context = shared_context(state->id, share_properties);
    state->shares_gl = state->context != nullptr;
  }
  int status = CL_SUCCESS;
  if (!state->context) {
    state->context.reset(clCreateContext(nullptr, 1, &state->id, nullptr, nullptr, &status));
    check(status, "clCreateContext", info.name);
  }
  const cl_command_queue_properties properties = state->is_profiling ? CL_QUEUE_PROFILING_ENABLE : 0;
  state->queue.reset(clCreateCommandQueue(state->context.get(), state->id, properties, &status));
  check(status, "clCreateCommandQueue", info.name);
  spdlog::debug("device {}: {} ({}, {}, driver {})", info.index, info.name, info.platform,
                info.device_version, info.driver_version);
  return Device(std::move(state));
}

Device Device::adopt(cl_context context, cl_command_queue queue) {
  const auto value_of = [queue](cl_command_queue_info name, auto value) {
    check(clGetCommandQueueInfo(queue, name, sizeof value, &value, nullptr), "clGetCommandQueueInfo",
          "the caller's queue");
    return value;
  };
  if (value_of(CL_QUEUE_CONTEXT, cl_context{}) != context) {
    throw Error(ErrorKind::bad_usage, "queue: expected one of the context, got one of another",
                "pass a context and a command queue that was made for it");
  }
  const auto properties = value_of(CL_QUEUE_PROPERTIES, cl_command_queue_properties{});
  if ((properties & CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE) != 0) {
    throw Error(ErrorKind::bad_usage,
                "queue: expected one that runs commands in order, got one that does not",
                "make a queue without CL_QUEUE_OUT_OF_ORDER_EXEC_MODE_ENABLE");
  }
  auto state = std::make_shared<detail::DeviceState>();
  state->id = value_of(CL_QUEUE_DEVICE, cl_device_id{});
  state->info = info_of(state->id);
  state->is_profiling = (properties & CL_QUEUE_PROFILING_ENABLE) != 0;
  check(clRetainContext(context), "clRetainContext", state->info.name);
  state->context.reset(context);
  check(clRetainCommandQueue(queue), "clRetainCommandQueue", state->info.name);
  state->queue.reset(queue);
  return Device(std::move(state));
}

const DeviceInfo& Device::info() const {
  return state_->info;
}

void Device::flush() const {
  check(clFlush(queue()), "clFlush", info().name);
}

Event Device::mark() const {
  cl_event event = nullptr;
  check(clEnqueueMarkerWithWaitList(queue(), 0, nullptr, &event), "clEnqueueMarkerWithWaitList", info().name);
  return Event(event);
}

void Device::finish() const {
  check(clFinish(queue()), "clFinish", info().name);
}

cl_device_id Device::id() const {
  return state_->id;
}

cl_context Device::context() const {
  return state_->context.get();
}

cl_command_queue Device::queue() const {
  return state_->queue.get();
}

bool Device::is_profiling() const {
  return state_->is_profiling;
}

bool Device::shares_gl() const {
  return state_->shares_gl;
}

}  // namespace offing::ocl

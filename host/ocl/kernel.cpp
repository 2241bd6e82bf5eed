#include "host/ocl/kernel.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/ocl/kernel_state.h"
#include "host/ocl/opencl.h"
#include "host/ocl/status.h"

namespace offing::ocl {
namespace {

using Kind = KernelArgument::Kind;

constexpr const char* argument_hint = "the host call and the kernel's parameter list differ: make them agree";

const char* expectation(Kind kind) {
  switch (kind) {
    case Kind::memory:
      return "a Buffer";
    case Kind::local:
      return "LocalMemory";
    default:
      return "a value";
  }
}

std::string place(const std::string& kernel, int index, const KernelArgument& argument) {
  return fmt::format("kernel {}, argument {} ({} {})", kernel, index, argument.type, argument.name);
}

void check_kind(const std::string& kernel, int index, const KernelArgument& argument, Kind given) {
  if (argument.kind == given || argument.kind == Kind::unknown) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("{}: expected {}, got {}", place(kernel, index, argument),
                          expectation(argument.kind), expectation(given)),
              argument_hint);
}

void set(cl_kernel kernel, const std::string& name, int index, const KernelArgument& argument,
         std::size_t bytes, const void* value) {
  const int status = clSetKernelArg(kernel, static_cast<cl_uint>(index), bytes, value);
  if (status == CL_SUCCESS) return;
  if (status == CL_INVALID_ARG_SIZE) {
    throw Error(
        ErrorKind::bad_usage,
        fmt::format("{}: {} bytes are not the size of the parameter", place(name, index, argument), bytes),
        argument_hint);
  }
  throw_status(status, "clSetKernelArg", place(name, index, argument));
}

}  // namespace

const std::string& Kernel::name() const {
  return state_->name;
}

void Kernel::begin_launch(std::size_t argument_count) const {
  if (argument_count == state_->arguments.size()) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("kernel {}: expected {} arguments, got {}", state_->name, state_->arguments.size(),
                          argument_count),
              argument_hint);
}

void Kernel::set_argument(int index, const LocalMemory& local) const {
  const KernelArgument& argument = state_->arguments[static_cast<std::size_t>(index)];
  check_kind(state_->name, index, argument, Kind::local);
  if (local.bytes == 0 || local.bytes > state_->device->info.local_memory_bytes) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: {} bytes of local memory: expected 1 to {} on {}",
                            place(state_->name, index, argument), local.bytes,
                            state_->device->info.local_memory_bytes, state_->device->info.name),
                "use a smaller --size, or choose another --device");
  }
  set(state_->kernel.get(), state_->name, index, argument, local.bytes, nullptr);
}

void Kernel::set_memory(int index, cl_mem memory) const {
  const KernelArgument& argument = state_->arguments[static_cast<std::size_t>(index)];
  check_kind(state_->name, index, argument, Kind::memory);
  if (memory == nullptr) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: the buffer was never allocated", place(state_->name, index, argument)),
                "give each Buffer a device and a size before the launch");
  }
  set(state_->kernel.get(), state_->name, index, argument, sizeof(cl_mem), &memory);
}

void Kernel::set_value(int index, std::size_t bytes, const void* value, ValueKind kind) const {
  const KernelArgument& argument = state_->arguments[static_cast<std::size_t>(index)];
  check_kind(state_->name, index, argument, Kind::value);
  const bool fits_size = argument.bytes == 0 || argument.bytes == bytes;
  const bool is_mixed = (argument.number == KernelArgument::Number::floating && kind == ValueKind::integer) ||
                        (argument.number == KernelArgument::Number::integer && kind == ValueKind::floating);
  if (!fits_size || is_mixed) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected {} bytes, got {} bytes{}", place(state_->name, index, argument),
                            argument.bytes, bytes, is_mixed ? " of the other kind of number" : ""),
                argument_hint);
  }
  set(state_->kernel.get(), state_->name, index, argument, bytes, value);
}

Event Kernel::enqueue(const LaunchShape& shape) const {
  if (shape.global[0] == 0) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("kernel {}: expected a global size of 1 or more, got 0", state_->name),
                "skip the launch when there is nothing to do");
  }
  cl_uint dimensions = 3;
  while (dimensions > 1 && shape.global[dimensions - 1] <= 1) --dimensions;
  std::array<std::size_t, 3> global = shape.global;
  std::array<std::size_t, 3> local = shape.local;
  for (std::size_t i = 1; i < 3; ++i) {
    global[i] = std::max<std::size_t>(global[i], 1);
    local[i] = std::max<std::size_t>(local[i], 1);
  }
  const bool driver_chooses = local[0] == 0;
  cl_event event = nullptr;
  const int status = clEnqueueNDRangeKernel(state_->device->queue.get(), state_->kernel.get(), dimensions,
                                            nullptr, global.data(), driver_chooses ? nullptr : local.data(),
                                            0, nullptr, state_->device->is_profiling ? &event : nullptr);
  if (status != CL_SUCCESS) {
    throw_status(status, "clEnqueueNDRangeKernel",
                 fmt::format("kernel {} with global size ({}) and local size ({}) on {}", state_->name,
                             fmt::join(global, ", "),
                             driver_chooses ? "any" : fmt::format("{}", fmt::join(local, ", ")),
                             state_->device->info.name));
  }
  return Event(event);
}

}  // namespace offing::ocl

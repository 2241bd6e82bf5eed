#include "host/ocl/kernel.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"
#include "host/ocl/device_state.h"
#include "host/ocl/opencl.h"
#include "host/ocl/quirks.h"
#include "host/ocl/status.h"

namespace offing::ocl {
namespace {

/// One parameter of a kernel as its source declares it.
struct KernelArgument {
  enum class Kind { memory, local, value, unknown };
  enum class Number { integer, floating, unknown };

  Kind kind = Kind::unknown;  ///< unknown: the driver does not say, and checks alone
  std::string name;
  std::string type;                 ///< as the driver spells it, "float*"
  std::size_t bytes = 0;            ///< of a value; 0 for structs, whose size only the driver knows
  Number number = Number::unknown;  ///< of a scalar value
};

struct ScalarType {
  std::string_view name;
  std::size_t bytes;
  KernelArgument::Number number;
};

// OpenCL C 1.2, table 6.1, and the long spellings that some drivers report.
constexpr auto integer = KernelArgument::Number::integer;
constexpr auto floating = KernelArgument::Number::floating;
constexpr std::array scalar_types{
    ScalarType{"char", 1, integer},          ScalarType{"uchar", 1, integer},
    ScalarType{"unsigned char", 1, integer}, ScalarType{"short", 2, integer},
    ScalarType{"ushort", 2, integer},        ScalarType{"unsigned short", 2, integer},
    ScalarType{"int", 4, integer},           ScalarType{"uint", 4, integer},
    ScalarType{"unsigned int", 4, integer},  ScalarType{"long", 8, integer},
    ScalarType{"ulong", 8, integer},         ScalarType{"unsigned long", 8, integer},
    ScalarType{"half", 2, floating},         ScalarType{"float", 4, floating},
    ScalarType{"double", 8, floating},
};

const ScalarType* scalar_type(std::string_view name) {
  for (const ScalarType& type : scalar_types) {
    if (type.name == name) return &type;
  }
  return nullptr;
}

/// Size of an OpenCL C scalar or vector type ("float4" is 16, "uint3" 16); 0 for any other type.
std::size_t value_bytes(const std::string& type) {
  if (const ScalarType* scalar = scalar_type(type)) return scalar->bytes;
  const std::size_t digits = type.find_first_of("0123456789");
  if (digits == std::string::npos) return 0;
  const ScalarType* element = scalar_type(std::string_view(type).substr(0, digits));
  const std::string_view lanes = std::string_view(type).substr(digits);
  if (element == nullptr) return 0;
  if (lanes == "2") return 2 * element->bytes;
  if (lanes == "3" || lanes == "4") return 4 * element->bytes;  // a vector of 3 is stored as one of 4
  if (lanes == "8") return 8 * element->bytes;
  if (lanes == "16") return 16 * element->bytes;
  return 0;
}

std::string argument_text(cl_kernel kernel, cl_uint index, cl_kernel_arg_info what) {
  std::size_t bytes = 0;
  if (clGetKernelArgInfo(kernel, index, what, 0, nullptr, &bytes) != CL_SUCCESS || bytes == 0) return {};
  std::string text(bytes, '\0');
  if (clGetKernelArgInfo(kernel, index, what, bytes, text.data(), nullptr) != CL_SUCCESS) return {};
  return text.substr(0, text.find('\0'));
}

KernelArgument kernel_argument(cl_kernel kernel, cl_uint index) {
  KernelArgument argument;
  cl_kernel_arg_address_qualifier address = 0;
  if (clGetKernelArgInfo(kernel, index, CL_KERNEL_ARG_ADDRESS_QUALIFIER, sizeof address, &address, nullptr) !=
      CL_SUCCESS) {
    return argument;
  }
  argument.name = argument_text(kernel, index, CL_KERNEL_ARG_NAME);
  argument.type = argument_text(kernel, index, CL_KERNEL_ARG_TYPE_NAME);
  switch (address) {
    case CL_KERNEL_ARG_ADDRESS_GLOBAL:
    case CL_KERNEL_ARG_ADDRESS_CONSTANT:
      argument.kind = KernelArgument::Kind::memory;
      break;
    case CL_KERNEL_ARG_ADDRESS_LOCAL:
      argument.kind = KernelArgument::Kind::local;
      break;
    default:
      argument.kind = KernelArgument::Kind::value;
      argument.bytes = value_bytes(argument.type);
      if (const ScalarType* scalar = scalar_type(argument.type)) argument.number = scalar->number;
  }
  return argument;
}

/// The parameters of `kernel`, in order. Drivers that built the program from a binary may not know them: then
/// all are of kind unknown.
std::vector<KernelArgument> kernel_arguments(cl_kernel kernel) {
  cl_uint count = 0;
  check(clGetKernelInfo(kernel, CL_KERNEL_NUM_ARGS, sizeof count, &count, nullptr), "clGetKernelInfo",
        "a kernel");
  std::vector<KernelArgument> arguments;
  for (cl_uint index = 0; index < count; ++index) arguments.push_back(kernel_argument(kernel, index));
  return arguments;
}

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

Kernel::Kernel(std::shared_ptr<detail::DeviceState> device, cl_kernel kernel, std::string name)
    : state_(std::make_shared<State>(std::move(device), Handle<cl_kernel>(kernel), std::move(name))) {}

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
  const std::size_t group = shape.local[0] == 0 ? quirks::usual_group_size(state_->device->info) : 0;
  if (group == 0) return Event(enqueue_part(0, shape));
  const auto [columns, rows, layers] = shape.global;
  const std::size_t whole =
      columns / group * group;  // the columns that fill groups; the rest have groups of one
  Handle<cl_event> first, last;
  if (whole > 0) first.reset(enqueue_part(0, {{whole, rows, layers}, {group}}));
  if (whole < columns) last.reset(enqueue_part(whole, {{columns - whole, rows, layers}, {1}}));
  return last ? Event(last.release(), first.release()) : Event(first.release());
}

cl_event Kernel::enqueue_part(std::size_t first_column, const LaunchShape& shape) const {
  cl_uint dimensions = 3;
  while (dimensions > 1 && shape.global[dimensions - 1] <= 1) --dimensions;
  const std::array<std::size_t, 3> offset{first_column, 0, 0};
  std::array<std::size_t, 3> global = shape.global;
  std::array<std::size_t, 3> local = shape.local;
  for (std::size_t i = 1; i < 3; ++i) {
    global[i] = std::max<std::size_t>(global[i], 1);
    local[i] = std::max<std::size_t>(local[i], 1);
  }
  const bool driver_chooses = local[0] == 0;
  cl_event event = nullptr;
  const int status = clEnqueueNDRangeKernel(
      state_->device->queue.get(), state_->kernel.get(), dimensions, offset.data(), global.data(),
      driver_chooses ? nullptr : local.data(), 0, nullptr, state_->device->is_profiling ? &event : nullptr);
  if (status != CL_SUCCESS) {
    throw_status(status, "clEnqueueNDRangeKernel",
                 fmt::format("kernel {} with global size ({}) and local size ({}) on {}", state_->name,
                             fmt::join(global, ", "),
                             driver_chooses ? "any" : fmt::format("{}", fmt::join(local, ", ")),
                             state_->device->info.name));
  }
  return event;
}

}  // namespace offing::ocl

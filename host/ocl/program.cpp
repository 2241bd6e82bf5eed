#include "host/ocl/program.h"

#include <cstdint>
#include <sstream>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/ocl/device_state.h"
#include "host/ocl/disk_cache.h"
#include "host/ocl/opencl.h"
#include "host/ocl/program_source.h"
#include "host/ocl/quirks.h"
#include "host/ocl/status.h"

namespace offing::ocl {
namespace {

using Binary = std::vector<std::uint8_t>;

// Denormals are flushed because the tails of a spectrum are full of them and cost a factor 2; fused
// multiply-adds are allowed, and simplifications such as x * 0 + y = y, which lose the sign of a zero that
// nothing here looks at. Argument info is what Kernel checks its arguments against.
constexpr const char* base_options =
    "-cl-std=CL1.2 -cl-denorms-are-zero -cl-mad-enable -cl-no-signed-zeros -cl-kernel-arg-info";

std::string options_of(const DeviceInfo& info, const Defines& defines) {
  std::string options = base_options + quirks::build_options(info);
  for (const auto& [name, value] : defines.values()) options += fmt::format(" -D{}={}", name, value);
  return options;
}

// Everything that shapes the binary.
std::string identity_of(const DeviceInfo& info, const std::string& source, const std::string& options) {
  return joined_identity({source, options}) + driver_identity(info);
}

std::string build_log(cl_program program, cl_device_id device) {
  std::size_t bytes = 0;
  if (clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, 0, nullptr, &bytes) != CL_SUCCESS)
    return {};
  std::string log(bytes, '\0');
  if (clGetProgramBuildInfo(program, device, CL_PROGRAM_BUILD_LOG, bytes, log.data(), nullptr) != CL_SUCCESS)
    return {};
  while (!log.empty() && (log.back() == '\0' || log.back() == '\n' || log.back() == ' ')) log.pop_back();
  return log;
}

// The line that a user needs: the first that says error, else the first that says anything.
std::string first_error(const std::string& log) {
  std::istringstream lines(log);
  std::string first;
  for (std::string line; std::getline(lines, line);) {
    if (line.find("error") != std::string::npos) return line;
    if (first.empty()) first = line;
  }
  return first.empty() ? "the compiler gives no reason" : first;
}

Binary binary_of(cl_program program) {
  std::size_t bytes = 0;
  if (clGetProgramInfo(program, CL_PROGRAM_BINARY_SIZES, sizeof bytes, &bytes, nullptr) != CL_SUCCESS)
    return {};
  Binary binary(bytes);
  unsigned char* pointers[1] = {binary.data()};
  if (bytes == 0 ||
      clGetProgramInfo(program, CL_PROGRAM_BINARIES, sizeof pointers, pointers, nullptr) != CL_SUCCESS) {
    return {};
  }
  return binary;
}

// Null if the driver does not take the binary, as after an update that kept its version number.
Handle<cl_program> load_binary(const detail::DeviceState& device, const Binary& binary,
                               const std::string& options) {
  const unsigned char* data = binary.data();
  const std::size_t bytes = binary.size();
  int status = CL_SUCCESS;
  cl_int binary_status = CL_SUCCESS;
  Handle<cl_program> program(
      clCreateProgramWithBinary(device.context.get(), 1, &device.id, &bytes, &data, &binary_status, &status));
  if (status != CL_SUCCESS || binary_status != CL_SUCCESS) return nullptr;
  if (clBuildProgram(program.get(), 1, &device.id, options.c_str(), nullptr, nullptr) != CL_SUCCESS)
    return nullptr;
  return program;
}

Handle<cl_program> compile(const detail::DeviceState& device, std::string_view source_name,
                           const std::string& source, const std::string& options) {
  const char* text = source.c_str();
  const std::size_t bytes = source.size();
  int status = CL_SUCCESS;
  Handle<cl_program> program(clCreateProgramWithSource(device.context.get(), 1, &text, &bytes, &status));
  check(status, "clCreateProgramWithSource", fmt::format("{} on {}", source_name, device.info.name));
  status = clBuildProgram(program.get(), 1, &device.id, options.c_str(), nullptr, nullptr);
  const std::string log = build_log(program.get(), device.id);
  if (!log.empty()) spdlog::debug("{} for {} with {}:\n{}", source_name, device.info.name, options, log);
  if (status == CL_SUCCESS) return program;
  if (is_out_of_memory(status)) throw_status(status, "clBuildProgram", source_name);
  throw Error(ErrorKind::build_failed,
              fmt::format("kernels/{} does not build for {} ({}): {}", source_name, device.info.name,
                          status_name(status), at_true_line(source, first_error(log))),
              "update the device's OpenCL driver or choose another --device; --verbose prints the whole log");
}

Handle<cl_program> load_or_compile(const detail::DeviceState& device, std::string_view source_name,
                                   const std::string& source, const std::string& options,
                                   const std::string& identity) {
  const quirks::BuildTurn turn(device.info);
  const DiskCache cache;
  if (const auto binary = cache.load(identity)) {
    if (Handle<cl_program> program = load_binary(device, *binary, options)) return program;
    spdlog::warn("{} refuses its cached binary of {}: rebuilding it", device.info.name, source_name);
  }
  Handle<cl_program> program = compile(device, source_name, source, options);
  cache.store(identity, binary_of(program.get()));
  return program;
}

void check_define(const std::string& name, const std::string& value) {
  if (!name.empty() && (name + value).find_first_of(" \t\n\"'\\") == std::string::npos) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("build definition {}={}: expected a name and a value without blanks or quotes",
                          name, value));
}

}  // namespace

struct Program::State {
  std::shared_ptr<detail::DeviceState> device;
  Handle<cl_program> program;
  std::string name;
};

Defines& Defines::set(std::string name, std::string value) {
  check_define(name, value);
  values_.emplace_back(std::move(name), std::move(value));
  return *this;
}

Defines& Defines::set(std::string name, long long value) {
  return set(std::move(name), std::to_string(value));
}

Program::Program(std::shared_ptr<State> state) : state_(std::move(state)) {}

Program Program::build(const Device& device, std::string_view source_name, const Defines& defines) {
  detail::DeviceState& opened = *device.state();
  const std::string source = quirks::source_preamble(opened.info) + assemble_source(source_name);
  const std::string options = options_of(opened.info, defines);
  const std::string identity = identity_of(opened.info, source, options);
  const std::lock_guard lock(opened.programs_mutex);
  detail::DeviceState::BuiltProgram& last = opened.programs[{std::string(source_name), options}];
  if (last.identity != identity) {
    last = {.identity = identity, .program = load_or_compile(opened, source_name, source, options, identity)};
  }
  check(clRetainProgram(last.program.get()), "clRetainProgram", source_name);
  return Program(std::make_shared<State>(
      State{device.state(), Handle<cl_program>(last.program.get()), std::string(source_name)}));
}

Kernel Program::kernel(std::string_view name) const {
  const std::string kernel_name(name);
  int status = CL_SUCCESS;
  cl_kernel kernel = clCreateKernel(state_->program.get(), kernel_name.c_str(), &status);
  if (status == CL_INVALID_KERNEL_NAME) {
    throw Error(ErrorKind::build_failed, fmt::format("kernels/{} has no kernel \"{}\"", state_->name, name),
                "correct the name, or the folder in OFFING_KERNEL_PATH");
  }
  check(status, "clCreateKernel",
        fmt::format("kernel {} of kernels/{} on {}", name, state_->name, state_->device->info.name));
  return Kernel(state_->device, kernel, kernel_name);
}

}  // namespace offing::ocl

#include "host/ocl/status.h"

#include <array>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/opencl.h"

namespace offing::ocl {
namespace {

struct NamedStatus {
  int status;
  std::string_view name;
};

#define OFFING_STATUS(name) \
  NamedStatus {             \
    name, #name             \
  }
constexpr std::array named_statuses{
    OFFING_STATUS(CL_SUCCESS),
    OFFING_STATUS(CL_DEVICE_NOT_FOUND),
    OFFING_STATUS(CL_DEVICE_NOT_AVAILABLE),
    OFFING_STATUS(CL_COMPILER_NOT_AVAILABLE),
    OFFING_STATUS(CL_MEM_OBJECT_ALLOCATION_FAILURE),
    OFFING_STATUS(CL_OUT_OF_RESOURCES),
    OFFING_STATUS(CL_OUT_OF_HOST_MEMORY),
    OFFING_STATUS(CL_PROFILING_INFO_NOT_AVAILABLE),
    OFFING_STATUS(CL_MEM_COPY_OVERLAP),
    OFFING_STATUS(CL_BUILD_PROGRAM_FAILURE),
    OFFING_STATUS(CL_MAP_FAILURE),
    OFFING_STATUS(CL_MISALIGNED_SUB_BUFFER_OFFSET),
    OFFING_STATUS(CL_EXEC_STATUS_ERROR_FOR_EVENTS_IN_WAIT_LIST),
    OFFING_STATUS(CL_COMPILE_PROGRAM_FAILURE),
    OFFING_STATUS(CL_LINKER_NOT_AVAILABLE),
    OFFING_STATUS(CL_LINK_PROGRAM_FAILURE),
    OFFING_STATUS(CL_KERNEL_ARG_INFO_NOT_AVAILABLE),
    OFFING_STATUS(CL_INVALID_VALUE),
    OFFING_STATUS(CL_INVALID_DEVICE_TYPE),
    OFFING_STATUS(CL_INVALID_PLATFORM),
    OFFING_STATUS(CL_INVALID_DEVICE),
    OFFING_STATUS(CL_INVALID_CONTEXT),
    OFFING_STATUS(CL_INVALID_QUEUE_PROPERTIES),
    OFFING_STATUS(CL_INVALID_COMMAND_QUEUE),
    OFFING_STATUS(CL_INVALID_HOST_PTR),
    OFFING_STATUS(CL_INVALID_MEM_OBJECT),
    OFFING_STATUS(CL_INVALID_BINARY),
    OFFING_STATUS(CL_INVALID_BUILD_OPTIONS),
    OFFING_STATUS(CL_INVALID_PROGRAM),
    OFFING_STATUS(CL_INVALID_PROGRAM_EXECUTABLE),
    OFFING_STATUS(CL_INVALID_KERNEL_NAME),
    OFFING_STATUS(CL_INVALID_KERNEL_DEFINITION),
    OFFING_STATUS(CL_INVALID_KERNEL),
    OFFING_STATUS(CL_INVALID_ARG_INDEX),
    OFFING_STATUS(CL_INVALID_ARG_VALUE),
    OFFING_STATUS(CL_INVALID_ARG_SIZE),
    OFFING_STATUS(CL_INVALID_KERNEL_ARGS),
    OFFING_STATUS(CL_INVALID_WORK_DIMENSION),
    OFFING_STATUS(CL_INVALID_WORK_GROUP_SIZE),
    OFFING_STATUS(CL_INVALID_WORK_ITEM_SIZE),
    OFFING_STATUS(CL_INVALID_GLOBAL_OFFSET),
    OFFING_STATUS(CL_INVALID_EVENT_WAIT_LIST),
    OFFING_STATUS(CL_INVALID_EVENT),
    OFFING_STATUS(CL_INVALID_OPERATION),
    OFFING_STATUS(CL_INVALID_BUFFER_SIZE),
    OFFING_STATUS(CL_INVALID_GLOBAL_WORK_SIZE),
    OFFING_STATUS(CL_INVALID_PROPERTY),
    OFFING_STATUS(CL_INVALID_COMPILER_OPTIONS),
    OFFING_STATUS(CL_INVALID_LINKER_OPTIONS),
    NamedStatus{-1001, "CL_PLATFORM_NOT_FOUND_KHR"},  // from cl_khr_icd, declared in CL/cl_ext.h
};
#undef OFFING_STATUS

std::string_view hint(int status) {
  switch (status) {
    case CL_INVALID_WORK_GROUP_SIZE:
    case CL_INVALID_WORK_ITEM_SIZE:
    case CL_INVALID_GLOBAL_WORK_SIZE:
      return "the launch shape does not suit this device: choose another with --device";
    case CL_OUT_OF_RESOURCES:
      return "the device ran out of a resource or a kernel of it crashed: use a smaller --size or another "
             "--device";
    case CL_DEVICE_NOT_AVAILABLE:
      return "another process holds the device or its driver stopped: choose another with --device";
    default:
      return "update the device's OpenCL driver, or choose another device with --device";
  }
}

}  // namespace

const char* const out_of_memory_hint =
    "use a smaller --size, close other programs, or choose another --device";

std::string status_name(int status) {
  for (const NamedStatus& named : named_statuses) {
    if (named.status == status) return std::string(named.name);
  }
  return fmt::format("OpenCL status {}", status);
}

bool is_out_of_memory(int status) {
  return status == CL_MEM_OBJECT_ALLOCATION_FAILURE || status == CL_OUT_OF_HOST_MEMORY;
}

void throw_status(int status, std::string_view call, std::string_view where) {
  std::string what = fmt::format("{} failed with {}: {}", call, status_name(status), where);
  if (is_out_of_memory(status)) throw Error(ErrorKind::out_of_memory, what, out_of_memory_hint);
  throw Error(ErrorKind::device, what, std::string(hint(status)));
}

}  // namespace offing::ocl

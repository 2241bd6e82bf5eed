#pragma once

#include <string>
#include <string_view>

namespace offing::ocl {

/// The name of an OpenCL status, such as "CL_INVALID_KERNEL_ARGS"; "OpenCL status -9999" for one that no
/// header names.
std::string status_name(int status);

/// Throws the Error that a failed OpenCL call stands for: "<call> failed with <status name>: <where>".
/// Kind out_of_memory when the driver ran out of device or host memory, else device; `where` names the object
/// and the device.
[[noreturn]] void throw_status(int status, std::string_view call, std::string_view where);

/// Does nothing for CL_SUCCESS, else throw_status().
inline void check(int status, std::string_view call, std::string_view where) {
  if (status != 0) throw_status(status, call, where);
}

/// True if the status says that memory did not suffice.
bool is_out_of_memory(int status);

/// The fix for errors of kind out_of_memory.
extern const char* const out_of_memory_hint;

}  // namespace offing::ocl

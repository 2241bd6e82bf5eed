#pragma once

// The OpenCL header as every source of host/ocl sees it; no public header includes it. Only calls of
// OpenCL 1.2 are used, so that any driver of that version or later serves; two of them are deprecated
// since 2.0.
#define CL_TARGET_OPENCL_VERSION 300
#define CL_USE_DEPRECATED_OPENCL_1_2_APIS
#include <memory>
#include <type_traits>

#include <CL/cl.h>

namespace offing::ocl {

/// Gives an OpenCL object back; failures are ignored because destructors must not throw.
struct Release {
  void operator()(cl_context object) const noexcept { clReleaseContext(object); }
  void operator()(cl_command_queue object) const noexcept { clReleaseCommandQueue(object); }
  void operator()(cl_mem object) const noexcept { clReleaseMemObject(object); }
  void operator()(cl_program object) const noexcept { clReleaseProgram(object); }
  void operator()(cl_kernel object) const noexcept { clReleaseKernel(object); }
  void operator()(cl_event object) const noexcept { clReleaseEvent(object); }
};

/// Owns one reference to an OpenCL object: Handle<cl_context> and so on.
template <class Object>
using Handle = std::unique_ptr<std::remove_pointer_t<Object>, Release>;

}  // namespace offing::ocl

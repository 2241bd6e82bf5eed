#include "host/ocl/imported_buffer.h"

#include <utility>

#include "host/base/error.h"
#include "host/ocl/device_state.h"
#include "host/ocl/opencl.h"
#include "host/ocl/status.h"
// After opencl.h, which says what version is wanted.
#include <CL/cl_gl.h>

namespace offing::ocl {

ImportedBuffer::ImportedBuffer(const Device& device, unsigned gl_name) : device_(device.state()) {
  if (!device.shares_gl()) {
    throw Error(ErrorKind::bad_usage,
                "imported buffer: expected a device that shares with OpenGL, found one that "
                "does not: " +
                    device.info().name,
                "open it with Device::open_shared()");
  }
  int status = CL_SUCCESS;
  memory_ = clCreateFromGLBuffer(device.context(), CL_MEM_WRITE_ONLY, gl_name, &status);
  check(status, "clCreateFromGLBuffer", device.info().name);
}

ImportedBuffer::ImportedBuffer(ImportedBuffer&& other) noexcept
    : device_(std::move(other.device_)), memory_(std::exchange(other.memory_, nullptr)) {}

ImportedBuffer& ImportedBuffer::operator=(ImportedBuffer&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(memory_, other.memory_);
  return *this;
}

ImportedBuffer::~ImportedBuffer() {
  if (memory_ != nullptr) clReleaseMemObject(memory_);
}

void ImportedBuffer::copy_from(const FloatSpan& source) {
  const std::size_t bytes = source.size() * sizeof(float);
  const std::string& where = device_->info.name;
  const cl_command_queue queue = device_->queue.get();
  check(clEnqueueAcquireGLObjects(queue, 1, &memory_, 0, nullptr, nullptr), "clEnqueueAcquireGLObjects",
        where);
  const int status = clEnqueueCopyBuffer(queue, source.handle(), memory_, 0, 0, bytes, 0, nullptr, nullptr);
  // OpenGL gets the buffer back also after a failure.
  check(clEnqueueReleaseGLObjects(queue, 1, &memory_, 0, nullptr, nullptr), "clEnqueueReleaseGLObjects",
        where);
  check(status, "clEnqueueCopyBuffer", where);
  check(clFinish(queue), "clFinish", where);
}

}  // namespace offing::ocl

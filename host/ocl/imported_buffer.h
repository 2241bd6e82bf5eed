#pragma once

#include <cstddef>
#include <memory>

#include "host/ocl/buffer.h"
#include "host/ocl/device.h"

namespace offing::ocl {

/// A buffer object of OpenGL that a device of Device::open_shared() writes (cl_khr_gl_sharing), move-only.
class ImportedBuffer {
 public:
  /// `gl_name` is a buffer object of the shared context that has its memory already, and keeps it while this
  /// object lives. Throws Error(bad_usage) if the device does not share, Error(device) if the driver refuses.
  ImportedBuffer(const Device& device, unsigned gl_name);
  ImportedBuffer(ImportedBuffer&& other) noexcept;
  ImportedBuffer& operator=(ImportedBuffer&& other) noexcept;
  ~ImportedBuffer();

  /// Copies all floats to the start of the OpenGL buffer and waits; OpenGL must be done with the buffer.
  void copy_from(const FloatSpan& source);

 private:
  std::shared_ptr<detail::DeviceState> device_;
  cl_mem memory_ = nullptr;
};

}  // namespace offing::ocl

#pragma once

#include <cstddef>
#include <span>

#include "host/ocl/buffer.h"

namespace offing::ocl {

/// The floats of a buffer whose elements are floats, or made of floats alone. Valid while the buffer lives.
class FloatSpan {
 public:
  template <class T>
  FloatSpan(const Buffer<T>& buffer)  // NOLINT(google-explicit-constructor): a buffer is its floats
      : memory_(&buffer.memory()), count_(buffer.size() * (sizeof(T) / sizeof(float))) {
    static_assert(sizeof(T) % sizeof(float) == 0 && alignof(T) == alignof(float), "made of floats");
  }

  std::size_t size() const { return count_; }
  cl_mem handle() const { return memory_->handle(); }
  MappedSpan<float> map() const { return MappedSpan<float>(*memory_, count_); }
  /// Waits until the first floats are there.
  void read(std::span<float> values) const { memory_->read(0, values.size_bytes(), values.data()); }
  /// Queues a copy of all floats to `target`, which must live until the event is done.
  Event begin_read(float* target) const { return memory_->begin_read(target); }

 private:
  const detail::Memory* memory_;
  std::size_t count_;
};

}  // namespace offing::ocl

#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "host/ocl/device.h"
#include "host/ocl/event.h"

typedef struct _cl_mem* cl_mem;

namespace offing::ocl {

class HostPages;

namespace detail {

/// count * element_bytes; throws Error(out_of_memory) that names the buffer where that overflows.
std::size_t checked_bytes(std::size_t count, std::size_t element_bytes, std::string_view name);

void release_pages(HostPages* pages);

/// Untyped device memory; Buffer<T> is its typed face. On a CPU device it lives in page-aligned host memory
/// (huge pages where they pay), so that mapping costs nothing; quirks.h says where that must not be done.
class Memory {
 public:
  Memory() = default;
  Memory(const Device& device, std::size_t bytes, std::string_view name);
  /// A buffer of the caller's, of the same context, which stays while this object lives. Throws
  /// Error(bad_usage) for a buffer of another context.
  static Memory adopt(const Device& device, cl_mem memory, std::string_view name);
  Memory(Memory&& other) noexcept;
  Memory& operator=(Memory&& other) noexcept;
  Memory(const Memory&) = delete;
  Memory& operator=(const Memory&) = delete;
  ~Memory();

  cl_mem handle() const { return memory_; }
  std::size_t bytes() const { return bytes_; }
  void write(std::size_t offset_bytes, std::size_t bytes, const void* source);
  void read(std::size_t offset_bytes, std::size_t bytes, void* target) const;
  Event begin_read(void* target) const;
  Event begin_write(const void* source);
  void fill(const void* pattern, std::size_t pattern_bytes);
  const void* map_read() const;
  void unmap(const void* pointer) const noexcept;

 private:
  void touch();
  void release() noexcept;
  void check_range(std::size_t offset_bytes, std::size_t bytes, std::string_view action) const;

  std::shared_ptr<DeviceState> device_;
  std::unique_ptr<HostPages, void (*)(HostPages*)> pages_{nullptr, release_pages};
  cl_mem memory_ = nullptr;
  std::size_t bytes_ = 0;
  std::string name_;
};

}  // namespace detail

/// A read-only view of a buffer's content in host memory, unmapped at the end of its life.
template <class T>
class MappedSpan {
 public:
  MappedSpan(const detail::Memory& memory, std::size_t count)
      : memory_(&memory), data_(static_cast<const T*>(memory.map_read())), count_(count) {}
  MappedSpan(const MappedSpan&) = delete;
  MappedSpan& operator=(const MappedSpan&) = delete;
  ~MappedSpan() { memory_->unmap(data_); }

  std::span<const T> span() const { return {data_, count_}; }
  const T& operator[](std::size_t i) const { return data_[i]; }

 private:
  const detail::Memory* memory_;
  const T* data_;
  std::size_t count_;
};

/// A typed array on a device, move-only. Transfers block; kernels that were queued before them are done by
/// then. Throws Error(out_of_memory) naming the buffer when it does not fit.
template <class T>
class Buffer {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  Buffer() = default;
  /// Uninitialised memory for `count` elements; `name` appears in error messages.
  Buffer(const Device& device, std::size_t count, std::string_view name)
      : memory_(device, detail::checked_bytes(count, sizeof(T), name), name), count_(count) {}
  Buffer(const Device& device, std::span<const T> values, std::string_view name)
      : Buffer(device, values.size(), name) {
    write(values);
  }

  /// As many whole elements as a buffer of the caller's holds: Memory::adopt().
  static Buffer adopt(const Device& device, cl_mem memory, std::string_view name) {
    Buffer buffer;
    buffer.memory_ = detail::Memory::adopt(device, memory, name);
    buffer.count_ = buffer.memory_.bytes() / sizeof(T);
    return buffer;
  }

  std::size_t size() const { return count_; }
  bool empty() const { return count_ == 0; }
  cl_mem handle() const { return memory_.handle(); }

  void write(std::span<const T> values, std::size_t first = 0) {
    memory_.write(first * sizeof(T), values.size_bytes(), values.data());
  }
  void read(std::span<T> values, std::size_t first = 0) const {
    memory_.read(first * sizeof(T), values.size_bytes(), values.data());
  }
  std::vector<T> read() const {
    std::vector<T> values(count_);
    read(values);
    return values;
  }
  /// Queues a copy of all elements to `target` (of size() elements at least), which must live until the event
  /// is done.
  Event begin_read(T* target) const { return memory_.begin_read(target); }
  /// Queues a copy of size() elements from `source`, which must live and stay as it is until the event is
  /// done.
  Event begin_write(const T* source) { return memory_.begin_write(source); }
  void fill(const T& value) {
    static_assert((sizeof(T) & (sizeof(T) - 1)) == 0 && sizeof(T) <= 128, "what OpenCL can fill with");
    memory_.fill(&value, sizeof(T));
  }
  MappedSpan<T> map() const { return MappedSpan<T>(memory_, count_); }
  const detail::Memory& memory() const { return memory_; }

 private:
  detail::Memory memory_;
  std::size_t count_ = 0;
};

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

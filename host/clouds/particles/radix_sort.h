#pragma once

#include <cstdint>

#include "host/ocl/buffer.h"
#include "host/ocl/kernel.h"
#include "host/ocl/tuning.h"

namespace offing::clouds {

/// Sorts 32-bit keys and a value beside each on the device, stably, least digit first: linear in their
/// number.
class RadixSort {
 public:
  explicit RadixSort(const ocl::Device& device);

  /// Queues the sort of the first `count` of keys() and values(), which whoever sorts has written.
  void sort(std::uint32_t count);

  /// Makes room for this many; what was there is lost if it grows.
  void reserve(std::uint32_t count);
  /// [reserved]; after sort() in ascending order.
  ocl::Buffer<std::uint32_t>& keys() { return keys_; }
  ocl::Buffer<std::uint32_t>& values() { return values_; }
  const ocl::Buffer<std::uint32_t>& values() const { return values_; }

 private:
  ocl::Device device_;
  ocl::KernelTuning sort_tuning_, scan_tuning_;
  ocl::Kernel count_kernel_, scan_kernel_, scatter_kernel_;
  ocl::Buffer<std::uint32_t> keys_, values_, other_keys_, other_values_, counts_, starts_;
};

}  // namespace offing::clouds

#include "host/clouds/particles/radix_sort.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/program.h"
#include "host/ocl/tuning.h"

namespace offing::clouds {
namespace {

constexpr int key_bits = 32;

// CPU: three passes, whose 2048 counters stay in the first cache; a second work-item pays from some thousand
// keys on. GPU: 16 counters for each of 64 work-items are 4 KiB of local memory.
struct Shape {
  int digit_bits, group_size, scan_size, least_span;
};
constexpr Shape simd_shape{11, 1, 1, 8192}, workgroup_shape{4, 64, 256, 16};

bool is_simd(const ocl::Device& device) {
  return ocl::tuning_for(device.info(), "clouds").shape == ocl::KernelShape::simd;
}

ocl::Kernel built(const ocl::Device& device, const char* source, const char* kernel) {
  const Shape& shape = is_simd(device) ? simd_shape : workgroup_shape;
  ocl::Defines defines;
  defines.set("GROUP_SIZE", shape.group_size)
      .set("DIGIT_BITS", shape.digit_bits)
      .set("SCAN_SIZE", shape.scan_size);
  return ocl::Program::build(device, source, defines).kernel(kernel);
}

}  // namespace

RadixSort::RadixSort(const ocl::Device& device)
    : device_(device),
      is_simd_(is_simd(device)),
      count_kernel_(built(device, "clouds/radix_count.cl", "radix_count")),
      scan_kernel_(built(device, "clouds/radix_scan.cl", "radix_scan")),
      scatter_kernel_(built(device, "clouds/radix_scatter.cl", "radix_scatter")) {}

void RadixSort::reserve(std::uint32_t count) {
  if (count <= keys_.size()) return;
  for (auto* buffer : {&keys_, &values_, &other_keys_, &other_values_})
    *buffer = ocl::Buffer<std::uint32_t>(device_, count, "sorted keys and values");
}

void RadixSort::sort(std::uint32_t count) {
  if (count == 0) return;
  if (count > keys_.size()) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("sort: expected at most {} keys, got {}", keys_.size(), count), "reserve() more");
  }
  const Shape& shape = is_simd_ ? simd_shape : workgroup_shape;
  const auto keys = static_cast<int>(count);
  // On a CPU as many spans as there are cores, if they are long; on a GPU spans are short.
  int span = shape.least_span;
  if (is_simd_) {
    const int cores = std::max(1, static_cast<int>(device_.info().compute_units));
    span = std::max(span, (keys + cores - 1) / cores);
  }
  const int tile = span * shape.group_size, groups = (keys + tile - 1) / tile;
  const std::size_t counters = static_cast<std::size_t>(groups) << shape.digit_bits;
  if (counts_.size() < counters) {
    counts_ = ocl::Buffer<std::uint32_t>(device_, counters, "digits of keys");
    starts_ = ocl::Buffer<std::uint32_t>(device_, counters, "places of digits");
  }
  const auto group_size = static_cast<std::size_t>(shape.group_size),
             scan_size = static_cast<std::size_t>(shape.scan_size);
  const ocl::LaunchShape launch{{static_cast<std::size_t>(groups) * group_size}, {group_size}};
  for (int shift = 0; shift < key_bits; shift += shape.digit_bits) {
    count_kernel_.launch(launch, keys_, keys, span, shift, counts_);
    scan_kernel_.launch({{scan_size}, {scan_size}}, counts_, static_cast<int>(counters), starts_);
    scatter_kernel_.launch(launch, keys_, values_, keys, span, shift, starts_, other_keys_, other_values_);
    std::swap(keys_, other_keys_);
    std::swap(values_, other_values_);
  }
}

}  // namespace offing::clouds

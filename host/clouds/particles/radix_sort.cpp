#include "host/clouds/particles/radix_sort.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocl/program.h"

namespace offing::clouds {
namespace {

constexpr int key_bits = 32;

ocl::Kernel built(const ocl::Device& device, const char* source, const char* kernel,
                  const ocl::KernelTuning& sort, const ocl::KernelTuning& scan) {
  ocl::Defines defines;
  defines.set("GROUP_SIZE", static_cast<long long>(sort.group))
      .set("DIGIT_BITS", sort.digit_bits)
      .set("SCAN_SIZE", static_cast<long long>(scan.group));
  return ocl::Program::build(device, source, defines).kernel(kernel);
}

}  // namespace

RadixSort::RadixSort(const ocl::Device& device)
    : device_(device),
      sort_tuning_(ocl::tuning_for(device.info(), "radix_sort")),
      scan_tuning_(ocl::tuning_for(device.info(), "radix_scan")),
      count_kernel_(built(device, "clouds/radix_count.cl", "radix_count", sort_tuning_, scan_tuning_)),
      scan_kernel_(built(device, "clouds/radix_scan.cl", "radix_scan", sort_tuning_, scan_tuning_)),
      scatter_kernel_(built(device, "clouds/radix_scatter.cl", "radix_scatter", sort_tuning_, scan_tuning_)) {
}

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
  const auto keys = static_cast<int>(count);
  // On a CPU as many spans as there are cores, if they are long; on a GPU spans are short.
  int span = sort_tuning_.per_item;
  if (sort_tuning_.shape == ocl::KernelShape::simd) {
    const int cores = std::max(1, static_cast<int>(device_.info().compute_units));
    span = std::max(span, (keys + cores - 1) / cores);
  }
  const int tile = span * static_cast<int>(sort_tuning_.group), groups = (keys + tile - 1) / tile;
  const std::size_t counters = static_cast<std::size_t>(groups) << sort_tuning_.digit_bits;
  if (counts_.size() < counters) {
    counts_ = ocl::Buffer<std::uint32_t>(device_, counters, "digits of keys");
    starts_ = ocl::Buffer<std::uint32_t>(device_, counters, "places of digits");
  }
  const ocl::LaunchShape launch{{static_cast<std::size_t>(groups) * sort_tuning_.group},
                                {sort_tuning_.group}};
  for (int shift = 0; shift < key_bits; shift += sort_tuning_.digit_bits) {
    count_kernel_.launch(launch, keys_, keys, span, shift, counts_);
    scan_kernel_.launch({{scan_tuning_.group}, {scan_tuning_.group}}, counts_, static_cast<int>(counters),
                        starts_);
    scatter_kernel_.launch(launch, keys_, values_, keys, span, shift, starts_, other_keys_, other_values_);
    std::swap(keys_, other_keys_);
    std::swap(values_, other_values_);
  }
}

}  // namespace offing::clouds

// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/huge_array.h"

#include <cstdlib>
#include <cstring>
#include <utility>

#include <fmt/format.h>
#include <sys/mman.h>

#include "host/base/error.h"

namespace offing::bench {

HugeArray::HugeArray(std::size_t floats) : size_(floats) {
  constexpr std::size_t huge_page_bytes = std::size_t{2} << 20;
  const std::size_t bytes =
      (floats * sizeof(float) + huge_page_bytes - 1) / huge_page_bytes * huge_page_bytes;
  void* const pages = std::aligned_alloc(huge_page_bytes, bytes);
  if (pages == nullptr) {
    throw Error(ErrorKind::out_of_memory, fmt::format("benchmark array: {} bytes are not there", bytes),
                "choose smaller --sizes");
  }
  // Advice only: where it is refused, ordinary pages serve.
  madvise(pages, bytes, MADV_HUGEPAGE);
  std::memset(pages, 0, bytes);
  data_ = static_cast<float*>(pages);
}

HugeArray::HugeArray(HugeArray&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)), size_(other.size_) {}

HugeArray::~HugeArray() {
  std::free(data_);
}

void HugeArray::clear() {
  std::memset(data_, 0, size_ * sizeof(float));
}

}  // namespace offing::bench

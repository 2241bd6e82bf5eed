// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#pragma once

#include <cstddef>

namespace offing::bench {

/// Floats in pages of 2 MiB where the system gives them, zeroed and present: what a specialist hands FFTW,
/// which gains up to half its time by it at large sizes.
class HugeArray {
 public:
  /// Throws Error(out_of_memory).
  explicit HugeArray(std::size_t floats);
  HugeArray(HugeArray&& other) noexcept;
  HugeArray& operator=(HugeArray&&) = delete;
  ~HugeArray();

  float* data() { return data_; }
  const float* data() const { return data_; }
  std::size_t size() const { return size_; }
  void clear();

 private:
  float* data_;
  std::size_t size_;
};

}  // namespace offing::bench

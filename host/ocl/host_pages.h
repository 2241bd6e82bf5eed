#pragma once

#include <cstddef>

namespace offing::ocl {

/// Page-aligned zeroed host memory whose pages are present; from 2 MiB on it asks for huge pages, which spare
/// the address translation of large strided transforms up to a third of their time.
class HostPages {
 public:
  /// At least `bytes`, rounded up to whole pages. data() is null if the memory is not there.
  explicit HostPages(std::size_t bytes);
  HostPages(const HostPages&) = delete;
  HostPages& operator=(const HostPages&) = delete;
  ~HostPages();

  void* data() const { return data_; }

  /// What `bytes` rounds up to.
  static std::size_t rounded(std::size_t bytes);

 private:
  void* data_ = nullptr;
};

}  // namespace offing::ocl

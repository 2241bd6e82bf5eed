#pragma once

#include <cstddef>
#include <cstdint>

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
  std::size_t bytes() const { return bytes_; }

  /// What `bytes` rounds up to.
  static std::size_t rounded(std::size_t bytes);

 private:
  void* data_ = nullptr;
  std::size_t bytes_ = 0;
};

/// All memory of this machine; 0 if the system does not say.
std::uint64_t total_host_memory_bytes();

/// Host memory that can still be used without swapping or breaking this process' cgroup limit; the largest
/// number if the system does not say.
std::uint64_t available_host_memory_bytes();

}  // namespace offing::ocl

#pragma once

#include <string>
#include <string_view>

#include "host/ocl/device.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::test {

/// Kernels that a test writes itself: files in a temporary folder that OFFING_KERNEL_PATH names while this
/// lives, and a cache folder of its own beside them.
class TestKernels {
 public:
  TestKernels();
  /// Writes `text` as the kernel source `name`.
  void write(std::string_view name, std::string_view text) const;
  /// Writes Offing's own kernel source `name` with `part` of it replaced. Fails the test if it has no such
  /// part.
  void change(std::string_view name, std::string_view part, std::string_view by) const;
  std::string path_of(std::string_view name) const { return (folder_.path() / name).string(); }
  const TemporaryFolder& cache() const { return cache_; }

 private:
  TemporaryFolder folder_;
  TemporaryFolder cache_;
  ScopedEnvironment kernel_path_;
  ScopedEnvironment cache_path_;
};

}  // namespace offing::test

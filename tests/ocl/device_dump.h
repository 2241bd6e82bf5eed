#pragma once

#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "tests/io/temporary_folder.h"

namespace offing::test {

/// A program that writes floats to the file that it is given, run on one OpenCL implementation after the
/// other: drivers read their environment once, so each needs a process of its own. Each run has the same
/// empty program cache, so that kernels are compiled by the device at hand.
class DeviceDump {
 public:
  /// PoCL with the kernels shaped for a CPU.
  static constexpr const char* default_device = "OFFING_SHAPE=simd OFFING_DEVICE=portable";

  explicit DeviceDump(std::string program) : program_(std::move(program)) {}

  /// What the program writes with this before its command: variables, or a program that runs it. A failure of
  /// the test if it does not end well.
  std::vector<float> values(const std::string& prefix) const;
  /// The same under Oclgrind, which watches memory and data races, with the kernels in one shape ("simd",
  /// "workgroup"). A failure of the test if that has anything to say.
  std::vector<float> values_under_oclgrind(const std::string& shape) const;

  /// Checks what was found elsewhere beside what the default device wrote.
  using Compare = std::function<void(const std::vector<float>& found, const std::vector<float>& expected)>;
  /// For PoCL with the kernels shaped for a GPU, and for the other devices in their shapes, or skips where
  /// one of these is not installed.
  void compare_devices(const Compare& compare) const;
  /// For both shapes under Oclgrind, or skips where it is not installed.
  void compare_under_oclgrind(const Compare& compare) const;

  static bool has_oclgrind();

 private:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  std::string program_;
  TemporaryFolder folder_;
};

}  // namespace offing::test

#pragma once

#include <ostream>
#include <string>
#include <utility>
#include <vector>

namespace offing::test {

/// An OpenCL implementation that slow tests compare with PoCL. Drivers read their environment once, so each
/// needs a process of its own.
struct OtherDevice {
  std::string name;
  std::vector<std::pair<std::string, std::string>> environment;  ///< makes it the device that programs take
  std::vector<std::string> shapes;                               ///< what OFFING_SHAPE is tried with
  std::string missing;  ///< why it is not there, and what installs it; empty: it is there

  bool is_installed() const { return missing.empty(); }
  /// The environment as a shell takes it in front of a command: "A=1 B=2 ".
  std::string prefix() const;
};

inline void PrintTo(const OtherDevice& device, std::ostream* out) {
  *out << device.name;
}

OtherDevice rusticl();
/// Intel's OpenCL for the CPU, from the environment of PyPI packages that `./dev test --slow` makes.
OtherDevice intel();
/// All of them.
std::vector<OtherDevice> other_devices();
/// Why some of them are not there, one sentence each; empty: all are.
std::string missing_devices();

}  // namespace offing::test

#include "tests/present/editing/holdings.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace offing::test {

Holdings holdings() {
  Holdings found;
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);) {
    if (line.starts_with("VmRSS:")) found.memory_mb = std::stod(line.substr(6)) / 1024.0;
  }
  for (const auto& task : std::filesystem::directory_iterator("/proc/self/task")) {
    std::string name;
    std::getline(std::ifstream(task.path() / "comm"), name);
    if (name.find(":disk$") == name.npos) ++found.threads;
  }
  const std::filesystem::directory_iterator folder("/proc/self/fd");
  found.descriptors = static_cast<int>(std::distance(begin(folder), end(folder)));
  return found;
}

double soak_seconds(double usual) {
  const char* asked = std::getenv("OFFING_SOAK_SECONDS");
  return asked != nullptr ? std::stod(asked) : usual;
}

}  // namespace offing::test

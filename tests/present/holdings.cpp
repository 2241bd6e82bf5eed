#include "tests/present/holdings.h"

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
    if (line.starts_with("Threads:")) found.threads = std::stoi(line.substr(8));
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

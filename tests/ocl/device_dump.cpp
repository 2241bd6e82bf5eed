#include "tests/ocl/device_dump.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include <gtest/gtest.h>

#include "tests/ocl/other_devices.h"

namespace offing::test {
namespace {

std::string text_of(const std::string& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

std::vector<float> DeviceDump::values(const std::string& prefix) const {
  const std::string output = path("output"), dump = path("dump");
  const std::string command = "OFFING_CACHE_DIR=" + path("cache") + " " + prefix + " " + program_ + " " +
                              dump + " > " + output + " 2>&1";
  std::filesystem::remove(dump);
  EXPECT_EQ(std::system(command.c_str()), 0) << prefix << "\n" << text_of(output);
  std::vector<float> result;
  std::ifstream file(dump, std::ios::binary);
  for (float value = 0.0f; file.read(reinterpret_cast<char*>(&value), sizeof(value));)
    result.push_back(value);
  return result;
}

std::vector<float> DeviceDump::values_under_oclgrind(const std::string& shape) const {
  // Oclgrind 21.10 compiles the builtin prefetch, and does not know it when it runs.
  std::vector<float> result = values("OFFING_SHAPE=" + shape + " oclgrind --data-races --log " + path("log"));
  EXPECT_EQ(text_of(path("log")), "") << shape;
  return result;
}

void DeviceDump::compare_devices(const Compare& compare) const {
  const std::vector<float> expected = values(default_device);
  compare(values("OFFING_SHAPE=workgroup OFFING_DEVICE=portable"), expected);
  for (const OtherDevice& device : other_devices()) {
    if (!device.is_installed()) continue;
    for (const std::string& shape : device.shapes) {
      SCOPED_TRACE(device.name + " " + shape);
      compare(values(device.prefix() + "OFFING_SHAPE=" + shape), expected);
    }
  }
  if (const std::string missing = missing_devices(); !missing.empty()) GTEST_SKIP() << missing;
}

void DeviceDump::compare_under_oclgrind(const Compare& compare) const {
  if (!has_oclgrind()) GTEST_SKIP() << "oclgrind is not installed";
  const std::vector<float> expected = values(default_device);
  for (const std::string shape : {"workgroup", "simd"}) compare(values_under_oclgrind(shape), expected);
}

bool DeviceDump::has_oclgrind() {
  return std::system("command -v oclgrind > /dev/null 2>&1") == 0;
}

}  // namespace offing::test

// The same sky on other OpenCL implementations, in processes of their own (sky_dump.cpp), and every kernel
// under Oclgrind's checks of memory.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/io/temporary_folder.h"
#include "tests/ocl/other_devices.h"

namespace offing::sky {
namespace {

class SkyCrossDeviceTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string text_of(const std::string& name) const {
    std::ifstream file(path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  // A program cache of its own, so that kernels are compiled by the device at hand.
  std::vector<float> dump(const std::string& prefix) const {
    const std::string command = "OFFING_CACHE_DIR=" + path("cache") + " " + prefix + " " + OFFING_SKY_DUMP +
                                " " + path("dump") + " > " + path("output") + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << prefix << "\n" << text_of("output");
    std::ifstream file(path("dump"), std::ios::binary);
    std::vector<float> values;
    for (float value = 0.0f; file.read(reinterpret_cast<char*>(&value), sizeof(value));)
      values.push_back(value);
    return values;
  }

  // Kernels with their loops cut down to a few turns, so that an interpreter ends within minutes: every line
  // runs, all of every table is written and read. Returns the variable that names them.
  std::string short_kernels() const {
    const std::regex count("#define (STEPS|RINGS|AZIMUTHS) [0-9]+");
    std::filesystem::create_directories(folder_.path() / "kernels/sky");
    for (const auto& file : std::filesystem::directory_iterator(std::string(OFFING_KERNELS) + "/sky")) {
      std::ifstream original(file.path());
      const std::string source{std::istreambuf_iterator<char>(original), {}};
      std::ofstream(folder_.path() / "kernels/sky" / file.path().filename())
          << std::regex_replace(source, count, "#define $1 2");
    }
    return "OFFING_KERNEL_PATH=" + path("kernels");
  }

  // Exponentials, roots and arc cosines of two implementations differ by ulps, 6e-8 each, some ten of which a
  // texel goes through; aureoles and the rows beside the horizon amplify them. Measured 1.5e-6 on Intel's
  // runtime, and 9.8e-6 by day and 4.9e-4 in twilight before thin slices kept their light. Gate 5e-6 of the
  // mean light or of the value.
  static void expect_same(const std::vector<float>& found, const std::vector<float>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_FALSE(expected.empty());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_NEAR(found[i], expected[i], 5e-6f * std::max(1.0f, std::abs(expected[i]))) << i;
    }
  }

  static constexpr const char* default_device = "OFFING_DEVICE=portable";
  TemporaryFolder folder_;
};

// Fails if a kernel relies on what one driver does, such as its mathematics or its vectors.
TEST_F(SkyCrossDeviceTest, AllDevicesGiveTheSameSky) {
  for (const test::OtherDevice& device : test::other_devices()) {
    SCOPED_TRACE(device.name);
    if (device.is_installed()) expect_same(dump(device.prefix()), dump(default_device));
  }
  if (const std::string missing = test::missing_devices(); !missing.empty()) GTEST_SKIP() << missing;
}

// Fails if a work-item reads or writes outside a buffer, or results differ from those of a real device.
TEST_F(SkyCrossDeviceTest, OclgrindReportsNothing) {
  if (std::system("command -v oclgrind > /dev/null 2>&1") != 0) GTEST_SKIP() << "oclgrind is not installed";
  const std::string kernels = short_kernels();
  expect_same(dump(kernels + " oclgrind --data-races --log " + path("log")),
              dump(kernels + " " + default_device));
  EXPECT_EQ(text_of("log"), "");
}

}  // namespace
}  // namespace offing::sky

// The same sea on other OpenCL implementations, in processes of their own (sea_dump.cpp), and every kernel
// under Oclgrind's checks of memory and of data races.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>
#include <sys/wait.h>

#include "tests/io/temporary_folder.h"
#include "tests/ocl/other_devices.h"

namespace offing::ocean {
namespace {

class CrossDeviceTest : public testing::Test {
 protected:
  // Exit code of a shell command.
  static int run(const std::string& command) {
    const int status = std::system(command.c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  }
  static bool has(const std::string& command) { return run(command + " > /dev/null 2>&1") == 0; }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  // A program cache of its own, so that kernels are compiled by the device at hand.
  std::string dump_command(const std::string& prefix, int size, const std::string& name) const {
    return "OFFING_CACHE_DIR=" + path("cache") + " " + prefix + " " + OFFING_SEA_DUMP + " " +
           std::to_string(size) + " " + path(name);
  }
  std::vector<float> dump(const std::string& prefix, int size) const {
    EXPECT_EQ(run(dump_command(prefix, size, "dump") + " > " + path("output") + " 2>&1"), 0)
        << prefix << "\n"
        << text_of("output");
    std::ifstream file(path("dump"), std::ios::binary);
    std::vector<char> bytes((std::istreambuf_iterator<char>(file)), {});
    std::vector<float> values(bytes.size() / sizeof(float));
    std::copy_n(bytes.data(), values.size() * sizeof(float), reinterpret_cast<char*>(values.data()));
    return values;
  }
  std::string text_of(const std::string& name) const {
    std::ifstream file(path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }

  // The first six fields are displacements in Hs, promised to 1e-4 (measured 1.2e-7). The others are in units
  // of their own size, foam in half precision: 2^-11 (measured 1.2e-4).
  void expect_same_sea(const std::vector<float>& found, const std::vector<float>& expected, int size) const {
    ASSERT_EQ(found.size(), expected.size());
    const std::size_t displacements = 6u * static_cast<std::size_t>(size * size);
    double displacement = 0.0, others = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      ASSERT_TRUE(std::isfinite(found[i]));
      double& worst = i < displacements ? displacement : others;
      worst = std::max(worst, std::abs(static_cast<double>(found[i]) - expected[i]));
    }
    EXPECT_LT(displacement, 1e-5);
    EXPECT_LT(others, 0x1p-11);
  }

  void expect_clean(const std::string& shape, int size) const {
    if (!has("command -v oclgrind")) GTEST_SKIP() << "oclgrind is not installed";
    // Oclgrind 21.10 compiles the builtin prefetch, and does not know it when it runs.
    const std::string prefix = "OFFING_SHAPE=" + shape + " oclgrind --data-races --log " + path("log");
    expect_same_sea(dump(prefix, size), dump(default_device, size), size);
    EXPECT_EQ(text_of("log"), "") << shape << " " << size;
  }

  static constexpr const char* default_device = "OFFING_SHAPE=simd OFFING_DEVICE=portable";
  TemporaryFolder folder_;
};

// Fails if a kernel relies on what one driver does, such as its mathematics, its rounding or its vectors.
TEST_F(CrossDeviceTest, AllDevicesGiveTheSameSea) {
  for (const test::OtherDevice& device : test::other_devices()) {
    if (!device.is_installed()) continue;
    for (const int size : {16, 32}) {
      SCOPED_TRACE(device.name);
      expect_same_sea(dump(device.prefix() + "OFFING_SHAPE=workgroup", size), dump(default_device, size),
                      size);
    }
  }
  if (const std::string missing = test::missing_devices(); !missing.empty()) GTEST_SKIP() << missing;
}

// Fails if Intel's runtime computes fields of any size, 16 ... 4096, in either family, less exactly than PoCL
// may (transform_sizes_test.cpp).
TEST_F(CrossDeviceTest, IntelKeepsTheBoundOfPocl) {
  const test::OtherDevice intel = test::intel();
  if (!intel.is_installed()) GTEST_SKIP() << intel.missing;
  EXPECT_EQ(run("OFFING_CACHE_DIR=" + path("cache") + " " + intel.prefix() + OFFING_TRANSFORM_SIZES_TEST), 0);
}

// Fails if a work-item reads or writes outside a buffer, if two race for a place, or if results differ from
// those of a real device.
TEST_F(CrossDeviceTest, OclgrindReportsNothing) {
  for (const auto& [shape, size] :
       {std::pair{"workgroup", 16}, {"workgroup", 32}, {"workgroup", 64}, {"simd", 32}, {"simd", 64}}) {
    expect_clean(shape, size);
  }
}

// The same for the rows of 256 and more, for which the simd shape has code of its own: minutes.
TEST_F(CrossDeviceTest, OclgrindReportsNothingOfLongRows) {
  expect_clean("simd", 256);
}

// Fails if the test above could not find a race: without its barriers the exchange through local memory has
// some.
TEST_F(CrossDeviceTest, OclgrindWouldReportARace) {
  if (!has("command -v oclgrind")) GTEST_SKIP() << "oclgrind is not installed";
  std::ifstream original(std::string(OFFING_KERNELS) + "/fft/workgroup_stages.clh");
  std::string source{std::istreambuf_iterator<char>(original), {}};
  const std::string barrier = "barrier(CLK_LOCAL_MEM_FENCE);";
  ASSERT_NE(source.find(barrier), std::string::npos);
  for (std::size_t at = source.find(barrier); at != std::string::npos; at = source.find(barrier))
    source.erase(at, barrier.size());
  std::filesystem::create_directories(folder_.path() / "kernels" / "fft");
  std::ofstream(path("kernels/fft/workgroup_stages.clh")) << source;
  run(dump_command("OFFING_KERNEL_PATH=" + path("kernels") +
                       " OFFING_SHAPE=workgroup oclgrind --data-races --log " + path("log"),
                   16, "dump") +
      " > /dev/null 2>&1");
  EXPECT_NE(text_of("log").find("data race"), std::string::npos);
}

}  // namespace
}  // namespace offing::ocean

// The same ground on other OpenCL implementations, in processes of their own (ground_dump.cpp), and every
// kernel under Oclgrind's checks of memory and of data races.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/io/temporary_folder.h"

namespace offing::terrain {
namespace {

constexpr const char* default_device = "OFFING_SHAPE=strip OFFING_DEVICE=portable";

class TerrainCrossDeviceTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string text_of(const std::string& name) const {
    std::ifstream file(path(name));
    return {std::istreambuf_iterator<char>(file), {}};
  }
  static bool has(const std::string& command) {
    return std::system((command + " > /dev/null 2>&1").c_str()) == 0;
  }

  // A program cache of its own, so that kernels are compiled by the device at hand.
  std::vector<float> dump(const std::string& prefix) const {
    const std::string command = "OFFING_CACHE_DIR=" + path("cache") + " " + prefix + " " +
                                OFFING_GROUND_DUMP + " " + path("dump") + " > " + path("output") + " 2>&1";
    EXPECT_EQ(std::system(command.c_str()), 0) << prefix << "\n" << text_of("output");
    std::ifstream file(path("dump"), std::ios::binary);
    std::vector<float> values;
    for (float value = 0.0f; file.read(reinterpret_cast<char*>(&value), sizeof(value));) {
      values.push_back(value);
    }
    return values;
  }

  // Roots and exponentials of two implementations differ by ulps: 1e-3 cells (10 m) of distance and 1/255 of
  // light are promised. A ray that grazes a ridge may differ by all there is, its distance or its light: of
  // 7,469 values three. Measured: none.
  static void expect_same(const std::vector<float>& found, const std::vector<float>& expected) {
    ASSERT_EQ(found.size(), expected.size());
    ASSERT_FALSE(expected.empty());
    std::size_t unlike = 0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      unlike += std::abs(found[i] - expected[i]) <= 1e-3f + 1e-4f * std::abs(expected[i]) ? 0 : 1;
    }
    EXPECT_LE(unlike, 3u) << "of " << expected.size();
  }

  TemporaryFolder folder_;
};

// Fails if a kernel relies on what one driver does, such as its mathematics, its rounding or its vectors.
TEST_F(TerrainCrossDeviceTest, ShapesAndRusticlFindTheSameGround) {
  const std::vector<float> expected = dump(default_device);
  expect_same(dump("OFFING_SHAPE=group OFFING_DEVICE=portable"), expected);
  if (!has("test -e /etc/OpenCL/vendors/rusticl.icd")) {
    GTEST_SKIP() << "rusticl is not installed (mesa-opencl-icd libclc-15 libllvmspirvlib15)";
  }
  expect_same(dump("RUSTICL_ENABLE=llvmpipe OFFING_DEVICE=rusticl OFFING_SHAPE=group"), expected);
}

// Fails if a work-item reads or writes outside a buffer, if two race for a place, or if results differ from
// those of a real device.
TEST_F(TerrainCrossDeviceTest, OclgrindReportsNothing) {
  if (!has("command -v oclgrind")) GTEST_SKIP() << "oclgrind is not installed";
  const std::vector<float> expected = dump(default_device);
  for (const std::string shape : {"group", "strip"}) {
    // Oclgrind 21.10 compiles the builtin prefetch, and does not know it when it runs.
    expect_same(dump("OFFING_SHAPE=" + shape +
                     " oclgrind --build-options -DFFT_NO_PREFETCH --data-races --log " + path("log")),
                expected);
    EXPECT_EQ(text_of("log"), "") << shape;
  }
}

}  // namespace
}  // namespace offing::terrain

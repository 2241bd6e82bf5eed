#include "host/ocl/self_test.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "host/ocl/disk_cache.h"
#include "tests/ocl/test_kernels.h"

namespace offing::ocl {
namespace {

class SelfTestTest : public ::testing::Test {
 protected:
  SelfTestTest() { kernels_.write("one.cl", "__kernel void one(__global float *out) { out[0] = 1.0f; }"); }

  bool passes(bool result, const Defines& defines = {}) {
    const ProgramRecipe program{"one.cl", defines};
    return passes_self_test(device_, std::span(&program, 1), [&] {
      ++runs_;
      return result;
    });
  }

  // A cache of its own for each test.
  test::TestKernels kernels_;
  Device device_ = Device::open();
  int runs_ = 0;
};

// Fails if a test runs at each start, or if its result is lost or turned round.
TEST_F(SelfTestTest, RunsOnce) {
  EXPECT_TRUE(passes(true));
  EXPECT_TRUE(passes(false));
  EXPECT_EQ(runs_, 1);
  EXPECT_FALSE(passes(false, Defines().set("A", 1)));
  EXPECT_FALSE(passes(true, Defines().set("A", 1)));
  EXPECT_EQ(runs_, 2);
}

// Fails if the result of another text is taken: an edit, or a newer version of Offing.
TEST_F(SelfTestTest, RunsAgainForAnotherText) {
  EXPECT_FALSE(passes(false));
  kernels_.write("one.cl", "__kernel void one(__global float *out) { out[0] = 2.0f; }");
  EXPECT_TRUE(passes(true));
  EXPECT_EQ(runs_, 2);
}

// Fails if results are not kept beside the programs, for the next process: a copy of the folder under another
// name has them.
TEST_F(SelfTestTest, KeepsItsResultWithThePrograms) {
  EXPECT_FALSE(passes(false));
  const TemporaryFolder other;
  std::filesystem::copy(kernels_.cache().path(), other.path(), std::filesystem::copy_options::recursive);
  const test::ScopedEnvironment cache("OFFING_CACHE_DIR", other.path().string());
  EXPECT_FALSE(passes(true));
  EXPECT_EQ(runs_, 1);
}

}  // namespace
}  // namespace offing::ocl

// The transforms of every size and family on other OpenCL implementations, in processes of their own: drivers
// read their environment once.
#include <cstdlib>
#include <string>

#include <gtest/gtest.h>

#include "tests/io/temporary_folder.h"
#include "tests/ocl/other_devices.h"

namespace offing::fft {
namespace {

// Fails if a transform of 16 ... 4096 on Intel's runtime, in either family, is farther from the reference in
// double precision than those of PoCL may be.
TEST(FftCrossDevice, IntelKeepsTheBoundOfPocl) {
  const test::OtherDevice intel = test::intel();
  if (!intel.is_installed()) GTEST_SKIP() << intel.missing;
  const TemporaryFolder cache;
  const std::string command = intel.prefix() + "OFFING_CACHE_DIR=" + cache.path().string() + " " +
                              OFFING_FFT_TEST + " --gtest_filter='Sizes/Fft2dReferenceTest.*'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

}  // namespace
}  // namespace offing::fft

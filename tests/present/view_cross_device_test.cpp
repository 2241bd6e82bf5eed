// The same picture from another OpenCL implementation, in processes of their own: drivers read their
// environment once.
#include <cstdlib>
#include <filesystem>

#include <gtest/gtest.h>

#include "host/io/png_image.h"
#include "tests/cli/offing_program.h"
#include "tests/present/picture_difference.h"

namespace offing::test {
namespace {

// Fails if a scene looks different where another driver computes it: mean difference below 1/255. Measured:
// 8e-5 of a byte's step, from foam at the edge of a threshold.
TEST(ViewCrossDeviceTest, RusticlMakesTheSamePicture) {
  if (!std::filesystem::exists("/etc/OpenCL/vendors/rusticl.icd")) {
    GTEST_SKIP() << "rusticl is not installed (mesa-opencl-icd libclc-15 libllvmspirvlib15)";
  }
  const TemporaryFolder folder;
  const auto picture = [&](const char* device, const char* name) {
    const std::string path = (folder.path() / name).string();
    const ProgramResult result = run_offing({OFFING_SCENES "/rough.toml", "--headless", "--size", "320x180",
                                             "--time", "8", "--device", device, "-o", path});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return read_png(path);
  };
  setenv("RUSTICL_ENABLE", "llvmpipe", 1);
  EXPECT_LT(mean_difference(picture("rusticl", "rusticl.png"), picture("portable", "pocl.png")), 1.0);
}

}  // namespace
}  // namespace offing::test

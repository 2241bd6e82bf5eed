// The same picture from another OpenCL implementation, in processes of their own: drivers read their
// environment once.
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "host/io/png_image.h"
#include "tests/cli/offing_program.h"
#include "tests/present/picture_difference.h"

namespace offing::test {
namespace {

class ViewCrossDeviceTest : public testing::Test {
 protected:
  void SetUp() override {
    if (!std::filesystem::exists("/etc/OpenCL/vendors/rusticl.icd")) {
      GTEST_SKIP() << "rusticl is not installed (mesa-opencl-icd libclc-15 libllvmspirvlib15)";
    }
    setenv("RUSTICL_ENABLE", "llvmpipe", 1);
  }

  std::string path(const char* name) const { return (folder_.path() / name).string(); }

  /// Steps of a byte between the pictures of both drivers, in the mean.
  double difference(const std::string& scene) const {
    const auto picture = [&](const char* device, const char* name) {
      const ProgramResult result = run_offing(
          {scene, "--headless", "--size", "320x180", "--time", "8", "--device", device, "-o", path(name)});
      EXPECT_EQ(result.exit_code, 0) << result.errors;
      return read_png(path(name));
    };
    return mean_difference(picture("rusticl", "rusticl.png"), picture("portable", "pocl.png"));
  }

  const TemporaryFolder folder_;
};

// Fails if a scene looks different where another driver computes it: mean difference below 1/255. Measured:
// 8e-5 of a byte's step, from foam at the edge of a threshold.
TEST_F(ViewCrossDeviceTest, RusticlMakesTheSamePicture) {
  EXPECT_LT(difference(OFFING_SCENES "/rough.toml"), 1.0);
}

// Fails if clouds do: one of each modelling, the nearer one in the shadow of the other. Measured: 3e-3 of a
// byte's step.
TEST_F(ViewCrossDeviceTest, RusticlMakesTheSameClouds) {
  const std::string scene = path("clouds.toml");
  std::ofstream(scene) << "version = 1\n[sun]\nazimuth_deg = 20\nelevation_deg = 12\n"
                          "[camera]\ny_m = 250\nz_m = 2500\npitch_deg = 17\n[ocean]\n"
                          "[[cloud]]\ngenus = \"cumulus\"\ny_m = 650\n"
                          "[[cloud]]\ngenus = \"altocumulus\"\nx_m = 700\ny_m = 1100\nz_m = -2000\n";
  EXPECT_LT(difference(scene), 1.0);
}

}  // namespace
}  // namespace offing::test

// Transforms on a device that computes them wrong: kernels with a fault stand for its compiler.
#include "host/fft/sound_family.h"

#include <cmath>
#include <complex>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/fft/fft2d.h"
#include "host/ocl/tuning.h"
#include "tests/ocl/expect_error.h"
#include "tests/ocl/log_capture.h"
#include "tests/ocl/scoped_environment.h"
#include "tests/ocl/test_kernels.h"

namespace offing::fft {
namespace {

class SoundFamilyTest : public testing::Test {
 protected:
  // The transform of a wave e^{-2 pi i (3 z + 5 x) / n} is n^2 at (3, 5) and 0 elsewhere: the largest error,
  // over n^2.
  double error_of_a_wave(int size) {
    Fft2d fft(device_, size, 1, Direction::inverse);
    std::vector<float> values;
    for (int z = 0; z < size; ++z) {
      for (int x = 0; x < size; ++x) {
        const auto value = std::polar(1.0, -2.0 * M_PI * ((3 * z + 5 * x) % size) / size);
        values.push_back(static_cast<float>(value.real()));
        values.push_back(static_cast<float>(value.imag()));
      }
    }
    ocl::Buffer<float> buffer(device_, values, "wave");
    fft.transform(buffer, buffer);
    values = buffer.read();
    const auto peak = static_cast<std::size_t>(3 * size + 5) * 2;
    const double whole = static_cast<double>(size) * size;
    values[peak] -= static_cast<float>(whole);
    double worst = 0.0;
    for (const float value : values) worst = std::max(worst, std::abs(value) / whole);
    return worst;
  }

  bool prefers_simd() const {
    return ocl::tuning_for(device_.info(), "fft_rows").shape == ocl::KernelShape::simd;
  }
  // The device's own family and the other one.
  std::pair<std::string, std::string> families() const {
    return prefers_simd() ? std::pair("simd", "workgroup") : std::pair("workgroup", "simd");
  }

  const test::ScopedEnvironment own_shape_{"OFFING_SHAPE", ""};
  test::TestKernels kernels_;
  test::LogCapture log_;
  ocl::Device device_ = ocl::Device::open();
};

// Fails if a device that gets one family wrong still uses it, or does not say so.
TEST_F(SoundFamilyTest, TakesTheOtherFamilyWhereOneIsWrong) {
  if (prefers_simd()) {
    kernels_.change("fft/rows.clh", "transpose_lanes(im);", "");
  } else {
    kernels_.change("fft/workgroup_stages.clh", "table[q * turn],", "table[q * turn] * 1.01f,");
  }
  EXPECT_LT(error_of_a_wave(64), 1e-5);
  const auto [first, second] = families();
  EXPECT_THAT(log_.text(),
              testing::HasSubstr(fmt::format("computes {} transforms of size 64 wrongly: using {} transforms",
                                             first, second)));
  EXPECT_EQ(log_.lines(), 1u);
}

// Fails if wrong values are given out where both families are wrong.
TEST_F(SoundFamilyTest, RefusesADeviceThatGetsBothWrong) {
  kernels_.change("fft/butterflies.clh", "re[1] = difference_re + turned_re;", "re[1] = difference_re;");
  const auto [first, second] = families();
  const std::string hint =
      test::expect_error(ErrorKind::device, fmt::format("{} and {} transforms of size 64", first, second),
                         [&] { error_of_a_wave(64); });
  EXPECT_NE(hint.find("--device"), std::string::npos);
}

// Fails if a family that OFFING_SHAPE asks for is replaced without a word: tests would test the other one.
TEST_F(SoundFamilyTest, KeepsToTheShapeThatIsAskedFor) {
  kernels_.change("fft/rows.clh", "transpose_lanes(im);", "");
  const test::ScopedEnvironment shape("OFFING_SHAPE", "simd");
  test::expect_error(ErrorKind::device, ": simd transforms of size 64", [&] { error_of_a_wave(64); });
}

// Fails if a fault shows only in some values and passes: the twiddle of one work-item is off by 1 %.
TEST_F(SoundFamilyTest, FindsASmallFault) {
  kernels_.change("fft/workgroup_stages.clh", "table[q * turn],",
                  "table[q * turn] * (turn == 1 && q == 7 ? 1.01f : 1.0f),");
  test::expect_error(ErrorKind::device, ": workgroup transforms of size 16", [&] { error_of_a_wave(16); });
}

// Fails if kernels that are right are reported.
TEST_F(SoundFamilyTest, SaysNothingOfASoundDevice) {
  EXPECT_LT(error_of_a_wave(16), 1e-5);
  EXPECT_EQ(log_.lines(), 0u) << log_.text();
}

}  // namespace
}  // namespace offing::fft

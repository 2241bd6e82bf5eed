// Slopes that averaging hides, against averages of a drawn sea, and the measured slopes of the sea.
#include "host/ocean/spectrum/slope_covariance.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/ocean.h"

namespace offing::ocean {
namespace {

constexpr int size = 128;
constexpr double patch_m = 200.0;

SlopeCovariance variance_of(const std::vector<float>& x, const std::vector<float>& z) {
  SlopeCovariance sum;
  for (std::size_t i = 0; i < x.size(); ++i) {
    sum.xx += static_cast<double>(x[i]) * x[i];
    sum.xz += static_cast<double>(x[i]) * z[i];
    sum.zz += static_cast<double>(z[i]) * z[i];
  }
  const auto count = static_cast<double>(x.size());
  return {sum.xx / count, sum.xz / count, sum.zz / count};
}

// Means of 2 x 2 texels, as the next mip level holds them.
std::vector<float> halved(const std::vector<float>& texels) {
  const auto n = static_cast<std::size_t>(std::lround(std::sqrt(static_cast<double>(texels.size()))));
  std::vector<float> half;
  for (std::size_t row = 0; row < n; row += 2) {
    for (std::size_t column = 0; column < n; column += 2) {
      const float* texel = &texels[row * n + column];
      half.push_back(0.25f * (texel[0] + texel[1] + texel[n] + texel[n + 1]));
    }
  }
  return half;
}

// Fails if a level is told to hide more or less than it does: the mean over 24 seas of what is left at each
// level of their slope maps, against the expectation. The variance over a patch of some hundred waves along
// the wind scatters by about 10 %, its mean over 24 seas by 2 %; gate 8 % of all slopes, four deviations.
TEST(HiddenSlopes, AreWhatMipLevelsHide) {
  SpectrumParameters wind;
  wind.wind_speed_mps = 7.0;
  wind.fetch_m = 20e3;
  wind.spreading.direction_rad = 0.6;
  OceanParameters parameters{.size = size, .cascades = {{patch_m, 0.0, 2.0}}};
  Ocean ocean(ocl::Device::open(), make_sea_spectrum(wind), parameters);
  const std::vector<SlopeCovariance> hidden = hidden_slopes(ocean.mode_variance(0), size, patch_m);
  ASSERT_EQ(hidden.size(), 8u);
  EXPECT_EQ(hidden.front().mean_square(), 0.0);
  const SlopeCovariance all = hidden.back();
  std::vector<SlopeCovariance> left(hidden.size());
  constexpr int seas = 24;
  for (int sea = 0; sea < seas; ++sea) {
    ocean.reseed(static_cast<std::uint64_t>(sea), {});
    ocean.at(10.0 * sea);
    SurfaceFields fields = ocean.read_surface(0);
    for (std::size_t i = 0; i < left.size(); ++i) {
      if (i > 0) {
        fields.slope_x = halved(fields.slope_x);
        fields.slope_z = halved(fields.slope_z);
      }
      const SlopeCovariance found = variance_of(fields.slope_x, fields.slope_z);
      left[i].xx += found.xx / seas;
      left[i].xz += found.xz / seas;
      left[i].zz += found.zz / seas;
    }
  }
  for (std::size_t i = 0; i < left.size(); ++i) {
    EXPECT_NEAR(left[i].xx, all.xx - hidden[i].xx, 0.08 * all.mean_square()) << "level " << i;
    EXPECT_NEAR(left[i].xz, all.xz - hidden[i].xz, 0.08 * all.mean_square()) << "level " << i;
    EXPECT_NEAR(left[i].zz, all.zz - hidden[i].zz, 0.08 * all.mean_square()) << "level " << i;
  }
}

// Fails if one wave is averaged by another factor than sin(w phi) / (w sin(phi)) an axis, or its direction is
// lost.
TEST(HiddenSlopes, OfOneWaveFollowTheMean) {
  std::vector<float> variance(size * size, 0.0f);
  variance[(size - 5) * size + 9] = 0.5f;  // K = (9, -5) steps
  const double step = 2.0 * std::numbers::pi / patch_m, kx = 9 * step, kz = -5 * step;
  const auto kept = [](int wave, int width) {
    double cosine = 0.0, sine = 0.0;
    for (int i = 0; i < width; ++i) {
      cosine += std::cos(2.0 * std::numbers::pi * wave * i / size) / width;
      sine += std::sin(2.0 * std::numbers::pi * wave * i / size) / width;
    }
    return cosine * cosine + sine * sine;
  };
  const std::vector<SlopeCovariance> hidden = hidden_slopes(variance, size, patch_m);
  for (std::size_t level = 0; level < hidden.size(); ++level) {
    const double lost = 0.5 * (1.0 - kept(9, 1 << level) * kept(5, 1 << level));
    EXPECT_NEAR(hidden[level].xx, kx * kx * lost, 1e-12);
    EXPECT_NEAR(hidden[level].xz, kx * kz * lost, 1e-12);
    EXPECT_NEAR(hidden[level].zz, kz * kz * lost, 1e-12);
  }
}

TEST(HiddenSlopes, RefuseAnArrayOfAnotherSize) {
  EXPECT_THROW(hidden_slopes(std::vector<float>(17), 16, 10.0), Error);
}

// Fails if the law is misread: mean square slope 0.003 + 0.00508 U, larger along the wind.
TEST(MeasuredSlopes, FollowTheWind) {
  const SlopeCovariance east = measured_slopes({10.0, 0.0});
  EXPECT_NEAR(east.mean_square(), 0.003 + 0.00508 * 10.0, 1e-12);
  EXPECT_NEAR(east.xx, 0.0316, 1e-12);
  EXPECT_NEAR(east.xz, 0.0, 1e-12);
  const SlopeCovariance diagonal = measured_slopes({10.0, std::numbers::pi / 4.0});
  EXPECT_NEAR(diagonal.xx, diagonal.zz, 1e-12);
  EXPECT_GT(diagonal.xz, 0.0);
}

// Fails if what remains is more than all, or no covariance where the model is steeper than the sea.
TEST(RemainingSlopes, StayACovariance) {
  const SlopeCovariance all = measured_slopes({10.0, 0.3});
  const SlopeCovariance some{.xx = 0.01, .xz = 0.0, .zz = 0.01};
  EXPECT_NEAR(remaining_slopes(all, some).mean_square(), all.mean_square() - 0.02, 1e-12);
  const SlopeCovariance least = remaining_slopes(all, {.xx = 1.0, .xz = 0.2, .zz = 1.0});
  EXPECT_NEAR(least.mean_square(), 0.1 * all.mean_square(), 1e-12);
  EXPECT_GT(least.xx * least.zz, least.xz * least.xz);
}

}  // namespace
}  // namespace offing::ocean

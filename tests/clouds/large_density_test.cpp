// What a large volume costs: 3,000 balls in 512^3 cells, with five octaves of noise.
#include <random>

#include <gtest/gtest.h>
#include <sys/resource.h>

#include "host/clouds/shape/cloud_density.h"

namespace offing::clouds {
namespace {

double seconds_of(const timeval& time) {
  return static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_usec);
}

/// Of this process on all cores.
double cpu_seconds() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return seconds_of(usage.ru_utime) + seconds_of(usage.ru_stime);
}

// Fails if balls are looked at in cells that they do not reach, or bricks without density computed. Asked
// for: 3 s on two cores and 4 GB. Time counts on the processor, so that other programs beside do not matter:
// 5 s; measured 2.9 to 3.5 s beside a dozen of them, of 217,000 bricks nearly all with density, and 0.6 GB.
TEST(LargeDensityTest, TakesThreeSecondsOnTwoCores) {
  const ocl::Device device = ocl::Device::open();
  CloudParameters parameters;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  for (int i = 0; i < 3000; ++i) {
    const double radius_m = 10.0 + 30.0 * uniform(random);
    const auto place_m = [&] { return radius_m + (511.0 - 2.0 * radius_m) * uniform(random); };
    const double x_m = place_m(), y_m = place_m(), z_m = place_m();
    parameters.balls.push_back({{x_m, y_m, z_m}, radius_m, 1.0});
  }
  parameters.turbulence.wavelength_m = 100.0;
  field_volume(device, parameters, 64.0, 0.0);  // compiles
  const double before_s = cpu_seconds();
  const CloudVolume volume = field_volume(device, parameters, 1.0, 0.0);
  EXPECT_LT(cpu_seconds() - before_s, 5.0);
  EXPECT_EQ(volume.brick_of.size(), 64u * 64u * 64u);
  EXPECT_GT(volume.density.size() / CloudVolume::cells_of_brick, 200'000u);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  EXPECT_LT(static_cast<double>(usage.ru_maxrss) * 1024.0, 4e9);
}

}  // namespace
}  // namespace offing::clouds

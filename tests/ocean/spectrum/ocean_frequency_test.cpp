// Frequencies of the waves against the dispersion relation.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "tests/ocean/surface/drawn_modes.h"
#include "tests/ocean/surface/field_statistics.h"
#include "tests/ocean/surface/ocean_reference.h"

namespace offing::ocean {
namespace {

constexpr double gate = 1e-6;  // as in ocean_reference_test.cpp

// Fails if frequencies are rounded more coarsely than stated: each is within 2^-28 Hz of the dispersion
// relation, so that waves are late by at most 2 pi 2^-28 t rad, uniformly distributed: 1/sqrt(3) of that in
// the mean square, 8.1e-6 at t = 600 s, 0.1 s of a wave's time in four months.
TEST(OceanFrequencyTest, FollowTheDispersionRelation) {
  const SeaSpectrum spectrum = make_sea_spectrum({});
  const OceanParameters parameters{.size = 256, .cascades = cascades_from_patches(std::vector{200.0}, 256)};
  Ocean sea(ocl::Device::open(), spectrum, parameters);
  const OceanReference reference(spectrum.dispersion, parameters, {sea.mode_variance(0)});
  for (const double time_s : {0.0, 20.0, 600.0}) {
    sea.at(time_s);
    const double late_rad = 2.0 * std::numbers::pi * 0x1p-28 * time_s / std::sqrt(3.0);
    EXPECT_LT(relative_error(sea.read_surface(0).displacement_y,
                             reference.surface(0, time_s, Frequencies::exact).displacement_y),
              gate + 2.0 * late_rad)
        << time_s;
  }
}

// Fails if waves faster than the usual 32 ticks a second are slowed down to 32 Hz, or turned round: ripples
// of 2 mm, 240 Hz, on a patch of 2 cm. Looked at by horizontal displacement and velocity: the height of such
// waves is 1000 times smaller than the gradient that shares its transform, which costs it two bits.
TEST(OceanFrequencyTest, RipplesKeepTheirFrequency) {
  SpectrumParameters breeze;
  breeze.wind_speed_mps = 2.0;
  breeze.fetch_m = 100.0;
  breeze.dispersion.capillary_length_m = 2.73e-3;
  const SeaSpectrum spectrum = make_sea_spectrum(breeze);
  const OceanParameters parameters{.size = 16, .cascades = {{0.02, 0.0, 1e9}}};
  Ocean sea(ocl::Device::open(), spectrum, parameters);
  const OceanReference reference(spectrum.dispersion, parameters, {sea.mode_variance(0)});
  EXPECT_GT(reference.fastest_hz(), 200.0);
  for (const double time_s : {0.0, 0.01, 8.3, 1e4}) {
    sea.at(time_s);
    EXPECT_LT(relative_error(sea.read_surface(0).displacement_x,
                             reference.surface(0, time_s, Frequencies::of_clock).displacement_x),
              gate)
        << time_s;
    EXPECT_LT(
        relative_error(sea.read_velocity(0).y, reference.velocity(0, time_s, 0.0, Frequencies::of_clock).y),
        gate)
        << time_s;
  }
}

// Fails if any wave of the smallest patches is further from the dispersion relation than half a step of the
// clock, or shares the clock's last rate with faster ones.
TEST(OceanFrequencyTest, NoPatchIsTooSmallForTheClock) {
  SpectrumParameters breeze;
  breeze.dispersion.capillary_length_m = 2.73e-3;
  const SeaSpectrum spectrum = make_sea_spectrum(breeze);
  const ocl::Device device = ocl::Device::open();
  for (const double patch_length_m : {0.01, 0.5, 2.0}) {
    constexpr int size = 512;
    const WaveModes modes(device, spectrum, std::vector{Cascade{patch_length_m, 0.0, 1e9}}, size, {});
    const std::vector<std::uint32_t> rates = drawn_rates(modes, 0);
    double worst = 0.0;
    for (int row = 0; row < size / 2; ++row) {
      for (int column = row == 0 ? 1 : 0; column < size / 2; ++column) {
        const double omega_radps = spectrum.dispersion.omega_radps(2.0 * std::numbers::pi / patch_length_m *
                                                                   std::hypot(column, row));
        const double rate = rates[static_cast<std::size_t>(row * size + column)];
        worst = std::max(worst, std::abs(rate - omega_radps / modes.clock().radps_per_rate()));
      }
    }
    EXPECT_LE(worst, 0.5 + 1e-6) << patch_length_m;
  }
}

}  // namespace
}  // namespace offing::ocean

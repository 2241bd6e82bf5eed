#include "host/ocean/surface/mode_lattice.h"

#include <cmath>
#include <memory>
#include <numeric>
#include <vector>

#include <gtest/gtest.h>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/ocean.h"
#include "tests/ocl/expect_error.h"

namespace offing::ocean {
namespace {

constexpr double time_s = 1234.5;

class ModeLattice : public testing::Test {
 protected:
  OceanParameters parameters() const {
    OceanParameters parameters{
        .size = 32, .cascades = cascades_from_patches(std::vector{200.0, 30.0}, 32), .seed = 7};
    parameters.choppiness = 0.8;
    parameters.gerstner_waves.waves = {
        make_swell({.amplitude_m = 0.7, .wavelength_m = 90.0, .direction_rad = 2.0}, {})};
    return parameters;
  }
  Ocean sea(const OceanParameters& wanted) const { return Ocean(device_, spectrum_, wanted); }

  ocl::Device device_ = ocl::Device::open();
  SeaSpectrum spectrum_ = make_sea_spectrum({});
  // Root of the variance that both patches hold, m.
  double scale_m_ = std::sqrt(integrate_sea_state(spectrum_).m0_m2);
};

struct Displacement {
  double x = 0.0, y = 0.0, z = 0.0;
};

/// The definition of SeaMode and ModalSea, summed.
Displacement sum_of(const ModalSea& sea, int patch, double x_m, double z_m) {
  Displacement sum;
  for (const SeaMode& mode : sea.modes) {
    if (mode.patch != patch) continue;
    const double p = mode.kx_radpm * x_m + mode.kz_radpm * z_m - mode.omega_radps * time_s + mode.phase_rad;
    const double sideways =
        -sea.choppiness * mode.amplitude_m * std::sin(p) / std::hypot(mode.kx_radpm, mode.kz_radpm);
    sum.x += mode.kx_radpm * sideways;
    sum.y += mode.amplitude_m * std::cos(p);
    sum.z += mode.kz_radpm * sideways;
  }
  return sum;
}

// Fails if an amplitude, a phase, a wavenumber, a frequency or a sign of the list is not that of the surface,
// or a wave is missing. The device sums in floats: bound 1e-5 of the height's deviation. Measured below.
TEST_F(ModeLattice, ListsTheWavesOfTheSurface) {
  Ocean ocean = sea(parameters());
  ocean.at(time_s);
  const ModalSea modes = ocean.modes();
  double worst_m = 0.0;
  for (int patch = 0; patch < 2; ++patch) {
    const SurfaceFields surface = ocean.read_surface(patch);
    const double step_m = modes.patch_lengths_m[static_cast<std::size_t>(patch)] / surface.size;
    for (int i = 0; i < surface.size * surface.size; i += 37) {
      const Displacement sum = sum_of(modes, patch, i % surface.size * step_m, i / surface.size * step_m);
      worst_m = std::max({worst_m, std::abs(sum.x - surface.displacement_x[i]),
                          std::abs(sum.y - surface.displacement_y[i]),
                          std::abs(sum.z - surface.displacement_z[i])});
    }
  }
  EXPECT_LT(worst_m, 1e-5 * scale_m_);
  ASSERT_EQ(modes.modes.back().patch, SeaMode::alone);
  EXPECT_EQ(modes.modes.back().amplitude_m, 0.7);
}

// Fails if a sea of given waves is another one than they are listed from, at another time or after another
// seed, or its variances are those of the spectrum. Only the rounding of amplitudes to floats differs: 1e-6.
TEST_F(ModeLattice, MakesTheSameSeaAgain) {
  Ocean drawn = sea(parameters());
  OceanParameters given = parameters();
  given.modes = std::make_shared<const ModalSea>(drawn.modes());
  given.seed = 99;
  Ocean again = sea(given);
  again.reseed(5, given.gerstner_waves);
  drawn.at(time_s);
  again.at(time_s);
  for (int patch = 0; patch < 2; ++patch) {
    const SurfaceFields a = drawn.read_surface(patch), b = again.read_surface(patch);
    for (std::size_t i = 0; i < a.displacement_y.size(); ++i) {
      ASSERT_NEAR(a.displacement_y[i], b.displacement_y[i], 1e-6 * scale_m_);
      ASSERT_NEAR(a.displacement_x[i], b.displacement_x[i], 1e-6 * scale_m_);
    }
    const std::vector<float> variance = again.mode_variance(patch);
    double expected_m2 = 0.0;
    for (const SeaMode& mode : given.modes->modes) {
      expected_m2 += mode.patch == patch ? 0.5 * mode.amplitude_m * mode.amplitude_m : 0.0;
    }
    EXPECT_NEAR(std::accumulate(variance.begin(), variance.end(), 0.0), expected_m2, 1e-5 * expected_m2);
  }
}

// Fails if one frequency takes the place of two that a pair of opposite waves has, or a frequency overflows.
TEST_F(ModeLattice, RefusesFrequenciesThatItCannotKeep) {
  const double k_radpm = 2.0 * 3.141592653589793 / 200.0;
  const auto expect_refused = [&](const char* message, double omega_radps, double opposite_radps) {
    OceanParameters given = parameters();
    given.modes = std::make_shared<const ModalSea>(ModalSea{
        .modes = {{.amplitude_m = 1.0, .kx_radpm = k_radpm, .omega_radps = omega_radps, .patch = 0},
                  {.amplitude_m = 1.0, .kx_radpm = -k_radpm, .omega_radps = opposite_radps, .patch = 0}},
        .patch_lengths_m = {200.0, 30.0},
        .size = 32});
    test::expect_error(ErrorKind::bad_input, message, [&] { sea(given); });
  };
  expect_refused("expected one omega for waves that run against each other", 0.5, 0.6);
  expect_refused("expected an omega of water waves, got 1e+06 rad/s", 1e6, 1e6);
}

}  // namespace
}  // namespace offing::ocean

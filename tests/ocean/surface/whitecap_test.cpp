// Foam covers as much of the sea as whitecaps do, in each cascade's map and on the composed surface.
#include <cmath>
#include <cstdio>
#include <numbers>
#include <numeric>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/ocean/query/gerstner_instant.h"
#include "host/ocean/spectrum/fetch_laws.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/gerstner_choice.h"
#include "host/ocean/surface/ocean.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

double mean_of(const std::vector<float>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Monahan and O'Muircheartaigh 1980, Callaghan and others 2008.
double law_of_strong_winds(double wind_mps) {
  return 3.84e-6 * std::pow(wind_mps, 3.41);
}
double law_of_light_winds(double wind_mps) {
  return 3.18e-5 * std::pow(std::max(wind_mps - 3.7, 0.0), 3.0);
}

SpectrumParameters sea_of_wind(double wind_mps, double fetch_m) {
  SpectrumParameters sea;
  sea.wind_speed_mps = wind_mps;
  sea.fetch_m = fetch_m;
  return sea;
}

/// Wind and fetch that raise a sea of this height and period (fetch_laws.h).
SpectrumParameters sea_of_height(double hs_m, double peak_period_s) {
  constexpr double gravity_mps2 = 9.81;
  const double wind_mps = wind_of_height_and_period_mps(hs_m, peak_period_s, gravity_mps2);
  const double omega_radps = 2.0 * pi / peak_period_s;
  const double x = std::pow(22.0 * gravity_mps2 / (omega_radps * wind_mps), 3.0);
  return sea_of_wind(wind_mps, x * wind_mps * wind_mps / gravity_mps2);
}

class WhitecapTest : public testing::Test {
 protected:
  struct Fractions {
    double maps = 0.0;      ///< of all cascades' maps together
    double composed = 0.0;  ///< of the surface
    double composed_with_gerstner_waves = 0.0;
  };

  OceanParameters parameters(const SeaSpectrum& spectrum, double fraction, double split_radpm) const {
    constexpr int size = 128;
    return {.size = size,
            .cascades = choose_cascades(spectrum, size, 3, split_radpm),
            .foam = {.fraction = fraction}};
  }

  /// Adds the means over seeds and times, with waves longer than the split as Gerstner waves.
  template <class Take>
  void measure(const SeaSpectrum& spectrum, double fraction, double split_radpm, int seeds, int times,
               Take take) {
    const OceanParameters wanted = parameters(spectrum, fraction, split_radpm);
    Ocean ocean(device_, spectrum, wanted);
    // Labels over two and a half patches, without a common multiple with any of them, and close enough to
    // show Gerstner waves.
    const double spacing_m = 0.618034 / 64 * wanted.cascades.front().patch_length_m;
    const SampleGrid grid{.spacing_x_m = spacing_m, .spacing_z_m = spacing_m, .columns = 256, .rows = 256};
    for (int seed = 1; seed <= seeds; ++seed) {
      const auto number = static_cast<std::uint64_t>(seed);
      GerstnerSea waves;
      if (split_radpm > 0.0) {
        waves.waves =
            choose_gerstner_waves(spectrum, {.split_radpm = split_radpm, .count = 32, .seed = number});
      }
      ocean.reseed(number, waves);
      for (int i = 0; i < times; ++i) {
        ocean.at(100.1 * i);
        double bare = 1.0;
        for (std::size_t c = 0; c < wanted.cascades.size(); ++c) {
          bare *= 1.0 - mean_of(ocean.read_foam(static_cast<int>(c)));
        }
        take((1.0 - bare) / (seeds * times), mean_of(ocean.read_composed_foam(grid)) / (seeds * times));
      }
    }
  }

  Fractions fractions(const SpectrumParameters& sea, double fraction, int seeds, int times) {
    const SeaSpectrum spectrum = make_sea_spectrum(sea);
    Fractions found;
    measure(spectrum, fraction, 0.0, seeds, times, [&](double maps, double composed) {
      found.maps += maps;
      found.composed += composed;
    });
    const double split_radpm = 3.0 * spectrum.dispersion.wavenumber_radpm(spectrum.omega_peak_radps);
    measure(spectrum, fraction, split_radpm, seeds, times,
            [&](double, double composed) { found.composed_with_gerstner_waves += composed; });
    return found;
  }

  /// Whether the sea has the whitecaps of this wind: within a factor of 2 of the strong winds' law from 8 m/s
  /// on, between both laws at 6 m/s, and below 1e-3 at 4 m/s.
  void expect_whitecaps(double found, double wind_mps, const std::string& sea) {
    if (wind_mps >= 8.0) {
      EXPECT_GT(found, 0.5 * law_of_strong_winds(wind_mps)) << sea;
      EXPECT_LT(found, 2.0 * law_of_strong_winds(wind_mps)) << sea;
    } else if (wind_mps >= 6.0) {
      EXPECT_GT(found, law_of_light_winds(wind_mps)) << sea;
      EXPECT_LT(found, law_of_strong_winds(wind_mps)) << sea;
    } else {
      EXPECT_LT(found, 1e-3) << sea;
    }
  }

  void expect_whitecaps(const SpectrumParameters& sea, const std::string& name, int seeds, int times) {
    const double wind_mps = sea.wind_speed_mps, asked = whitecap_fraction(wind_mps);
    const Fractions found = fractions(sea, asked, seeds, times);
    std::printf("| %s | %.1f | %.4g | %.4g | %.4g | %.4g |\n", name.c_str(), wind_mps, 100.0 * asked,
                100.0 * found.maps, 100.0 * found.composed, 100.0 * found.composed_with_gerstner_waves);
    expect_whitecaps(found.maps, wind_mps, name + ", maps");
    expect_whitecaps(found.composed, wind_mps, name + ", composed");
    expect_whitecaps(found.composed_with_gerstner_waves, wind_mps, name + ", with Gerstner waves");
  }

  ocl::Device device_ = ocl::Device::open();
};

// Fails if the laws are others than those of the papers, or do not run into each other.
TEST(WhitecapFractionTest, IsThatOfThePapers) {
  for (const double wind_mps : {8.0, 12.0, 25.0}) {
    EXPECT_NEAR(whitecap_fraction(wind_mps), law_of_strong_winds(wind_mps), 1e-12);
  }
  EXPECT_EQ(whitecap_fraction(3.7), 0.0);
  EXPECT_EQ(whitecap_fraction(0.0), 0.0);
  EXPECT_EQ(whitecap_fraction(60.0), 0.5);
  for (double wind_mps = 3.75; wind_mps < 8.0; wind_mps += 0.05) {
    EXPECT_GE(whitecap_fraction(wind_mps), law_of_light_winds(wind_mps)) << wind_mps;
    EXPECT_LE(whitecap_fraction(wind_mps), law_of_strong_winds(wind_mps)) << wind_mps;
    EXPECT_LT(whitecap_fraction(wind_mps), whitecap_fraction(wind_mps + 0.05)) << wind_mps;
  }
}

// Fails if foam covers another share of the sea than was asked, on maps or the composed surface. Of four seas
// each; the slow test has sixteen.
TEST_F(WhitecapTest, CoverTheirShare) {
  for (const double wind_mps : {4.0, 6.0, 10.0, 25.0}) {
    expect_whitecaps(sea_of_wind(wind_mps, 1e5), fmt::format("{:g} m/s", wind_mps), 2, 2);
  }
}

// The table of docs/ocean.md. Fails as the quick test does.
TEST_F(WhitecapTest, CoverTheirShareInEachSea) {
  for (const double wind_mps : {4.0, 6.0, 8.0, 10.0, 12.0, 15.0, 20.0, 25.0}) {
    expect_whitecaps(sea_of_wind(wind_mps, 1e5), "100 km of fetch", 4, 4);
  }
  for (const auto& [hs_m, tp_s] : {std::pair{1.5, 6.2}, {3.0, 9.0}, {6.0, 12.0}}) {
    expect_whitecaps(sea_of_height(hs_m, tp_s), fmt::format("Hs {:g} m, Tp {:g} s", hs_m, tp_s), 4, 4);
  }
}

// Fails if a sea whose waves are not drawn choppy foams elsewhere than the same sea that is.
TEST_F(WhitecapTest, DoNotNeedChoppiness) {
  const SeaSpectrum spectrum = make_sea_spectrum(sea_of_wind(15.0, 1e5));
  OceanParameters wanted = parameters(spectrum, 0.1, 0.0);
  Ocean choppy(device_, spectrum, wanted);
  wanted.choppiness = 0.0;
  Ocean round(device_, spectrum, wanted);
  EXPECT_EQ(round.read_foam(0), choppy.read_foam(0));
  EXPECT_EQ(round.foam_gathering().front().factor, 1.0);
}

// Fails if waves foam that are too short to draw air under, or long ones do not.
TEST_F(WhitecapTest, AreOfLongWavesAlone) {
  const SeaSpectrum spectrum = make_sea_spectrum(sea_of_wind(15.0, 1e5));
  OceanParameters wanted = parameters(spectrum, 0.1, 0.0);
  wanted.cascades = cascades_from_patches(std::vector{120.0, 1.9}, wanted.size);
  Ocean sea(device_, spectrum, wanted);
  EXPECT_GT(mean_of(sea.read_foam(0)), 0.05);
  EXPECT_EQ(mean_of(sea.read_foam(1)), 0.0);
  wanted.foam.min_wavelength_m = 0.0;
  Ocean rippled(device_, spectrum, wanted);
  EXPECT_GT(mean_of(rippled.read_foam(1)), 1e-3);
}

// Fails if composed foam is not 1 - product of (1 - min(1, factor e^(steepness p) foam)), with p the
// compression by Gerstner waves and longer cascades. Labels are texels of both cascades. Gate 1e-4: the
// Gerstner waves' phases, to 2^-32 turns, and floats that steepness p, up to 5, makes larger.
TEST_F(WhitecapTest, ComposeByTheFormula) {
  const SeaSpectrum spectrum = make_sea_spectrum(sea_of_wind(18.0, 5e4));
  OceanParameters wanted = parameters(spectrum, 0.2, 0.0);
  wanted.size = 64;
  wanted.cascades = cascades_from_patches(std::vector{256.0, 32.0}, wanted.size, 0.1);
  wanted.gerstner_waves.waves = choose_gerstner_waves(spectrum, {.split_radpm = 0.1, .count = 16});
  Ocean sea(device_, spectrum, wanted);
  sea.at(3.3);
  const SampleGrid grid{.spacing_x_m = 4.0, .spacing_z_m = 4.0, .columns = 64, .rows = 64};
  const std::vector<float> composed = sea.read_composed_foam(grid);
  const std::vector<float> longer = sea.read_foam(0), shorter = sea.read_foam(1);
  const SurfaceFields surface = sea.read_surface(0);
  const std::vector<FoamGathering>& gathering = sea.foam_gathering();
  const GerstnerInstant waves(wanted.gerstner_waves, 3.3);
  double most = 0.0;
  for (std::size_t i = 0; i < composed.size(); ++i) {
    const std::size_t column = i % 64, row = i / 64;
    const GerstnerValues values = waves.at(4.0 * static_cast<double>(column), 4.0 * static_cast<double>(row));
    const double p = -(values.gradient_xx + values.gradient_zz);
    const double p_of_both = p - (surface.gradient_xx[i] + surface.gradient_zz[i]);
    const auto gathered = [&](std::size_t cascade, double foam, double compression) {
      return std::min(
          1.0, gathering[cascade].factor * std::exp(gathering[cascade].steepness * compression) * foam);
    };
    const double expected =
        1.0 - (1.0 - gathered(0, longer[i], p)) *
                  (1.0 - gathered(1, shorter[(row * 8 % 64) * 64 + column * 8 % 64], p_of_both));
    ASSERT_NEAR(composed[i], expected, 1e-4) << i;
    most = std::max(most, expected);
  }
  EXPECT_GT(most, 0.9) << "the test sees hardly any foam";
}

}  // namespace
}  // namespace offing::ocean

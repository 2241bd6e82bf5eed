// Seas asked for by height and period.
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/fetch_laws.h"
#include "host/ocean/spectrum/spectrum_parameters.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr double g_mps2 = 9.81;

/// 30 pairs of height and period, from ripples in a bay to a storm at sea, each with a gamma and a depth.
std::vector<SpectrumParameters> thirty_seas(SpectrumModel model) {
  const double periods_s[] = {1.5, 3.0, 5.0, 8.0, 12.0, 18.0};
  const double steepnesses[] = {0.005, 0.01, 0.02, 0.035, 0.05};  // Hs over g Tp^2 / 2 pi
  const double gammas[] = {1.0, 1.5, 2.0, 3.3, 5.0, 7.0};
  const double depths[] = {0.01, 0.03, 0.1, 0.3, 1.0};  // over g Tp^2 / 2 pi
  std::vector<SpectrumParameters> seas;
  for (int i = 0; i < 30; ++i) {
    SpectrumParameters& sea = seas.emplace_back();
    const double tp_s = periods_s[i % 6];
    const double deep_m = g_mps2 * tp_s * tp_s / (2.0 * pi);
    sea.model = model;
    sea.tp_s = tp_s;
    sea.hs_m = steepnesses[i / 6] * deep_m;
    sea.gamma = gammas[(i + i / 6) % 6];
    if (model == SpectrumModel::tma) {
      sea.dispersion.depth_m =
          std::max(depths[(2 * i + i / 6) % 5] * deep_m, 0.1);  // the least that is taken
    }
    sea.depth_factor = i % 2 == 0 ? DepthFactor::thompson_vincent : DepthFactor::kitaigorodskii;
  }
  return seas;
}

/// The frequency of the largest of 40,000 densities, to 1e-4.
double scanned_peak_radps(const SeaSpectrum& spectrum) {
  double best_radps = 0.0, best = 0.0;
  for (double omega_radps = spectrum.omega_min_radps; omega_radps < 30.0 * spectrum.omega_min_radps;
       omega_radps *= 1.0001) {
    if (spectrum.energy(omega_radps) <= best) continue;
    best = spectrum.energy(omega_radps);
    best_radps = omega_radps;
  }
  return best_radps;
}

// Fails if height or peak are not those asked for: where the shallow water's factor moves the peak that the
// formula was given, or takes energy that nobody puts back; or if a density has a second, higher peak.
// Heights are exact but for the quadrature of integrate_sea_state() (bound 1e-5, measured 2e-8, gate 1e-6);
// the scan has steps of 1e-4.
TEST(HeightAndPeriod, AreThoseOfTheSea) {
  for (const SpectrumModel model : {SpectrumModel::jonswap, SpectrumModel::tma}) {
    for (const SpectrumParameters& asked : thirty_seas(model)) {
      const SeaSpectrum spectrum = make_sea_spectrum(asked);
      const SeaState state = integrate_sea_state(spectrum);
      SCOPED_TRACE(testing::Message() << "Hs " << *asked.hs_m << " Tp " << *asked.tp_s << " gamma "
                                      << asked.gamma << " depth " << asked.dispersion.depth_m);
      EXPECT_NEAR(state.hs_m / *asked.hs_m, 1.0, 1e-6);
      EXPECT_NEAR(state.peak_period_s / *asked.tp_s, 1.0, 1e-6);
      EXPECT_NEAR(2.0 * pi / scanned_peak_radps(spectrum) / *asked.tp_s, 1.0, 2e-4);
    }
  }
}

// Fails if the period that is solved for is not the one whose sqrt(m0 / m2) was asked for, in deep water or
// in shallow. Gate as above; m2 of the quadratures agrees to 1e-6.
TEST(HeightAndPeriod, MeanPeriodIsSolvedFor) {
  for (const SpectrumModel model : {SpectrumModel::jonswap, SpectrumModel::tma}) {
    for (SpectrumParameters asked : thirty_seas(model)) {
      asked.tz_s = 0.75 * *asked.tp_s;
      const SeaState state = integrate_sea_state(make_sea_spectrum(asked));
      EXPECT_NEAR(state.tm02_s / *asked.tz_s, 1.0, 2e-6) << *asked.tp_s;
      EXPECT_NEAR(state.hs_m / *asked.hs_m, 1.0, 1e-6);
    }
  }
}

// Fails if a sea by wind and fetch comes out otherwise when it is asked for by its own height and period:
// both ways are one formula.
TEST(HeightAndPeriod, GiveTheSeaOfWindAndFetchBack) {
  SpectrumParameters by_wind;
  by_wind.wind_speed_mps = 14.0;
  by_wind.fetch_m = 120e3;
  by_wind.spreading.wind_speed_mps = 14.0;
  const SeaSpectrum expected = make_sea_spectrum(by_wind);
  SpectrumParameters by_height = by_wind;
  by_height.hs_m = integrate_sea_state(expected).hs_m;
  by_height.tp_s = 2.0 * pi / expected.omega_peak_radps;
  by_height.wind_speed_mps = 3.0;
  by_height.fetch_m = 1e3;
  const SeaSpectrum found = make_sea_spectrum(by_height);
  for (const double omega_radps : {0.5, 0.8, 1.0, 2.0, 9.0}) {
    EXPECT_NEAR(found.density(omega_radps, 0.4) / expected.density(omega_radps, 0.4), 1.0, 1e-5)
        << omega_radps;
  }
}

// Fails if pm has a peak enhancement, no period is not that of a fully developed sea (Pierson and Moskowitz's
// own: their Hs at 10 m/s is 2.133 m, their peak at 7.30 s), or the model swell does not take both.
TEST(HeightAndPeriod, SuitTheOtherModels) {
  SpectrumParameters asked;
  asked.model = SpectrumModel::pierson_moskowitz;
  asked.hs_m = 2.133;
  const SeaSpectrum developed = make_sea_spectrum(asked);
  EXPECT_NEAR(2.0 * pi / developed.omega_peak_radps, 7.30, 0.01);
  SpectrumParameters original;
  original.model = SpectrumModel::pierson_moskowitz;
  const SeaSpectrum expected = make_sea_spectrum(original);
  for (const double omega_radps : {0.7, 0.9, 3.0}) {
    EXPECT_NEAR(developed.energy(omega_radps) / expected.energy(omega_radps), 1.0, 1e-3);
  }

  asked.model = SpectrumModel::swell;
  asked.hs_m = 1.5;
  asked.tp_s = 13.0;
  const SeaState swell = integrate_sea_state(make_sea_spectrum(asked));
  EXPECT_NEAR(swell.hs_m, 1.5, 1e-5);
  EXPECT_NEAR(swell.peak_period_s, 13.0, 1e-5);
  EXPECT_FALSE(is_by_height(asked));
}

// Fails if the wind is not the one whose growth laws give this sea, as printed: m0 = 1.6e-7 x U^4 / g^2 and
// f_peak = 3.5 x^(-1/3) g / U, whose 2 pi 3.5 is 21.99, not 22: gate 0.3 %. Or if the wind of a fully
// developed sea, which the laws do not know, is far from Pierson and Moskowitz's (10 m/s at 10 m make 2.25 m
// and 7.5 s).
TEST(HeightAndPeriod, WindFollowsFromTheFetchLaws) {
  for (const double wind_mps : {4.0, 9.0, 20.0}) {
    for (const double fetch_m : {5e3, 100e3}) {
      const double x = g_mps2 * fetch_m / (wind_mps * wind_mps);
      const double m0_m2 = 1.6e-7 * x * std::pow(wind_mps, 4.0) / (g_mps2 * g_mps2);
      const double peak_hz = 3.5 * std::pow(x, -1.0 / 3.0) * g_mps2 / wind_mps;
      EXPECT_NEAR(wind_of_height_and_period_mps(4.0 * std::sqrt(m0_m2), 1.0 / peak_hz, g_mps2) / wind_mps,
                  1.0, 3e-3);
    }
  }
  EXPECT_NEAR(wind_of_height_and_period_mps(2.25, 7.5, g_mps2), 10.0, 1.5);
  EXPECT_EQ(wind_of_height_and_period_mps(0.5, 40.0, g_mps2), 0.1);
}

// Fails if a swell changes the wind of a sea: gate 5 %, for the tail of the swell under the wind sea's peak.
// Without a swell the wind is that of the sea's own height and period: gate 1 %, for steps of frequency.
TEST(HeightAndPeriod, SwellDoesNotChangeTheWind) {
  SpectrumParameters waves;
  waves.hs_m = 1.2;
  waves.tp_s = 4.5;
  const SeaSpectrum sea = make_sea_spectrum(waves);
  const double wind_mps = wind_of_height_and_period_mps(1.2, 4.5, g_mps2);
  EXPECT_NEAR(wind_of_spectrum_mps(sea) / wind_mps, 1.0, 0.01);

  SpectrumParameters longer = waves;
  longer.model = SpectrumModel::swell;
  longer.hs_m = 3.0;
  longer.tp_s = 14.0;
  const SeaSpectrum swell = make_sea_spectrum(longer);
  EXPECT_LT(wind_of_spectrum_mps(swell), 4.0);
  SeaSpectrum mixed = sea;
  mixed.energy = [&](double omega_radps) { return sea.energy(omega_radps) + swell.energy(omega_radps); };
  mixed.omega_min_radps = std::min(sea.omega_min_radps, swell.omega_min_radps);
  EXPECT_NEAR(wind_of_spectrum_mps(mixed) / wind_mps, 1.0, 0.05);
}

// Fails if a height or period out of range makes a sea.
TEST(HeightAndPeriod, RejectsValuesOutOfRange) {
  for (const double wrong : {0.0, -1.0, 100.0, std::numeric_limits<double>::quiet_NaN()}) {
    SpectrumParameters height, peak, mean;
    height.hs_m = wrong;
    peak.hs_m = mean.hs_m = 1.0;
    peak.tp_s = mean.tz_s = wrong;
    for (const SpectrumParameters& parameters : {height, peak, mean}) {
      EXPECT_THROW(make_sea_spectrum(parameters), Error) << wrong;
    }
  }
}

}  // namespace
}  // namespace offing::ocean

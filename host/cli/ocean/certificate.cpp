#include "host/cli/ocean/certificate.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "host/cli/common/direction_text.h"
#include "host/cli/ocean/surface_meter.h"
#include "host/ocean/surface/ocean.h"

namespace offing::cli {

namespace {

Measured mean_and_spread(const std::vector<double>& values) {
  const double count = static_cast<double>(values.size());
  Measured measured{.mean = std::accumulate(values.begin(), values.end(), 0.0) / count};
  if (values.size() > 1) {
    double squares = 0.0;
    for (const double value : values) {
      squares += (value - measured.mean) * (value - measured.mean);
    }
    measured.spread = std::sqrt(squares / (count - 1.0));
  }
  return measured;
}

/// Directions have no mean as numbers: the mean unit vector's direction, and the scatter around it.
Measured mean_direction(const std::vector<double>& directions_rad) {
  double cosine = 0.0, sine = 0.0;
  for (const double direction : directions_rad) {
    cosine += std::cos(direction);
    sine += std::sin(direction);
  }
  const double mean_rad = std::atan2(sine, cosine);
  std::vector<double> deviations;
  for (const double direction : directions_rad) {
    deviations.push_back(direction_difference_rad(direction, mean_rad));
  }
  return {.mean = mean_rad, .spread = mean_and_spread(deviations).spread};
}

template <class Quantity>
std::vector<double> each(const std::vector<SurfaceMeasurement>& measurements, Quantity quantity) {
  std::vector<double> values;
  for (const SurfaceMeasurement& measurement : measurements) {
    values.push_back(quantity(measurement));
  }
  return values;
}

void summarise(const std::vector<SurfaceMeasurement>& all, Certificate& certificate) {
  using M = SurfaceMeasurement;
  certificate.hs_m = mean_and_spread(each(all, [](const M& m) { return m.state.hs_m; }));
  certificate.tp_s = mean_and_spread(each(all, [](const M& m) { return m.state.tp_s; }));
  certificate.tm01_s = mean_and_spread(each(all, [](const M& m) { return m.state.tm01_s; }));
  certificate.tm02_s = mean_and_spread(each(all, [](const M& m) { return m.state.tm02_s; }));
  certificate.mss = mean_and_spread(each(all, [](const M& m) { return m.state.mss; }));
  certificate.mean_direction_rad =
      mean_direction(each(all, [](const M& m) { return m.state.mean_direction_rad; }));
  certificate.skewness = mean_and_spread(each(all, [](const M& m) { return m.skewness; }));
  certificate.kurtosis = mean_and_spread(each(all, [](const M& m) { return m.kurtosis; }));
  certificate.folded_share = mean_and_spread(each(all, [](const M& m) { return m.folded_share; }));
  for (std::size_t i = 0; i < certificate.energy.cascade_m0_m2.size(); ++i) {
    certificate.measured_cascade_m0_m2.push_back(
        mean_and_spread(each(all, [i](const M& m) { return m.cascade_m0_m2[i]; })).mean);
  }
}

/// What Gerstner waves are expected to be: those of many seeds, each with its share of the energy, and the
/// swells.
std::vector<ocean::GerstnerWave> expected_gerstner_waves(const scene::Sea& sea) {
  std::vector<ocean::GerstnerWave> waves = sea.swells;
  if (!sea.gerstner_choice) return waves;
  constexpr int seeds = 16;
  ocean::GerstnerChoice choice = *sea.gerstner_choice;
  choice.count = 64;
  for (choice.seed = 1; choice.seed <= seeds; ++choice.seed) {
    for (ocean::GerstnerWave wave : ocean::choose_gerstner_waves(sea.spectrum, choice)) {
      wave.amplitude_m /= std::sqrt(seeds);
      waves.push_back(wave);
    }
  }
  return waves;
}

void expect(const ocean::Ocean& sea, const ocean::Dispersion& dispersion,
            const std::vector<ocean::GerstnerWave>& gerstner_waves, Certificate& certificate) {
  const std::vector<ocean::Cascade>& cascades = sea.parameters().cascades;
  std::vector<std::vector<float>> variances;
  std::vector<ocean::ModeEnergies> modes;
  for (std::size_t i = 0; i < cascades.size(); ++i) {
    variances.push_back(sea.mode_variance(static_cast<int>(i)));
    modes.push_back({cascades[i].patch_length_m, sea.parameters().size, variances.back()});
    certificate.expected_cascade_m0_m2.push_back(
        std::accumulate(variances.back().begin(), variances.back().end(), 0.0));
  }
  certificate.resolved = ocean::sea_state_of(modes, dispersion, gerstner_waves);
  certificate.standard_error = ocean::standard_error_of(modes, dispersion, certificate.seeds, gerstner_waves);
}

}  // namespace

EnergyShares energy_shares(const ocean::SeaSpectrum& spectrum, const std::vector<ocean::Cascade>& cascades) {
  EnergyShares shares;
  shares.m0_m2 = ocean::integrate_sea_state(spectrum).m0_m2;
  for (const ocean::Cascade& cascade : cascades) {
    shares.cascade_m0_m2.push_back(
        ocean::integrate_sea_state(spectrum, cascade.k_min_radpm, cascade.k_max_radpm).m0_m2);
  }
  const double split_radpm = cascades.front().k_min_radpm;
  shares.gerstner_m0_m2 = ocean::integrate_sea_state(spectrum, 0.0, split_radpm).m0_m2;
  // Waves longer than the first patch fall into its K = 0, which moves nothing.
  const double too_long_m2 =
      ocean::still_cell_variance_m2(spectrum, cascades.front().patch_length_m, split_radpm);
  shares.cascade_m0_m2.front() -= std::min(too_long_m2, shares.cascade_m0_m2.front());
  shares.out_of_band_m2 =
      too_long_m2 + ocean::integrate_sea_state(spectrum, cascades.back().k_max_radpm).m0_m2;
  return shares;
}

Certificate certify(const ocl::Device& device, const scene::Sea& sea, int seeds, Progress& progress,
                    const CancelToken& cancel) {
  const ocean::Dispersion& dispersion = sea.spectrum.dispersion;
  Certificate certificate;
  certificate.seeds = seeds;
  certificate.asked = ocean::integrate_sea_state(sea.spectrum);
  for (const ocean::GerstnerWave& swell : sea.swells) {
    certificate.swell_m0_m2 += 0.5 * swell.amplitude_m * swell.amplitude_m;
  }
  certificate.energy = energy_shares(sea.spectrum, sea.parameters.cascades);

  ocean::OceanParameters parameters = sea.parameters;
  parameters.loop_period_s.reset();
  ocean::Ocean ocean(device, sea.spectrum, parameters);
  expect(ocean, dispersion, expected_gerstner_waves(sea), certificate);
  SurfaceMeter meter(device, parameters.size);
  std::vector<SurfaceMeasurement> measurements;
  double steepness = 0.0;  // of the Gerstner waves, sum over the seeds
  for (int i = 0; i < seeds; ++i) {
    cancel.throw_if_cancelled();
    const std::uint64_t seed = parameters.seed + static_cast<std::uint64_t>(i);
    if (i > 0) {
      ocean.reseed(seed);
    }
    ocean::GerstnerSea gerstner_waves = scene::gerstner_waves_of(sea, seed);
    gerstner_waves.loop_period_s.reset();
    gerstner_waves.raindrops.clear();
    ocean.at(0.0);
    measurements.push_back(meter.measure(ocean, gerstner_waves));
    steepness += ocean::horizontal_scale(gerstner_waves).steepness;
    progress.advance();
  }
  summarise(measurements, certificate);
  const double cascade_mss =
      mean_and_spread(each(measurements, [](const SurfaceMeasurement& m) { return m.cascade_mss; })).mean;
  certificate.max_ka = steepness / seeds + 3.0 * std::sqrt(cascade_mss);
  if (sea.gerstner_choice && seeds > 1) {
    // Gerstner waves' frequencies and directions scatter besides, which theory leaves out.
    certificate.standard_error.tm02_s = certificate.tm02_s.spread / std::sqrt(seeds);
    certificate.standard_error.mean_direction_rad = certificate.mean_direction_rad.spread / std::sqrt(seeds);
  }
  return certificate;
}

}  // namespace offing::cli

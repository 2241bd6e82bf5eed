// Measures what a synthesised sea has, from its surface alone.
#include "host/scene/measure/certificate.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <numeric>
#include <utility>
#include <vector>

#include "host/fft/fft2d.h"
#include "host/ocean/query/gerstner_instant.h"
#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/ocean/surface/ocean.h"
#include "host/ocl/buffer.h"

namespace offing::scene {
namespace {

/// What one realised sea is like, measured on its surface.
struct SurfaceMeasurement {
  ocean::SeaState state;              ///< from the energies of the waves found on the surface
  std::vector<double> cascade_m0_m2;  ///< what each cascade adds to state.m0_m2
  double cascade_mss = 0.0;           ///< what all of them add to state.mss
  double skewness = 0.0;              ///< of the elevation at rest labels, the whole surface
  double kurtosis = 0.0;              ///< 3 for a Gaussian surface
  double folded_share = 0.0;          ///< share of label area with composed J <= 0
  double foam_fraction = 0.0;         ///< area mean of the composed foam
};

/// Measures a sea from its surface alone: the cascades' elevation and its rate of change, not the amplitudes
/// they were made from. Gerstner waves are the surface that they are.
class SurfaceMeter {
 public:
  /// `size` samples along a patch, as the seas to be measured have.
  SurfaceMeter(const ocl::Device& device, int size);

  /// The sea of a spectrum, which stands at time 0. Its Gerstner waves follow the dispersion of its cascades.
  SurfaceMeasurement measure(ocean::Ocean& sea, const ocean::SeaSpectrum& spectrum);

 private:
  std::vector<float> travelling_energies(const ocean::SurfaceFields& surface,
                                         const std::vector<float>& rise_mps, double patch_length_m,
                                         const ocean::Dispersion& dispersion);

  fft::Fft2d forward_;
  ocl::Buffer<float> packed_;
  ocl::Buffer<float> transformed_;
};

/// Labels at which the composed surface is looked at: the standard error of skewness, sqrt(6 / count) for
/// independent samples, is then 0.005, far below the scatter from sea to sea.
constexpr int sample_count = 1 << 18;

/// Side of the square that the labels cover, in lengths of the longest patch: wide enough that every
/// combination of places within the patches occurs.
constexpr double square_patches = 64.0;

/// Label `index` of a low-discrepancy sequence over the unit square (Roberts 2018, R2: the plastic number's
/// powers).
std::pair<double, double> label(int index) {
  constexpr double plastic = 1.32471795724474602596;
  const double u = 0.5 + index / plastic;
  const double v = 0.5 + index / (plastic * plastic);
  return {u - std::floor(u), v - std::floor(v)};
}

int texel(double position_m, double patch_length_m, int size) {
  const double turns = position_m / patch_length_m;
  return std::min(static_cast<int>((turns - std::floor(turns)) * size), size - 1);
}

/// Moments of the elevation and the folded share, of all cascades and Gerstner waves together.
void measure_shape(const std::vector<ocean::SurfaceFields>& surfaces,
                   const std::vector<ocean::Cascade>& cascades, const ocean::GerstnerInstant& gerstner_waves,
                   SurfaceMeasurement& measurement) {
  double square_m_longest = 0.0;
  for (const ocean::Cascade& cascade : cascades) {
    square_m_longest = std::max(square_m_longest, cascade.patch_length_m);
  }
  double m2 = 0.0, m3 = 0.0, m4 = 0.0;
  int folded = 0;
  for (int i = 0; i < sample_count; ++i) {
    const auto [u, v] = label(i);
    const double square_m = square_patches * square_m_longest;
    const ocean::GerstnerValues values = gerstner_waves.at(u * square_m, v * square_m);
    double height_m = values.displacement_y_m;
    double xx = 1.0 + values.gradient_xx, xz = values.gradient_xz, zz = 1.0 + values.gradient_zz;
    for (std::size_t c = 0; c < cascades.size(); ++c) {
      const ocean::SurfaceFields& surface = surfaces[c];
      const int row = texel(v * square_m, cascades[c].patch_length_m, surface.size);
      const int column = texel(u * square_m, cascades[c].patch_length_m, surface.size);
      const std::size_t at = static_cast<std::size_t>(row) * surface.size + column;
      height_m += surface.displacement_y[at];
      xx += surface.gradient_xx[at];
      xz += surface.gradient_xz[at];
      zz += surface.gradient_zz[at];
    }
    const double square = height_m * height_m;  // the mean level is 0: no wave has K = 0
    m2 += square;
    m3 += square * height_m;
    m4 += square * square;
    folded += xx * zz - xz * xz <= 0.0 ? 1 : 0;
  }
  m2 /= sample_count;
  if (m2 > 0.0) {
    measurement.skewness = m3 / sample_count / std::pow(m2, 1.5);
    measurement.kurtosis = m4 / sample_count / (m2 * m2);
  }
  measurement.folded_share = static_cast<double>(folded) / sample_count;
}

/// Of labels on a grid over five patches, close enough to show Gerstner waves, whose spacing has no common
/// multiple with any patch.
double foam_fraction_of(ocean::Ocean& sea) {
  constexpr int side = 512;
  static_assert(side * side == sample_count);
  if (!sea.foam_onset().has_foam()) return 0.0;
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  const double spacing_m = golden / 64.0 * sea.parameters().cascades.front().patch_length_m;
  const std::vector<float> foam = sea.read_composed_foam(
      {.spacing_x_m = spacing_m, .spacing_z_m = spacing_m, .columns = side, .rows = side});
  return std::accumulate(foam.begin(), foam.end(), 0.0) / sample_count;
}

SurfaceMeter::SurfaceMeter(const ocl::Device& device, int size)
    : forward_(device, size, 1, fft::Direction::forward),
      packed_(device, forward_.float_count(), "measured surface"),
      transformed_(device, forward_.float_count(), "transformed surface") {}

SurfaceMeasurement SurfaceMeter::measure(ocean::Ocean& sea, const ocean::SeaSpectrum& spectrum) {
  const ocean::GerstnerSea& gerstner_waves = sea.parameters().gerstner_waves;
  const ocean::Dispersion& dispersion = gerstner_waves.dispersion;
  const std::vector<ocean::Cascade>& cascades = sea.parameters().cascades;
  SurfaceMeasurement measurement;
  std::vector<ocean::SurfaceFields> surfaces;
  std::vector<std::vector<float>> energies;
  std::vector<ocean::ModeEnergies> modes;
  for (std::size_t i = 0; i < cascades.size(); ++i) {
    const int cascade = static_cast<int>(i);
    surfaces.push_back(sea.read_surface(cascade));
    const ocean::VelocityFields velocity = sea.read_velocity(cascade);
    energies.push_back(
        travelling_energies(surfaces.back(), velocity.y, cascades[i].patch_length_m, dispersion));
    measurement.cascade_m0_m2.push_back(std::accumulate(energies.back().begin(), energies.back().end(), 0.0));
    modes.push_back({cascades[i].patch_length_m, surfaces.back().size, energies.back()});
  }
  measurement.state = ocean::sea_state_of(modes, spectrum, gerstner_waves.waves);
  measurement.cascade_mss = ocean::sea_state_of(modes, spectrum).mss;
  measure_shape(surfaces, cascades, ocean::GerstnerInstant(gerstner_waves, 0.0), measurement);
  measurement.foam_fraction = foam_fraction_of(sea);
  return measurement;
}

/// Splits the surface into waves that travel toward +K, one a cell. With h(K) = h0(K) e^(-i w t) +
/// conj(h0(-K)) e^(i w t) its rate of change is h'(K) = -i w (h0(K) e^(-i w t) - conj(h0(-K)) e^(i w t)), so
/// that (h + i h' / w) / 2 is h0(K) e^(-i w t) alone: a wave of variance 2 |h0(K)|^2. In linear theory the
/// vertical velocity of the particles at the surface is h'.
std::vector<float> SurfaceMeter::travelling_energies(const ocean::SurfaceFields& surface,
                                                     const std::vector<float>& rise_mps,
                                                     double patch_length_m,
                                                     const ocean::Dispersion& dispersion) {
  const int n = surface.size;
  const std::size_t count = surface.displacement_y.size();
  std::vector<float> values(2 * count);
  for (std::size_t i = 0; i < count; ++i) {
    values[2 * i] = surface.displacement_y[i];
    values[2 * i + 1] = rise_mps[i];
  }
  packed_.write(values);
  forward_.transform(packed_, transformed_);
  transformed_.read(values);

  const auto packed_at = [&](int row, int column) {
    const std::size_t at = 2 * (static_cast<std::size_t>(row) * n + column);
    return std::complex<double>(values[at], values[at + 1]) / static_cast<double>(count);
  };
  std::vector<float> energies(count, 0.0f);
  const double step_radpm = 2.0 * std::numbers::pi / patch_length_m;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      if ((row == 0 && column == 0) || row == n / 2 || column == n / 2) {
        continue;  // no wave there: the mean, and the Nyquist lines, which have no partner
      }
      const int z = row < n / 2 ? row : row - n;
      const int x = column < n / 2 ? column : column - n;
      const double omega_radps = dispersion.omega_radps(step_radpm * std::hypot(x, z));
      // Two real fields in one transform: the even part is h, the odd part i h'.
      const std::complex<double> here = packed_at(row, column);
      const std::complex<double> opposite = std::conj(packed_at((n - row) % n, (n - column) % n));
      const std::complex<double> height = 0.5 * (here + opposite);
      const std::complex<double> i_rise = 0.5 * (here - opposite);
      energies[static_cast<std::size_t>(row) * n + column] =
          static_cast<float>(2.0 * std::norm(0.5 * (height + i_rise / omega_radps)));
    }
  }
  return energies;
}

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
    deviations.push_back(std::remainder(direction - mean_rad, 2.0 * std::numbers::pi));
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
  certificate.peak_period_s = mean_and_spread(each(all, [](const M& m) { return m.state.peak_period_s; }));
  certificate.tp_s = mean_and_spread(each(all, [](const M& m) { return m.state.tp_s; }));
  certificate.tm01_s = mean_and_spread(each(all, [](const M& m) { return m.state.tm01_s; }));
  certificate.tm02_s = mean_and_spread(each(all, [](const M& m) { return m.state.tm02_s; }));
  certificate.mss = mean_and_spread(each(all, [](const M& m) { return m.state.mss; }));
  certificate.mean_direction_rad =
      mean_direction(each(all, [](const M& m) { return m.state.mean_direction_rad; }));
  certificate.peak_direction_rad =
      mean_direction(each(all, [](const M& m) { return m.state.peak_direction_rad; }));
  certificate.spread_rad = mean_and_spread(each(all, [](const M& m) { return m.state.spread_rad; }));
  certificate.skewness = mean_and_spread(each(all, [](const M& m) { return m.skewness; }));
  certificate.kurtosis = mean_and_spread(each(all, [](const M& m) { return m.kurtosis; }));
  certificate.folded_share = mean_and_spread(each(all, [](const M& m) { return m.folded_share; }));
  certificate.foam_fraction = mean_and_spread(each(all, [](const M& m) { return m.foam_fraction; }));
  for (std::size_t i = 0; i < certificate.energy.cascade_m0_m2.size(); ++i) {
    certificate.measured_cascade_m0_m2.push_back(
        mean_and_spread(each(all, [i](const M& m) { return m.cascade_m0_m2[i]; })).mean);
  }
}

/// What Gerstner waves are expected to be: those of many seeds, each with its share of the energy, and the
/// swells.
std::vector<ocean::GerstnerWave> expected_gerstner_waves(const Sea& sea) {
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

/// The Gerstner waves of one seed as they are measured: without a loop, which would round their frequencies,
/// and without raindrops.
ocean::GerstnerSea measured_gerstner_waves(const Sea& sea, std::uint64_t seed) {
  ocean::GerstnerSea waves = gerstner_waves_of(sea, seed);
  waves.loop_period_s.reset();
  waves.raindrops.clear();
  return waves;
}

void expect(const ocean::Ocean& sea, const ocean::SeaSpectrum& spectrum,
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
  certificate.resolved = ocean::sea_state_of(modes, spectrum, gerstner_waves);
  certificate.standard_error = ocean::standard_error_of(modes, spectrum, certificate.seeds, gerstner_waves);
}

}  // namespace

Certificate certify(const ocl::Device& device, const Sea& sea, int seeds, const Work& work) {
  Certificate certificate;
  certificate.seeds = seeds;
  certificate.asked = ocean::integrate_sea_state(sea.spectrum);
  for (const ocean::GerstnerWave& swell : sea.swells) {
    certificate.swell_m0_m2 += 0.5 * swell.amplitude_m * swell.amplitude_m;
  }
  certificate.energy = energy_shares(sea.spectrum, sea.parameters.cascades);

  ocean::OceanParameters parameters = sea.parameters;
  parameters.loop_period_s.reset();
  parameters.gerstner_waves = measured_gerstner_waves(sea, parameters.seed);
  ocean::Ocean ocean(device, sea.spectrum, parameters);
  expect(ocean, sea.spectrum, expected_gerstner_waves(sea), certificate);
  certificate.foam_onset = ocean.foam_onset();
  certificate.foam_fraction_asked = parameters.foam.onset_jacobian ? certificate.foam_onset.fraction
                                                                   : parameters.foam.fraction.value_or(0.0);
  SurfaceMeter meter(device, parameters.size);
  std::vector<SurfaceMeasurement> measurements;
  double steepness = 0.0;  // of the Gerstner waves, sum over the seeds
  for (int i = 0; i < seeds; ++i) {
    work.poll();
    const std::uint64_t seed = parameters.seed + static_cast<std::uint64_t>(i);
    if (i > 0) {
      ocean.reseed(seed, measured_gerstner_waves(sea, seed));
    }
    ocean.at(0.0);
    measurements.push_back(meter.measure(ocean, sea.spectrum));
    steepness += ocean::horizontal_scale(ocean.parameters().gerstner_waves).steepness;
    work.tell((i + 1.0) / seeds);
  }
  summarise(measurements, certificate);
  const double cascade_mss =
      mean_and_spread(each(measurements, [](const SurfaceMeasurement& m) { return m.cascade_mss; })).mean;
  certificate.max_ka = steepness / seeds + 3.0 * std::sqrt(cascade_mss);
  if (sea.gerstner_choice && seeds > 1) {
    // Gerstner waves' frequencies and directions scatter besides, which theory leaves out.
    certificate.standard_error.peak_period_s = certificate.peak_period_s.spread / std::sqrt(seeds);
    certificate.standard_error.tm02_s = certificate.tm02_s.spread / std::sqrt(seeds);
    certificate.standard_error.mean_direction_rad = certificate.mean_direction_rad.spread / std::sqrt(seeds);
  }
  return certificate;
}

}  // namespace offing::scene

#include <algorithm>
#include <cmath>
#include <complex>
#include <limits>
#include <memory>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

#include "host/base/wave_spectrum.h"
#include "host/c/handles.h"
#include "host/io/spectra/read_spectra.h"
#include "host/io/spectra/spectrum_builder.h"
#include "host/scene/prepare/sea.h"

using offing::Error;
using offing::ErrorKind;
using offing::WaveSpectrum;
using offing::c::require;
using offing::c::run;

struct OffingSpectra {
  explicit OffingSpectra(std::vector<WaveSpectrum> of) {
    for (WaveSpectrum& spectrum : of) {
      std::vector<double> density = spectrum.spreading;
      for (std::size_t i = 0; i < density.size(); ++i)
        density[i] *= spectrum.energy[i / spectrum.directions_rad.size()];
      densities.push_back(std::move(density));
      spectra.push_back(std::make_shared<const WaveSpectrum>(std::move(spectrum)));
    }
  }

  const std::shared_ptr<const WaveSpectrum>& at(std::size_t index) const {
    if (index < spectra.size()) return spectra[index];
    throw Error(ErrorKind::bad_usage,
                fmt::format("index: expected an index below {}, got {}", spectra.size(), index),
                "offing_spectrum_count() says how many spectra there are");
  }

  std::vector<std::shared_ptr<const WaveSpectrum>> spectra;
  std::vector<std::vector<double>> densities;  // energy times spreading
};

namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

OffingSpectra* one(WaveSpectrum spectrum) {
  std::vector<WaveSpectrum> spectra;
  spectra.push_back(std::move(spectrum));
  return new OffingSpectra(std::move(spectra));
}

/// Densities of truncated Fourier series are negative in places. What such a series knows is energy and two
/// moments at each frequency: these make the spectrum.
void set_fourier_density(WaveSpectrum& spectrum, std::span<const double> directions_rad,
                         std::span<const double> density) {
  const std::size_t count = directions_rad.size();
  const double step_rad = 2.0 * std::numbers::pi / static_cast<double>(count);
  std::vector<offing::spectra::ReportedMoments> moments;
  for (std::size_t row = 0; row < spectrum.frequencies_hz.size(); ++row) {
    std::complex<double> sums[3] = {};
    for (std::size_t i = 0; i < count; ++i) {
      for (int order = 0; order < 3; ++order)
        sums[order] += density[row * count + i] * std::polar(step_rad, order * directions_rad[i]);
    }
    const double energy = sums[0].real();
    spectrum.energy.push_back(energy);
    using Kind = offing::spectra::ReportedMoments::Kind;
    if (energy > 0.0) {
      moments.push_back({Kind::both, {sums[1] / energy, sums[2] / energy}});
    } else {
      moments.push_back({});
    }
  }
  offing::spectra::check_densities(spectrum.energy, "spectrum: a sum over directions");
  offing::spectra::set_moments(spectrum, moments);
}

WaveSpectrum spectrum_of(const OffingSpectrum& given) {
  WaveSpectrum spectrum;
  require(given.frequencies_hz, "frequencies_hz");
  spectrum.frequencies_hz.assign(given.frequencies_hz, given.frequencies_hz + given.frequency_count);
  offing::spectra::check_frequencies(spectrum.frequencies_hz, "spectrum");
  if (given.direction_count > 0) {
    require(given.directions_rad, "directions_rad");
    require(given.density, "density");
    const std::span directions_rad(given.directions_rad, given.direction_count);
    const std::span density(given.density, given.frequency_count * given.direction_count);
    const offing::spectra::DirectionGrid grid({directions_rad.begin(), directions_rad.end()}, "spectrum");
    const bool is_even = grid.directions_rad().size() == given.direction_count;
    if (is_even && std::any_of(density.begin(), density.end(), [](double value) { return value < 0.0; })) {
      set_fourier_density(spectrum, directions_rad, density);
    } else {
      offing::spectra::set_density(spectrum, density, grid, "spectrum");
    }
  } else {
    require(given.energy_m2phz, "energy_m2phz");
    spectrum.energy.assign(given.energy_m2phz, given.energy_m2phz + given.frequency_count);
    offing::spectra::check_densities(spectrum.energy, "spectrum");
  }
  if (std::isfinite(given.latitude_deg)) spectrum.latitude_deg = given.latitude_deg;
  if (std::isfinite(given.longitude_deg)) spectrum.longitude_deg = given.longitude_deg;
  if (std::isfinite(given.depth_m) && given.depth_m > 0.0) spectrum.depth_m = given.depth_m;
  if (given.station != nullptr) spectrum.station = given.station;
  if (given.time_utc != nullptr) spectrum.time_utc = given.time_utc;
  return spectrum;
}

/// S(f, theta) = 2 pi S(omega, theta): the same energy in a band.
WaveSpectrum table_of(const offing::ocean::SeaSpectrum& sea, std::vector<double> frequencies_hz,
                      std::size_t directions) {
  constexpr std::size_t most_directions = 3600;
  if (directions > most_directions) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("direction_count: expected at most {}, got {}", most_directions, directions),
                "ask for 36 or 72 directions");
  }
  WaveSpectrum spectrum;
  spectrum.frequencies_hz = std::move(frequencies_hz);
  offing::spectra::check_frequencies(spectrum.frequencies_hz, "frequencies_hz");
  if (std::isfinite(sea.dispersion.depth_m)) spectrum.depth_m = sea.dispersion.depth_m;
  std::vector<double> directions_rad, density;
  for (std::size_t i = 0; i < directions; ++i)
    directions_rad.push_back(2.0 * std::numbers::pi * static_cast<double>(i) /
                             static_cast<double>(directions));
  for (const double f_hz : spectrum.frequencies_hz) {
    const double omega_radps = 2.0 * std::numbers::pi * f_hz;
    const double energy = 2.0 * std::numbers::pi * sea.energy(omega_radps);
    spectrum.energy.push_back(energy);
    if (directions == 0) continue;
    const offing::ocean::DirectionalDensity spreading = sea.spreading_at(omega_radps);
    for (const double direction_rad : directions_rad) density.push_back(energy * spreading(direction_rad));
  }
  if (directions == 0) return spectrum;
  offing::spectra::set_density(spectrum, density, offing::spectra::DirectionGrid(directions_rad, "spectrum"),
                               "spectrum");
  return spectrum;
}

}  // namespace

OffingStatus offing_read_spectra(const char* file, OffingSpectra** spectra) {
  return run([&] {
    require(file, "file");
    require(spectra, "spectra");
    *spectra = new OffingSpectra(offing::read_spectra(file));
  });
}

OffingStatus offing_make_spectrum(const OffingSpectrum* spectrum, OffingSpectra** spectra) {
  return run([&] {
    require(spectrum, "spectrum");
    require(spectra, "spectra");
    *spectra = one(spectrum_of(offing::c::read_struct(spectrum, "spectrum")));
  });
}

OffingStatus offing_tabulate_spectrum(const OffingScene* scene, const double* frequencies_hz,
                                      size_t frequency_count, size_t direction_count,
                                      OffingSpectra** spectra) {
  return run([&] {
    require(scene, "scene");
    require(frequencies_hz, "frequencies_hz");
    require(spectra, "spectra");
    const offing::scene::Sea sea = offing::scene::prepare_sea(scene->copy());
    *spectra =
        one(table_of(sea.spectrum, {frequencies_hz, frequencies_hz + frequency_count}, direction_count));
  });
}

size_t offing_spectrum_count(const OffingSpectra* spectra) {
  return spectra == nullptr ? 0 : spectra->spectra.size();
}

OffingStatus offing_get_spectrum(const OffingSpectra* spectra, size_t index, OffingSpectrum* spectrum) {
  return run([&] {
    require(spectra, "spectra");
    const WaveSpectrum& found = *spectra->at(index);
    OffingSpectrum values{};
    values.size = sizeof values;
    values.frequency_count = found.frequencies_hz.size();
    values.direction_count = found.directions_rad.size();
    values.frequencies_hz = found.frequencies_hz.data();
    values.energy_m2phz = found.energy.data();
    values.directions_rad = found.directions_rad.data();
    values.density = spectra->densities[index].data();
    values.latitude_deg = found.latitude_deg.value_or(unknown);
    values.longitude_deg = found.longitude_deg.value_or(unknown);
    values.depth_m = found.depth_m.value_or(unknown);
    values.station = found.station.c_str();
    values.time_utc = found.time_utc.c_str();
    offing::c::write_struct(spectrum, "spectrum", values);
  });
}

void offing_free_spectra(OffingSpectra* spectra) {
  delete spectra;
}

OffingStatus offing_set_spectrum(OffingScene* scene, const OffingSpectra* spectra, size_t index) {
  return run([&] {
    require(scene, "scene");
    require(spectra, "spectra");
    scene->set_spectrum(spectra->at(index));
  });
}

OffingStatus offing_get_sea_state(const OffingScene* scene, OffingSeaState* state) {
  return run([&] {
    require(scene, "scene");
    const offing::ocean::SeaState found =
        offing::ocean::integrate_sea_state(offing::scene::prepare_sea(scene->copy()).spectrum);
    OffingSeaState values{};
    values.size = sizeof values;
    values.hs_m = found.hs_m;
    values.tp_s = found.tp_s;
    values.tm01_s = found.tm01_s;
    values.tm02_s = found.tm02_s;
    values.mean_direction_rad = found.mean_direction_rad;
    values.mss = found.mss;
    values.peak_period_s = found.peak_period_s;
    values.peak_direction_rad = found.peak_direction_rad;
    values.spread_rad = found.spread_rad;
    offing::c::write_struct(state, "state", values);
  });
}

#include "tests/ocean/example_seas.h"

#include <cmath>
#include <numbers>

#include "host/ocean/spectrum/spectrum_parameters.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

SpectrumParameters model(SpectrumModel kind, SpreadingModel spreading, double direction_rad) {
  SpectrumParameters parameters;
  parameters.model = kind;
  parameters.spreading.model = spreading;
  parameters.spreading.direction_rad = direction_rad;
  return parameters;
}

/// Frequencies 0.02 ... 0.48 Hz, 36 directions.
WaveSpectrum empty_record() {
  WaveSpectrum record;
  for (int i = 0; i < 93; ++i) {
    record.frequencies_hz.push_back(0.02 + 0.005 * i);
    record.energy.push_back(0.0);
  }
  for (int i = 0; i < 36; ++i) {
    record.directions_rad.push_back(0.0873 + 2.0 * pi * i / 36);
  }
  record.spreading.assign(record.energy.size() * 36, 0.0);
  return record;
}

/// Everything at this frequency goes into one direction of the grid.
void add_spike(WaveSpectrum& record, int frequency, int direction, double energy) {
  record.energy[frequency] = energy;
  record.spreading[frequency * 36 + direction] = 36.0 / (2.0 * pi);
}

/// Spikes of swell at 0.05 Hz, wind sea at 0.18 Hz and ripples at 0.47 Hz, apart from each other in
/// direction.
WaveSpectrum spiky_record() {
  WaveSpectrum record = empty_record();
  add_spike(record, 6, 3, 5.0);
  add_spike(record, 32, 11, 8.0);
  add_spike(record, 90, 17, 3.0);
  return record;
}

/// Swell at 0.06 Hz under a wind sea at 0.2 Hz, as a buoy reports them, without directions.
WaveSpectrum mixed_record() {
  WaveSpectrum record = empty_record();
  record.directions_rad.clear();
  record.spreading.clear();
  for (std::size_t i = 0; i < record.energy.size(); ++i) {
    const double frequency_hz = record.frequencies_hz[i];
    const double wind_sea =
        std::pow(0.2 / frequency_hz, 5.0) * std::exp(-1.25 * std::pow(0.2 / frequency_hz, 4.0));
    const double swell = std::exp(-0.5 * std::pow((frequency_hz - 0.06) / 0.006, 2.0));
    record.energy[i] = 2.0 * wind_sea + 3.0 * swell;
  }
  return record;
}

}  // namespace

std::vector<ExampleSea> example_seas() {
  std::vector<ExampleSea> seas;
  const auto add = [&seas](const std::string& name, const SpectrumParameters& parameters) {
    seas.push_back({name, make_sea_spectrum(parameters)});
  };
  add("phillips", model(SpectrumModel::phillips, SpreadingModel::cosine_2s, 0.3));
  SpectrumParameters parameters = model(SpectrumModel::phillips, SpreadingModel::cosine_2s, 4.0);
  parameters.phillips_upwind = 0.0;
  parameters.phillips_cutoff_m = 0.1;
  add("phillips, one-sided", parameters);
  add("pierson-moskowitz", model(SpectrumModel::pierson_moskowitz, SpreadingModel::mitsuyasu, 1.0));
  parameters = model(SpectrumModel::jonswap, SpreadingModel::hasselmann, 2.0);
  parameters.gamma = 7.0;
  add("jonswap", parameters);
  parameters = model(SpectrumModel::jonswap, SpreadingModel::donelan_banner, 3.0);
  parameters.spreading.swell = 0.8;
  add("jonswap, donelan-banner with swell", parameters);
  parameters = model(SpectrumModel::tma, SpreadingModel::cosine_2s, 5.0);
  parameters.dispersion.depth_m = 8.0;
  parameters.wind_speed_mps = 15.0;
  add("tma", parameters);
  parameters = model(SpectrumModel::jonswap, SpreadingModel::phillips_cosine, 0.0);
  parameters.dispersion.capillary_length_m = 2.73e-3;
  parameters.wind_speed_mps = 4.0;
  add("capillary jonswap", parameters);
  add("swell", model(SpectrumModel::swell, SpreadingModel::cosine_2s, 6.0));
  parameters = model(SpectrumModel::swell, SpreadingModel::cosine_2s, 0.5);
  parameters.swell_bandwidth_hz = 2e-4;
  parameters.swell_exponent_s = 1000.0;
  add("narrow swell", parameters);
  SpreadingParameters spreading;
  spreading.direction_rad = 2.2;
  seas.push_back({"measured, mixed", from_measured(mixed_record(), spreading, Dispersion{})});
  seas.push_back({"measured, spiky", from_measured(spiky_record(), spreading, Dispersion{})});
  return seas;
}

}  // namespace offing::ocean

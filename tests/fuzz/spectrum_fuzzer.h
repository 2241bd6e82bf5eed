#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "host/base/error.h"
#include "host/base/wave_spectrum.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/spectrum/spectrum_table.h"
#include "tests/fuzz/expect.h"

namespace offing::fuzz {

/// What host/base/wave_spectrum.h promises.
inline void expect_contract(const WaveSpectrum& spectrum) {
  const std::size_t nf = spectrum.frequencies_hz.size();
  const std::size_t nd = spectrum.directions_rad.size();
  expect(nf >= 2 && spectrum.energy.size() == nf && spectrum.spreading.size() == nf * nd);
  double last_hz = 0.0;
  for (std::size_t i = 0; i < nf; ++i) {
    expect(std::isfinite(spectrum.frequencies_hz[i]) && spectrum.frequencies_hz[i] > last_hz);
    expect(std::isfinite(spectrum.energy[i]) && spectrum.energy[i] >= 0.0);
    last_hz = spectrum.frequencies_hz[i];
    double sum = 0.0;
    for (std::size_t j = 0; j < nd; ++j) {
      const double density = spectrum.spreading[i * nd + j];
      expect(std::isfinite(density) && density >= 0.0);
      sum += density;
    }
    expect(nd == 0 || std::abs(sum * 2.0 * std::numbers::pi / static_cast<double>(nd) - 1.0) < 1e-9);
  }
}

/// The sea of a record, as far as it is computed from the file alone: its table must be finite, and hold
/// energy if there is some to speak of. Throws Error for a record that no sea is made from.
inline void expect_sea(const WaveSpectrum& spectrum) {
  const ocean::SpectrumTable table = ocean::tabulate(ocean::from_measured(spectrum, {}, {}));
  double sum = 0.0;
  for (const float value : table.values) {
    expect(std::isfinite(value) && value >= 0.0f);
    sum += value;
  }
  // The table has 32-bit numbers: energies below them vanish, as 1e-283 m^2/Hz did.
  constexpr double least_energy = 1e-30;
  expect(sum > 0.0 || *std::max_element(spectrum.energy.begin(), spectrum.energy.end()) < least_energy);
}

/// Runs `parse`: it must return spectra that keep the contract, or throw Error of one line with a hint. So
/// must the sea of the first one; of the first only, since a table takes longer than a file.
template <class Parse>
int check_reader(Parse parse) {
  try {
    const std::vector<WaveSpectrum> spectra = parse();
    expect(!spectra.empty());
    for (const WaveSpectrum& spectrum : spectra) expect_contract(spectrum);
    expect_sea(spectra.front());
  } catch (const Error& error) {
    expect_told(error);
  }
  return 0;
}

}  // namespace offing::fuzz

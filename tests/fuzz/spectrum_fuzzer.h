#pragma once

#include <cmath>
#include <numbers>
#include <string_view>
#include <vector>

#include "host/base/error.h"
#include "host/base/wave_spectrum.h"

namespace offing::fuzz {

/// Ends the process, which libFuzzer reports as a finding.
inline void expect(bool holds) {
  if (!holds) __builtin_trap();
}

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

/// Runs `parse`: it must return spectra that keep the contract, or throw Error of one line with a hint.
template <class Parse>
int check_reader(Parse parse) {
  try {
    const std::vector<WaveSpectrum> spectra = parse();
    expect(!spectra.empty());
    for (const WaveSpectrum& spectrum : spectra) expect_contract(spectrum);
  } catch (const Error& error) {
    expect(std::string_view(error.what()).find('\n') == std::string_view::npos);
    expect(!error.hint().empty());
  }
  return 0;
}

}  // namespace offing::fuzz

#include "host/ocean/spectrum/mode_spectrum.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "host/base/error.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr std::size_t node_frequencies = 64;
constexpr std::size_t node_directions = 72;

bool counts(const SeaMode& mode) {
  return mode.patch != SeaMode::alone && mode.amplitude_m > 0.0;
}

double frequency_hz(const SeaMode& mode) {
  return mode.omega_radps / (2.0 * pi);
}

}  // namespace

WaveSpectrum spectrum_of(const ModalSea& modes) {
  double lowest_hz = std::numeric_limits<double>::infinity(), highest_hz = 0.0;
  for (const SeaMode& mode : modes.modes) {
    if (!counts(mode)) continue;
    lowest_hz = std::min(lowest_hz, frequency_hz(mode));
    highest_hz = std::max(highest_hz, frequency_hz(mode));
  }
  if (highest_hz <= 0.0) {
    throw Error(ErrorKind::bad_input, "modes: expected waves on a patch, found none",
                "give waves a patch, or waves alone as [[ocean.swell]]");
  }
  // A step of room on both sides, where E falls to 0; waves of one frequency get a narrow band.
  constexpr double least_range = 0.02;
  const double step = std::max(std::log(highest_hz / lowest_hz), least_range) / (node_frequencies - 3);
  WaveSpectrum spectrum;
  for (std::size_t i = 0; i < node_frequencies; ++i) {
    spectrum.frequencies_hz.push_back(lowest_hz * std::exp((static_cast<double>(i) - 1.0) * step));
  }
  for (std::size_t i = 0; i < node_directions; ++i) {
    spectrum.directions_rad.push_back(2.0 * pi * static_cast<double>(i) / node_directions);
  }
  spectrum.energy.assign(node_frequencies, 0.0);
  spectrum.spreading.assign(node_frequencies * node_directions, 0.0);

  const std::vector<double>& frequencies_hz = spectrum.frequencies_hz;
  for (const SeaMode& mode : modes.modes) {
    if (!counts(mode)) continue;
    const double variance_m2 = 0.5 * mode.amplitude_m * mode.amplitude_m;
    const double f_hz = frequency_hz(mode);
    const auto above = std::upper_bound(frequencies_hz.begin() + 1, frequencies_hz.end() - 1, f_hz);
    const auto upper = static_cast<std::size_t>(above - frequencies_hz.begin());
    const double share = std::clamp(
        (f_hz - frequencies_hz[upper - 1]) / (frequencies_hz[upper] - frequencies_hz[upper - 1]), 0.0, 1.0);
    const double turns = std::atan2(mode.kz_radpm, mode.kx_radpm) / (2.0 * pi);
    const double position = (turns - std::floor(turns)) * node_directions;
    const std::size_t first = static_cast<std::size_t>(position) % node_directions;
    const double toward_next = position - std::floor(position);
    const auto deposit = [&](std::size_t i, double amount) {
      spectrum.energy[i] += amount;
      spectrum.spreading[i * node_directions + first] += (1.0 - toward_next) * amount;
      spectrum.spreading[i * node_directions + (first + 1) % node_directions] += toward_next * amount;
    };
    deposit(upper - 1, (1.0 - share) * variance_m2);
    deposit(upper, share * variance_m2);
  }
  for (std::size_t i = 0; i < node_frequencies; ++i) {
    for (std::size_t j = 0; j < node_directions; ++j) {
      double& density = spectrum.spreading[i * node_directions + j];
      density =
          spectrum.energy[i] > 0.0 ? density / spectrum.energy[i] * node_directions / (2.0 * pi) : 0.5 / pi;
    }
    const double below_hz = i == 0 ? 0.0 : frequencies_hz[i] - frequencies_hz[i - 1];
    const double above_hz = i + 1 == node_frequencies ? 0.0 : frequencies_hz[i + 1] - frequencies_hz[i];
    spectrum.energy[i] /= 0.5 * (below_hz + above_hz);
  }
  return spectrum;
}

}  // namespace offing::ocean

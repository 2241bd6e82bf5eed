#include "host/ocean/spectrum/spectrum_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/quadrature.h"

namespace offing::ocean {
namespace {

using std::numbers::pi;

// The widest range, a wind sea over four decades of k, then has steps of 1.3 %, a tenth of JONSWAP's narrow
// peak.
constexpr int wavenumber_count = 1024;
// Two degrees suit all wind seas; narrow swell and spiky measured directions ask for more.
constexpr int fewest_directions = 180;
constexpr int most_directions = 720;

/// Variance per unit ln k in each row, m^2, and the frequency at which to ask for its spreading.
struct Row {
  double variance_m2 = 0.0;
  double omega_radps = 0.0;
};

// Spreads every bit of energy over its two neighbouring rows as linear interpolation will read it back: the
// total and the mean ln k are kept exactly, however narrow a peak is. The outermost rows stay empty.
std::vector<Row> energy_rows(const SeaSpectrum& spectrum, double log_k_first, double log_k_step) {
  std::vector<Row> rows(wavenumber_count);
  const double last = log_k_first + log_k_step * (wavenumber_count - 2);
  const std::vector<double> edges =
      log_wavenumber_panels(spectrum, log_k_first + log_k_step, last, wavenumber_count - 3);
  for (std::size_t panel = 0; panel + 1 < edges.size(); ++panel) {
    const double middle = 0.5 * (edges[panel] + edges[panel + 1]);
    const int below = static_cast<int>((middle - log_k_first) / log_k_step);
    for_each_gauss_node(edges[panel], edges[panel + 1], [&](double log_k, double weight) {
      const double k_radpm = std::exp(log_k);
      const double omega_radps = spectrum.dispersion.omega_radps(k_radpm);
      const double variance_m2 = weight * energy_per_log_k(spectrum, k_radpm, omega_radps);
      const double upper = (log_k - log_k_first) / log_k_step - below;
      for (const auto& [row, share] : {std::pair{below, 1.0 - upper}, std::pair{below + 1, upper}}) {
        rows[row].variance_m2 += share * variance_m2 / log_k_step;
        rows[row].omega_radps += share * variance_m2 / log_k_step * omega_radps;
      }
    });
  }
  for (Row& row : rows) {
    row.omega_radps = row.variance_m2 > 0.0 ? row.omega_radps / row.variance_m2 : 0.0;
  }
  return rows;
}

// D at equally spaced directions; returns its integral by the rectangle rule, 1 if the directions are dense
// enough.
double sample_spreading(const SeaSpectrum& spectrum, double omega_radps, std::vector<double>& densities) {
  const DirectionalDensity density = spectrum.spreading_at(omega_radps);
  const double step_rad = 2.0 * pi / static_cast<double>(densities.size());
  double integral = 0.0;
  for (std::size_t i = 0; i < densities.size(); ++i) {
    densities[i] = density(step_rad * static_cast<double>(i));
    integral += densities[i] * step_rad;
  }
  return integral;
}

// Largest error of linear interpolation between every other of these densities, relative to their maximum.
double interpolation_error(const std::vector<double>& densities) {
  double error = 0.0;
  for (std::size_t i = 1; i < densities.size(); i += 2) {
    const double next = densities[i + 1 < densities.size() ? i + 1 : 0];
    error = std::max(error, std::abs(densities[i] - 0.5 * (densities[i - 1] + next)));
  }
  return error / *std::max_element(densities.begin(), densities.end());
}

// The fewest directions between which D is linear within 1 %, on average over the energy.
int choose_direction_count(const SeaSpectrum& spectrum, const std::vector<Row>& rows) {
  int count = fewest_directions;
  for (; count < most_directions; count *= 2) {
    std::vector<double> densities(2 * count);
    double error = 0.0, total = 0.0;
    for (std::size_t i = 0; i < rows.size(); i += 16) {
      if (rows[i].variance_m2 > 0.0 && sample_spreading(spectrum, rows[i].omega_radps, densities) > 0.0) {
        error += rows[i].variance_m2 * interpolation_error(densities);
        total += rows[i].variance_m2;
      }
    }
    if (error <= 0.01 * total) {
      break;
    }
  }
  return count;
}

}  // namespace

SpectrumTable tabulate(const SeaSpectrum& spectrum) {
  const double log_k_low = std::log(spectrum.dispersion.wavenumber_radpm(spectrum.omega_min_radps));
  const double log_k_high = std::log(spectrum.dispersion.wavenumber_radpm(spectrum.omega_max_radps));
  SpectrumTable table;
  table.wavenumber_count = wavenumber_count;
  table.log_k_step = (log_k_high - log_k_low) / (wavenumber_count - 3);
  if (!(table.log_k_step > 0.0 && std::isfinite(table.log_k_step))) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("spectrum: expected frequencies 0 < omega_min < omega_max, found {:g} and {:g} rad/s",
                    spectrum.omega_min_radps, spectrum.omega_max_radps),
        "give the sea a range of frequencies, such as 0.2 to 20 rad/s");
  }
  table.log_k_first = log_k_low - table.log_k_step;
  const std::vector<Row> rows = energy_rows(spectrum, table.log_k_first, table.log_k_step);
  table.direction_count = choose_direction_count(spectrum, rows);
  table.values.resize(rows.size() * table.direction_count);
  std::vector<double> densities(table.direction_count);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].variance_m2 <= 0.0) {
      continue;
    }
    const double integral = sample_spreading(spectrum, rows[i].omega_radps, densities);
    if (integral <= 0.0) {
      continue;
    }
    // Divided by its own sum, each row holds its whole energy, whatever falls between the directions.
    const double scale = rows[i].variance_m2 / integral;
    std::transform(densities.begin(), densities.end(), table.values.begin() + i * table.direction_count,
                   [scale](double density) { return static_cast<float>(scale * density); });
  }
  return table;
}

}  // namespace offing::ocean

#include "tests/ocean/wakes/wake_reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace offing::ocean {
namespace {

using std::numbers::pi;

std::size_t index(int row, int column, int size) {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(size) + static_cast<std::size_t>(column);
}

}  // namespace

WakeReference::WakeReference(const WakeParameters& parameters) : parameters_(parameters) {
  const auto count = static_cast<std::size_t>(parameters.cells) * static_cast<std::size_t>(parameters.cells);
  height_m.resize(count);
  second_m.resize(count);
}

WakeReference::Modes WakeReference::transformed(const Modes& values, double sign) const {
  const int n = parameters_.cells;
  Modes along(values.size()), result(values.size());
  for (int row = 0; row < n; ++row) {
    for (int k = 0; k < n; ++k) {
      for (int j = 0; j < n; ++j) {
        along[index(row, k, n)] += values[index(row, j, n)] * std::polar(1.0, sign * 2.0 * pi * k * j / n);
      }
    }
  }
  for (int k = 0; k < n; ++k) {
    for (int row = 0; row < n; ++row) {
      for (int j = 0; j < n; ++j) {
        result[index(k, row, n)] += along[index(j, row, n)] * std::polar(1.0, sign * 2.0 * pi * k * j / n);
      }
    }
  }
  return result;
}

double WakeReference::kept(int place, double part_s) const {
  const double width_m = parameters_.length_m / 8.0, k = 2.0 * pi / width_m;
  const double speed_mps = parameters_.method == WakeMethod::verlet
                               ? parameters_.speed_mps
                               : parameters_.dispersion.group_speed_mps(k);
  const double edge_m = (std::min(place, parameters_.cells - 1 - place) + 0.5) * parameters_.cell_m();
  const double inward = std::min(1.0, edge_m / width_m);
  return std::exp(-7.5 * speed_mps / width_m * (1.0 - inward) * (1.0 - inward) * part_s);
}

void WakeReference::step_dispersive(const std::vector<double>& displaced_m) {
  const int n = parameters_.cells;
  Modes values;
  for (std::size_t i = 0; i < height_m.size(); ++i)
    values.emplace_back(height_m[i] + displaced_m[i], second_m[i]);
  Modes modes = transformed(values, -1.0);
  const double step_radpm = 2.0 * pi / parameters_.length_m, short_wave = 0.25 * n * step_radpm;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const double k =
          step_radpm * std::hypot(row <= n / 2 ? row : row - n, column <= n / 2 ? column : column - n);
      const double omega = parameters_.dispersion.omega_radps(k);
      const double fade = k == 0.0 ? 0.0
                                   : 1e-4 + parameters_.dispersion.omega_radps(short_wave) / (2.0 * pi) *
                                                std::pow(k / short_wave, 6);
      modes[index(row, column, n)] *=
          std::polar(std::exp(-fade * parameters_.step_s), -omega * parameters_.step_s);
    }
  }
  values = transformed(modes, 1.0);
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      const std::size_t i = index(row, column, n);
      const double share = kept(row, parameters_.step_s) * kept(column, parameters_.step_s);
      const double scale = 1.0 / (static_cast<double>(n) * n);
      height_m[i] = share * (scale * values[i].real() - displaced_m[i]);
      second_m[i] = share * scale * values[i].imag();
    }
  }
}

void WakeReference::step_verlet(const std::vector<double>& displaced_m, int parts) {
  const int n = parameters_.cells;
  const double part_s = parameters_.step_s / parts;
  const double courant = parameters_.speed_mps * part_s / parameters_.cell_m();
  for (int part = 0; part < parts; ++part) {
    for (std::size_t i = 0; i < height_m.size(); ++i) second_m[i] -= courant * (height_m[i] + displaced_m[i]);
    const std::vector<double> second = second_m;
    for (int row = 0; row < n; ++row) {
      for (int column = 0; column < n; ++column) {
        const std::size_t i = index(row, column, n);
        double bend = 0.0;
        for (const auto& [by, weight] : {std::pair{1, 16.0 / 12.0}, {2, -1.0 / 12.0}}) {
          bend += weight *
                  (second[index((row + by) % n, column, n)] + second[index((row + n - by) % n, column, n)] +
                   second[index(row, (column + by) % n, n)] + second[index(row, (column + n - by) % n, n)] -
                   4.0 * second[i]);
        }
        const double share = kept(row, part_s) * kept(column, part_s);
        height_m[i] = share * (height_m[i] - courant * bend);
        second_m[i] = share * second[i];
      }
    }
  }
}

void WakeReference::step(const std::vector<double>& displaced_m) {
  if (parameters_.method == WakeMethod::dispersive) return step_dispersive(displaced_m);
  const double courant = parameters_.speed_mps * parameters_.step_s / parameters_.cell_m();
  step_verlet(displaced_m, std::max(1, static_cast<int>(std::ceil(courant / 0.55))));
}

std::vector<double> reference_displaced_m(const WakeParameters& parameters, const WakeHull& hull) {
  constexpr int samples = 6;
  const int n = parameters.cells;
  std::vector<double> displaced_m;
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      double sum = 0.0, weights = 0.0;
      for (int j = 0; j < samples; ++j) {
        for (int i = 0; i < samples; ++i) {
          const double across = (2.0 * j + 1.0) / samples - 1.0, along = (2.0 * i + 1.0) / samples - 1.0;
          const double x_m = (column + along) * parameters.cell_m() - hull.x_m;
          const double z_m = (row + across) * parameters.cell_m() - hull.z_m;
          const double cosine = std::cos(hull.heading_rad), sine = std::sin(hull.heading_rad);
          const double u = (cosine * x_m + sine * z_m) / (0.5 * hull.length_m);
          const double v = (cosine * z_m - sine * x_m) / (0.5 * hull.beam_m);
          const double square = u * u + v * v;
          const double depth = hull.shape == WakeHull::Shape::gaussian
                                   ? std::exp(-square)
                                   : std::sqrt(std::max(0.0, 1.0 - square));
          const double weight = (1.0 - std::abs(along)) * (1.0 - std::abs(across));
          sum += weight * hull.draught_m * depth;
          weights += weight;
        }
      }
      displaced_m.push_back(sum / weights);
    }
  }
  return displaced_m;
}

double wake_energy(const WakeState& state) {
  double sum = 0.0;
  for (std::size_t i = 0; i < state.height_m.size(); ++i) {
    const double height = state.height_m[i], second = state.second_m[i];
    sum += height * height + second * second;
  }
  return sum;
}

}  // namespace offing::ocean

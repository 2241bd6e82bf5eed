#include "host/ocean/query/query_error.h"

#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <numbers>

namespace offing::ocean {
namespace {

using std::numbers::pi;

constexpr int most_aliases = 16;  // farther ones have less than 1e-5 of a straight line's error

// Rounding of sums of many waves, as a share of their root mean square, and of places, m: fitted to seas of
// 0.3 and 0.64 m root mean square, whose errors were 1.4e-7 and 1.7e-7 m.
constexpr double sum_rounding = 2.3e-7, place_rounding_m = 1e-6;

double sinc(double turns) {
  return turns == 0.0 ? 1.0 : std::sin(pi * turns) / (pi * turns);
}

enum class Filter { none, least_squares };

AxisResponse response_of(int order, int n, int cycles, Filter filter) {
  AxisResponse response;
  for (int i = 0; i <= cycles; ++i) {
    const double turns = static_cast<double>(i) / n, own = std::pow(sinc(turns), order);
    double power = 0.0, slope_power = 0.0;
    for (int alias = -most_aliases; alias <= most_aliases; ++alias) {
      const double alias_turns = turns + alias, share = std::pow(sinc(alias_turns), 2 * order);
      power += share;
      slope_power += share * std::pow(alias_turns * n, 2);
    }
    const double factor = filter == Filter::none ? 1.0 : own / power;
    response.filter.push_back(factor);
    response.gain.push_back(factor * own);
    response.power.push_back(factor * factor * power);
    response.slope_power.push_back(factor * factor * slope_power);
  }
  return response;
}

}  // namespace

AxisResponse spline_response(int order, int n, int cycles) {
  return response_of(order, n, cycles, Filter::least_squares);
}

AxisResponse linear_response(int n, int cycles) {
  return response_of(2, n, cycles, Filter::none);
}

AxisResponse exact_response(int cycles) {
  AxisResponse response;
  for (int i = 0; i <= cycles; ++i) {
    response.filter.push_back(1.0);
    response.gain.push_back(1.0);
    response.power.push_back(1.0);
    response.slope_power.push_back(1.0 * i * i);
  }
  return response;
}

LabelError& LabelError::operator+=(const LabelError& other) {
  height_m2 += other.height_m2;
  shift_x_m2 += other.shift_x_m2;
  shift_z_m2 += other.shift_z_m2;
  slope_x2 += other.slope_x2;
  slope_z2 += other.slope_z2;
  return *this;
}

double LabelError::height_rms_m() const {
  const double place_m2 = place_rounding_m * place_rounding_m;
  return std::sqrt(height_m2 + slope_x2 * (shift_x_m2 + place_m2) + slope_z2 * (shift_z_m2 + place_m2));
}

LabelError cascade_error(const Cascade& cascade, std::span<const float> variance, int size, double choppiness,
                         double min_wavelength_m, const AxisResponse& response, bool shifts_alike) {
  const double step_radpm = 2.0 * pi / cascade.patch_length_m;
  const double most_cycles = largest_wavenumber_radpm(min_wavelength_m) / step_radpm;
  const auto last = static_cast<int>(response.gain.size()) - 1;
  LabelError error;
  for (int row = -size / 2 + 1; row < size / 2; ++row) {
    for (int column = -size / 2 + 1; column < size / 2; ++column) {
      const auto place = static_cast<std::size_t>((row & (size - 1)) * size + (column & (size - 1)));
      const double m0_m2 = variance[place], cycles = std::hypot(row, column);
      if (m0_m2 == 0.0 || cycles > most_cycles || std::abs(row) > last || std::abs(column) > last) continue;
      const auto x = static_cast<std::size_t>(std::abs(column)), z = static_cast<std::size_t>(std::abs(row));
      const double gain = response.gain[x] * response.gain[z], power = response.power[x] * response.power[z];
      const double lost = 1.0 - 2.0 * gain + power;
      const double kx = column * step_radpm, kz = row * step_radpm;
      error.height_m2 += m0_m2 * (lost + sum_rounding * sum_rounding);
      error.slope_x2 += m0_m2 * kx * kx;
      error.slope_z2 += m0_m2 * kz * kz;
      // The displacement is choppiness times K/k times the height, in cycles as in rad/m.
      const double squared = choppiness * choppiness * m0_m2 / (cycles * cycles);
      const double x2 = column * column, z2 = row * row, missing = 1.0 - 2.0 * gain;
      error.shift_x_m2 +=
          squared * (shifts_alike ? x2 * lost : x2 * missing + response.slope_power[x] * response.power[z]);
      error.shift_z_m2 +=
          squared * (shifts_alike ? z2 * lost : z2 * missing + response.slope_power[z] * response.power[x]);
    }
  }
  return error;
}

LabelError gerstner_error(const GerstnerSea& sea, double min_wavelength_m) {
  LabelError error;
  for (const GerstnerWave& wave : sea.waves) {
    if (wave.wavenumber_radpm > largest_wavenumber_radpm(min_wavelength_m)) continue;
    const double steepness = wave.amplitude_m * wave.wavenumber_radpm;
    error.height_m2 += 0.5 * std::pow(wave.amplitude_m * sum_rounding, 2);
    error.slope_x2 += 0.5 * std::pow(steepness * std::cos(wave.direction_rad), 2);
    error.slope_z2 += 0.5 * std::pow(steepness * std::sin(wave.direction_rad), 2);
  }
  return error;
}

}  // namespace offing::ocean

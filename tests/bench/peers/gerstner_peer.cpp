// SPDX-License-Identifier: GPL-3.0-or-later (offing-bench links FFTW)
#include "tests/bench/peers/gerstner_peer.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace offing::bench {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;

std::size_t map_floats(const ocean::SampleGrid& grid) {
  return 4 * static_cast<std::size_t>(grid.columns) * static_cast<std::size_t>(grid.rows);
}

}  // namespace

GerstnerPeer::GerstnerPeer(const ocean::GerstnerSea& sea, const ocean::SampleGrid& grid)
    : grid_(grid), displacement_(map_floats(grid)), gradient_(map_floats(grid)) {
  const double scale = ocean::horizontal_scale(sea).scale;
  for (const ocean::GerstnerWave& wave : sea.waves) {
    const double ux = std::cos(wave.direction_rad), uz = std::sin(wave.direction_rad);
    const double k = wave.wavenumber_radpm, a = wave.amplitude_m;
    peer::GerstnerWave packed{};
    const double step_rad = k * ux * grid.spacing_x_m;
    packed.column_step_rad = static_cast<float>(step_rad);
    packed.vector_cosine = static_cast<float>(std::cos(16.0 * step_rad));
    packed.vector_sine = static_cast<float>(std::sin(16.0 * step_rad));
    for (int i = 0; i < 32; ++i) {
      packed.offset_cosine[i] = static_cast<float>(std::cos((i + 0.5) * step_rad));
      packed.offset_sine[i] = static_cast<float>(std::sin((i + 0.5) * step_rad));
    }
    const double amplitudes[] = {a,
                                 -scale * a * k * ux * ux,
                                 -scale * a * k * ux * uz,
                                 -scale * a * k * uz * uz,
                                 -scale * a * ux,
                                 -scale * a * uz,
                                 -a * k * ux,
                                 -a * k * uz};
    for (int f = 0; f < 8; ++f) packed.amplitude[f] = static_cast<float>(amplitudes[f]);
    waves_.push_back(packed);
    const double middle_x_m = grid.origin_x_m + 0.5 * grid.columns * grid.spacing_x_m;
    omega_radps_.push_back(wave.omega_radps);
    phase_rad_.push_back(k * (ux * middle_x_m + uz * grid.origin_z_m) + wave.phase_rad);
    row_step_rad_.push_back(k * uz * grid.spacing_z_m);
  }
}

std::string_view GerstnerPeer::way_name(Way way) {
  switch (way) {
    case Way::loop_64:
      return "libmvec loop, 64 columns at a time";
    case Way::loop_256:
      return "libmvec loop, 256 columns at a time";
    case Way::recurrence:
      return "by hand, phase recurrence";
    case Way::mirrored:
      return "by hand, mirrored blocks";
  }
  return "";
}

void GerstnerPeer::at(double time_s, Way way) {
  std::vector<double> phase_rad(waves_.size());
  for (std::size_t w = 0; w < waves_.size(); ++w)
    phase_rad[w] = std::remainder(phase_rad_[w] - omega_radps_[w] * time_s, two_pi);
  const int wave_count = static_cast<int>(waves_.size());
#pragma omp parallel
  {
    std::vector<peer::GerstnerWave> waves = waves_;
#pragma omp for schedule(static)
    for (int i = 0; i < grid_.rows; ++i) {
      peer::gerstner_row_phases(phase_rad.data(), row_step_rad_.data(), wave_count, i, waves.data());
      const std::size_t place = 4 * static_cast<std::size_t>(i) * static_cast<std::size_t>(grid_.columns);
      const peer::GerstnerRow row{.waves = waves.data(),
                                  .wave_count = wave_count,
                                  .columns = grid_.columns,
                                  .displacement = displacement_.data() + place,
                                  .gradient = gradient_.data() + place};
      switch (way) {
        case Way::loop_64:
          peer::gerstner_loop(row, 64);
          break;
        case Way::loop_256:
          peer::gerstner_loop(row, std::min(256, grid_.columns));
          break;
        case Way::recurrence:
          peer::gerstner_recurrence(row);
          break;
        case Way::mirrored:
          peer::gerstner_mirrored(row);
          break;
      }
    }
  }
}

}  // namespace offing::bench

#include "host/ocean/query/gerstner_instant.h"

#include <cmath>

#include "host/base/parameter_check.h"
#include "host/ocean/ocean_limits.h"
#include "host/ocean/spectrum/dispersion.h"
#include "host/ocean/surface/wave_clock.h"

namespace offing::ocean {
namespace {

/// Of the wave of an index, where shares are given.
double share_of(std::span<const double> shares, std::size_t wave) {
  return shares.empty() ? 1.0 : shares[wave];
}

/// Phase that a wave of this frequency has gone through, within a turn.
double phase_rad(const WaveClock& clock, double omega_radps, double time_s) {
  const WaveTime time = clock.at(time_s);
  const std::uint32_t rate = clock.rate(omega_radps);
  constexpr double all_turns = 4294967296.0;  // 2^32
  return two_pi *
         (rate * time.ticks / all_turns + rate * static_cast<double>(time.tick_fraction) / all_turns);
}

}  // namespace

GerstnerInstant::GerstnerInstant(const GerstnerSea& sea, double time_s, double min_wavelength_m)
    : horizontal_scale_(ocean::horizontal_scale(sea).scale), water_depth_m_(sea.dispersion.depth_m) {
  require_valid_gerstner_waves(sea);
  require_within("time_s", time_s, -largest_time_s, largest_time_s);
  const WaveClock clock(largest_omega_radps / two_pi, sea.loop_period_s);
  for (const GerstnerWave& wave : sea.waves) {
    if (wave.wavenumber_radpm > largest_wavenumber_radpm(min_wavelength_m)) continue;
    waves_.push_back({.amplitude_m = wave.amplitude_m,
                      .kx_radpm = wave.wavenumber_radpm * std::cos(wave.direction_rad),
                      .kz_radpm = wave.wavenumber_radpm * std::sin(wave.direction_rad),
                      .phase_rad = wave.phase_rad - phase_rad(clock, wave.omega_radps, time_s),
                      .omega_radps = clock.rate(wave.omega_radps) * clock.radps_per_rate()});
  }
  for (const Raindrop& drop : sea.raindrops) {
    const double age_s = time_s - drop.time_s;
    if (age_s < 0.0 || drop.wavelength_m < min_wavelength_m) continue;
    const double k = two_pi / drop.wavelength_m;
    const double radius_m = sea.dispersion.group_speed_mps(k) * age_s;
    rings_.push_back({.centre_x_m = drop.x_m,
                      .centre_z_m = drop.z_m,
                      .wavelength_m = drop.wavelength_m,
                      .radius_m = radius_m,
                      .amplitude_m = drop.amplitude_m * std::exp(-age_s / drop.decay_s),
                      .phase_rad = k * radius_m - sea.dispersion.omega_radps(k) * age_s});
  }
}

GerstnerValues GerstnerInstant::at(double x_m, double z_m, std::span<const double> shares) const {
  GerstnerValues values;
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const Wave& wave = waves_[i];
    const double phase = wave.kx_radpm * x_m + wave.kz_radpm * z_m + wave.phase_rad;
    const double amplitude_m = share_of(shares, i) * wave.amplitude_m;
    const double up = amplitude_m * std::cos(phase), slope = -amplitude_m * std::sin(phase);
    const double per_k = horizontal_scale_ / std::hypot(wave.kx_radpm, wave.kz_radpm);
    values.displacement_x_m += per_k * wave.kx_radpm * slope;
    values.displacement_y_m += up;
    values.displacement_z_m += per_k * wave.kz_radpm * slope;
    values.slope_x += wave.kx_radpm * slope;
    values.slope_z += wave.kz_radpm * slope;
    values.gradient_xx -= per_k * wave.kx_radpm * wave.kx_radpm * up;
    values.gradient_xz -= per_k * wave.kx_radpm * wave.kz_radpm * up;
    values.gradient_zz -= per_k * wave.kz_radpm * wave.kz_radpm * up;
  }
  for (const Ring& ring : rings_) add_ring(ring, x_m, z_m, values);
  return values;
}

void GerstnerInstant::add_ring(const Ring& ring, double x_m, double z_m, GerstnerValues& values) {
  const double x = x_m - ring.centre_x_m, z = z_m - ring.centre_z_m, rounding_m = 0.25 * ring.wavelength_m;
  const double hypotenuse_m = std::hypot(x, z, rounding_m);
  const double distance = (hypotenuse_m - rounding_m) / ring.wavelength_m;
  const double u = distance - ring.radius_m / ring.wavelength_m, phase = two_pi * u + ring.phase_rad;
  const double envelope_m = ring.amplitude_m / std::sqrt(1.0 + distance) * std::exp(-0.25 * u * u);
  const double slope = envelope_m / ring.wavelength_m *
                       ((-0.5 / (1.0 + distance) - 0.5 * u) * std::cos(phase) - two_pi * std::sin(phase)) /
                       hypotenuse_m;
  values.displacement_y_m += envelope_m * std::cos(phase);
  values.slope_x += slope * x;
  values.slope_z += slope * z;
}

/// With z = -d: vertical sinh k(D-d) / sinh kD, horizontal cosh k(D-d) / sinh kD, both e^{-kd} in deep water.
ParticleVelocity GerstnerInstant::velocity(double x_m, double z_m, double depth_m,
                                           std::span<const double> shares) const {
  require_within("depth_m", depth_m, 0.0, water_depth_m_);
  ParticleVelocity velocity;
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const Wave& wave = waves_[i];
    const double k = std::hypot(wave.kx_radpm, wave.kz_radpm);
    const double phase = wave.kx_radpm * x_m + wave.kz_radpm * z_m + wave.phase_rad;
    const double above_bed = std::exp(-2.0 * k * (water_depth_m_ - depth_m));
    const double speed_mps = share_of(shares, i) * wave.omega_radps * wave.amplitude_m *
                             std::exp(-k * depth_m) / (1.0 - std::exp(-2.0 * k * water_depth_m_));
    velocity.x_mps += speed_mps * (1.0 + above_bed) * wave.kx_radpm / k * std::cos(phase);
    velocity.y_mps += speed_mps * (1.0 - above_bed) * std::sin(phase);
    velocity.z_mps += speed_mps * (1.0 + above_bed) * wave.kz_radpm / k * std::cos(phase);
  }
  return velocity;
}

double GerstnerInstant::pressure_head_m(double x_m, double z_m, double depth_m,
                                        std::span<const double> shares) const {
  require_within("depth_m", depth_m, 0.0, water_depth_m_);
  double head_m = 0.0;
  for (std::size_t i = 0; i < waves_.size(); ++i) {
    const Wave& wave = waves_[i];
    const double k = std::hypot(wave.kx_radpm, wave.kz_radpm);
    const double phase = wave.kx_radpm * x_m + wave.kz_radpm * z_m + wave.phase_rad;
    const double above_bed = std::exp(-2.0 * k * (water_depth_m_ - depth_m));
    head_m += share_of(shares, i) * wave.amplitude_m * std::cos(phase) * std::exp(-k * depth_m) *
              (1.0 + above_bed) / (1.0 + std::exp(-2.0 * k * water_depth_m_));
  }
  for (const Ring& ring : rings_) {
    GerstnerValues values;
    add_ring(ring, x_m, z_m, values);
    head_m += values.displacement_y_m * std::exp(-two_pi / ring.wavelength_m * depth_m);
  }
  return head_m;
}

}  // namespace offing::ocean

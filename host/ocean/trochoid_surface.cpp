#include "host/ocean/trochoid_surface.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>

#include "host/ocean/parameter_check.h"
#include "host/ocl/program.h"
#include "host/ocl/tuning.h"

namespace offing::ocean {
namespace {

constexpr double two_pi = 2.0 * std::numbers::pi;
constexpr double largest_time_s = 1e8;
constexpr int strip_lanes = 16;
constexpr double loop_instants = 268435456.0;  // 2^28, the instants of a loop of WaveModes
constexpr double smallest_ring_m = 1e-6;       // lower rings are left out

/// A phase as the kernel reads it: 2^-32 turns in two's complement.
int device_phase(double turns) {
  const double fraction = turns - std::floor(turns);
  const auto units = static_cast<std::uint64_t>(std::llround(fraction * 4294967296.0));
  return std::bit_cast<std::int32_t>(static_cast<std::uint32_t>(units));
}

/// Turns that a wave of this frequency has made, up to whole ones.
double turns_at(double omega_radps, double time_s, std::optional<double> loop_period_s) {
  if (!loop_period_s) return std::fmod(omega_radps / two_pi * time_s, 1.0);
  const double cycles = std::max(1.0, std::round(omega_radps / two_pi * *loop_period_s));
  // Whole cycles times one of 2^28 instants is exact, so that t and t + T give the same bits.
  const double instant = std::round(std::fmod(time_s, *loop_period_s) / *loop_period_s * loop_instants);
  return std::fmod(cycles * (instant / loop_instants), 1.0);
}

TrochoidWave device_wave(const Trochoid& wave, double turns, double horizontal_scale,
                         const SampleGrid& grid) {
  const double cosine = std::cos(wave.direction_rad), sine = std::sin(wave.direction_rad);
  const double k = wave.wavenumber_radpm;
  const double turns_x_per_m = k * cosine / two_pi, turns_z_per_m = k * sine / two_pi;
  const double column_turns = turns_x_per_m * grid.spacing_x_m, row_turns = turns_z_per_m * grid.spacing_z_m;
  const double samples = 1.0 / std::max({std::abs(column_turns), std::abs(row_turns), 1e-12});
  const double a = wave.amplitude_m * shown_share(samples), qa = horizontal_scale * a;
  return {.phase = device_phase(turns_x_per_m * grid.origin_x_m + turns_z_per_m * grid.origin_z_m +
                                wave.phase_rad / two_pi - turns),
          .column_step = device_phase(column_turns),
          .row_step = device_phase(row_turns),
          .amplitude_m = static_cast<float>(a),
          .slope_x = static_cast<float>(a * k * cosine),
          .slope_z = static_cast<float>(a * k * sine),
          .shift_x_m = static_cast<float>(qa * cosine),
          .shift_z_m = static_cast<float>(qa * sine),
          .gradient_xx = static_cast<float>(qa * k * cosine * cosine),
          .gradient_xz = static_cast<float>(qa * k * cosine * sine),
          .gradient_zz = static_cast<float>(qa * k * sine * sine),
          .padding = 0};
}

/// The ring at `age_s` after its drop. A crest keeps the phase k r - omega t; seen from the ring, which moves
/// at the group speed, that is k u + (k c_g - omega) t.
TrochoidRing device_ring(const Raindrop& drop, double age_s, const Dispersion& dispersion,
                         const SampleGrid& grid) {
  const double k = two_pi / drop.wavelength_m;
  const double ring_radius_m = dispersion.group_speed_mps(k) * age_s;
  const double spacing_m = std::max({std::abs(grid.spacing_x_m), std::abs(grid.spacing_z_m), 1e-9});
  const double turns =
      ring_radius_m / drop.wavelength_m - std::fmod(dispersion.omega_radps(k) / two_pi * age_s, 1.0);
  return {.centre_x_m = static_cast<float>(drop.x_m - grid.origin_x_m),
          .centre_z_m = static_cast<float>(drop.z_m - grid.origin_z_m),
          .wavelength_m = static_cast<float>(drop.wavelength_m),
          .ring_radius_m = static_cast<float>(ring_radius_m),
          .amplitude_m = static_cast<float>(drop.amplitude_m * std::exp(-age_s / drop.decay_s) *
                                            shown_share(drop.wavelength_m / spacing_m)),
          .phase = device_phase(turns)};
}

}  // namespace

double shown_share(double samples_per_wavelength) {
  const double x = std::clamp((samples_per_wavelength - 2.0) / 2.0, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

TrochoidSurface::TrochoidSurface(const ocl::Device& device)
    : device_(device),
      lanes_(ocl::tuning_for(device.info(), "trochoids").shape == ocl::KernelShape::strip ? strip_lanes : 1),
      kernel_(ocl::Program::build(device, "ocean/trochoid_surface.cl", ocl::Defines().set("LANES", lanes_))
                  .kernel("trochoid_surface")) {}

void TrochoidSurface::at(const TrochoidSea& sea, const SampleGrid& grid, double time_s) {
  require_valid_trochoids(sea);
  require_valid_grid(grid);
  require_within("time_s", time_s, -largest_time_s, largest_time_s);
  const double scale = horizontal_scale(sea).scale;
  std::vector<TrochoidWave> waves;
  for (const Trochoid& wave : sea.waves) {
    const double turns = turns_at(wave.omega_radps, time_s, sea.loop_period_s);
    const TrochoidWave packed = device_wave(wave, turns, scale, grid);
    if (packed.amplitude_m > 0.0f) waves.push_back(packed);
  }
  std::vector<TrochoidRing> rings;
  for (const Raindrop& drop : sea.raindrops) {
    if (time_s < drop.time_s) continue;
    const TrochoidRing packed = device_ring(drop, time_s - drop.time_s, sea.dispersion, grid);
    if (std::abs(packed.amplitude_m) > smallest_ring_m) rings.push_back(packed);
  }
  if (waves_.size() < std::max<std::size_t>(waves.size(), 1))
    waves_ = ocl::Buffer<TrochoidWave>(device_, std::max<std::size_t>(waves.size(), 1), "trochoids");
  if (rings_.size() < std::max<std::size_t>(rings.size(), 1))
    rings_ = ocl::Buffer<TrochoidRing>(device_, std::max<std::size_t>(rings.size(), 1), "trochoid rings");
  if (!waves.empty()) waves_.write(waves);
  if (!rings.empty()) rings_.write(rings);

  columns_ = grid.columns;
  rows_ = grid.rows;
  pitch_ = std::max(grid.columns, lanes_);
  const std::size_t floats = 4 * static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(rows_);
  if (displacement_.size() != floats) {
    displacement_ = ocl::Buffer<float>(device_, floats, "trochoid displacement");
    gradient_ = ocl::Buffer<float>(device_, floats, "trochoid gradient");
  }
  const TrochoidGrid packed{.spacing_x_m = static_cast<float>(grid.spacing_x_m),
                            .spacing_z_m = static_cast<float>(grid.spacing_z_m),
                            .pitch = pitch_,
                            .wave_count = static_cast<int>(waves.size()),
                            .ring_count = static_cast<int>(rings.size()),
                            .padding = 0};
  const auto rows = static_cast<std::size_t>(rows_);
  const ocl::LaunchShape shape = lanes_ > 1 ? ocl::LaunchShape{{1, rows, 1}, {1, 1, 1}}
                                            : ocl::LaunchShape{{static_cast<std::size_t>(pitch_), rows, 1}};
  kernel_.launch(shape, waves_, rings_, packed, displacement_, gradient_);
}

TrochoidFields TrochoidSurface::read() const {
  TrochoidFields fields;
  fields.columns = columns_;
  fields.rows = rows_;
  const std::size_t count = static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  for (std::vector<float>* field :
       {&fields.displacement_x, &fields.displacement_y, &fields.displacement_z, &fields.slope_x,
        &fields.slope_z, &fields.gradient_xx, &fields.gradient_xz, &fields.gradient_zz}) {
    field->reserve(count);
  }
  if (count == 0) return fields;
  const auto displacement = displacement_.map();
  const auto gradient = gradient_.map();
  for (int row = 0; row < rows_; ++row) {
    for (int column = 0; column < columns_; ++column) {
      const std::size_t sample = 4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(pitch_) +
                                      static_cast<std::size_t>(column));
      fields.displacement_x.push_back(displacement[sample]);
      fields.displacement_y.push_back(displacement[sample + 1]);
      fields.displacement_z.push_back(displacement[sample + 2]);
      fields.gradient_xz.push_back(displacement[sample + 3]);
      fields.slope_x.push_back(gradient[sample]);
      fields.slope_z.push_back(gradient[sample + 1]);
      fields.gradient_xx.push_back(gradient[sample + 2]);
      fields.gradient_zz.push_back(gradient[sample + 3]);
    }
  }
  return fields;
}

}  // namespace offing::ocean

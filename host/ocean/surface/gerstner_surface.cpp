#include "host/ocean/surface/gerstner_surface.h"

#include <algorithm>
#include <cmath>
#include <type_traits>
#include <utility>

#include "host/base/parameter_check.h"
#include "host/ocean/ocean_limits.h"
#include "host/ocean/spectrum/dispersion.h"
#include "host/ocean/surface/device_gerstner_waves.h"
#include "host/ocean/surface/wave_clock.h"
#include "host/ocl/program.h"

namespace offing::ocean {
namespace {

/// The waves that show on a grid, at time 0, as the kernel reads them: [row][pitch], the waves side by side.
PackedWaves pack_waves(const GerstnerSea& sea, const SampleGrid& grid, const WaveClock& clock, int lanes) {
  const double scale = horizontal_scale(sea).scale;
  PackedWaves packed;
  const auto pitch = (std::max<std::size_t>(sea.waves.size(), 1) + lanes - 1) / lanes * lanes;
  packed.pitch = static_cast<int>(pitch);
  packed.turns.resize(GERSTNER_TURNS * pitch);
  packed.amplitudes.resize(GERSTNER_FIELDS * pitch);
  for (const GerstnerWave& wave : sea.waves) {
    const double cosine = std::cos(wave.direction_rad), sine = std::sin(wave.direction_rad);
    const double k = wave.wavenumber_radpm;
    const double turns_x_per_m = k * cosine / two_pi, turns_z_per_m = k * sine / two_pi;
    const double column_turns = turns_x_per_m * grid.spacing_x_m;
    const double row_turns = turns_z_per_m * grid.spacing_z_m;
    const double samples = 1.0 / std::max({std::abs(column_turns), std::abs(row_turns), 1e-12});
    const double a = wave.amplitude_m * shown_share(samples), qa = scale * a;
    if (a <= 0.0) continue;
    const auto place = static_cast<std::size_t>(packed.count++);
    const auto set_turns = [&](int row, std::uint32_t value) { packed.turns[row * pitch + place] = value; };
    set_turns(GERSTNER_PHASE, device_turns(turns_x_per_m * grid.origin_x_m + turns_z_per_m * grid.origin_z_m +
                                           wave.phase_rad / two_pi));
    set_turns(GERSTNER_COLUMN_STEP, device_turns(column_turns));
    set_turns(GERSTNER_ROW_STEP, device_turns(row_turns));
    set_turns(GERSTNER_RATE, clock.rate(wave.omega_radps));
    const auto set_amplitude = [&](int row, double value) {
      packed.amplitudes[row * pitch + place] = static_cast<float>(value);
    };
    set_amplitude(GERSTNER_HEIGHT, a);
    set_amplitude(GERSTNER_GRADIENT_XX, -qa * k * cosine * cosine);
    set_amplitude(GERSTNER_GRADIENT_XZ, -qa * k * cosine * sine);
    set_amplitude(GERSTNER_GRADIENT_ZZ, -qa * k * sine * sine);
    set_amplitude(GERSTNER_SHIFT_X, -qa * cosine);
    set_amplitude(GERSTNER_SHIFT_Z, -qa * sine);
    set_amplitude(GERSTNER_SLOPE_X, -a * k * cosine);
    set_amplitude(GERSTNER_SLOPE_Z, -a * k * sine);
  }
  return packed;
}

std::vector<GerstnerRing> pack_rings(const GerstnerSea& sea, const SampleGrid& grid, double time_s) {
  const double spacing_m = std::max({std::abs(grid.spacing_x_m), std::abs(grid.spacing_z_m), 1e-9});
  std::vector<GerstnerRing> rings;
  for (const Raindrop& drop : sea.raindrops) {
    GerstnerRing ring =
        device_ring(drop, time_s, sea.dispersion, {.x_m = grid.origin_x_m, .z_m = grid.origin_z_m});
    ring.amplitude_m *= static_cast<float>(shown_share(drop.wavelength_m / spacing_m));
    if (is_visible(ring)) rings.push_back(ring);
  }
  return rings;
}

}  // namespace

double shown_share(double samples_per_wavelength) {
  const double x = std::clamp((samples_per_wavelength - 2.0) / 2.0, 0.0, 1.0);
  return x * x * (3.0 - 2.0 * x);
}

GerstnerSurface::GerstnerSurface(const ocl::Device& device)
    : device_(device),
      tuning_(ocl::tuning_for(device.info(), "gerstner_surface")),
      kernel_(
          ocl::Program::build(device, "ocean/gerstner_surface.cl", ocl::Defines().set("LANES", tuning_.lanes))
              .kernel("gerstner_surface")) {}

void GerstnerSurface::at(const GerstnerSea& sea, const SampleGrid& grid, double time_s) {
  require_valid_gerstner_waves(sea);
  require_valid_grid(grid);
  require_within("time_s", time_s, -largest_time_s, largest_time_s);
  const WaveClock clock(largest_omega_radps / two_pi, sea.loop_period_s);
  upload(pack_waves(sea, grid, clock, tuning_.lanes), pack_rings(sea, grid, time_s));

  columns_ = grid.columns;
  rows_ = grid.rows;
  const bool is_simd = tuning_.shape == ocl::KernelShape::simd;
  const int block_columns = 2 * GERSTNER_HALF_VECTORS * tuning_.lanes;
  pitch_ = is_simd ? std::max(grid.columns, block_columns) : grid.columns;
  const std::size_t floats = 4 * static_cast<std::size_t>(pitch_) * static_cast<std::size_t>(rows_);
  if (displacement_.size() != floats) {
    displacement_ = ocl::Buffer<float>(device_, floats, "Gerstner displacement");
    gradient_ = ocl::Buffer<float>(device_, floats, "Gerstner gradient");
  }
  const GerstnerGrid packed{.spacing_x_m = static_cast<float>(grid.spacing_x_m),
                            .spacing_z_m = static_cast<float>(grid.spacing_z_m),
                            .rows = rows_,
                            .pitch = pitch_,
                            .wave_count = waves_.count,
                            .wave_pitch = waves_.pitch,
                            .ring_count = static_cast<int>(rings_.size()),
                            .padding = 0};
  const auto rows = static_cast<std::size_t>(rows_);
  const auto rows_each = static_cast<std::size_t>(tuning_.per_item);
  const ocl::LaunchShape shape = is_simd
                                     ? ocl::LaunchShape{{(rows + rows_each - 1) / rows_each}, {tuning_.group}}
                                     : ocl::LaunchShape{{static_cast<std::size_t>(pitch_), rows, 1}};
  const WaveTime time = clock.at(time_s);
  kernel_.launch(shape, turns_buffer_, amplitudes_buffer_, rings_buffer_, packed, time.ticks,
                 time.tick_fraction, displacement_, gradient_);
}

void GerstnerSurface::upload(PackedWaves waves, std::vector<GerstnerRing> rings) {
  const auto write = [&](auto& buffer, const auto& values, const char* name) {
    using Element = typename std::decay_t<decltype(values)>::value_type;
    if (buffer.size() < std::max<std::size_t>(values.size(), 1))
      buffer = ocl::Buffer<Element>(device_, std::max<std::size_t>(values.size(), 1), name);
    if (!values.empty()) buffer.write(values);
  };
  if (turns_buffer_.empty() || waves != waves_) {
    write(turns_buffer_, waves.turns, "Gerstner phases");
    write(amplitudes_buffer_, waves.amplitudes, "Gerstner amplitudes");
    waves_ = std::move(waves);
  }
  if (rings_buffer_.empty() || !rings.empty()) write(rings_buffer_, rings, "Gerstner rings");
  rings_ = std::move(rings);
}

GerstnerFields GerstnerSurface::read() const {
  GerstnerFields fields;
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

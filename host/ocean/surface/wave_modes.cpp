#include "host/ocean/surface/wave_modes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/dispersion.h"
#include "host/ocean/spectrum/spectrum_table.h"
#include "host/ocean/surface/mode_lattice.h"
#include "host/ocl/program.h"
#include "kernels/shared/mode_layout.h"
#include "kernels/shared/ocean_params.h"

namespace offing::ocean {
namespace {

constexpr double largest_loop_cycles = 4194304.0;  // 2^22: 32 Hz in a loop of a day

double wavenumber_step_radpm(const Cascade& cascade) {
  return two_pi / cascade.patch_length_m;
}

// That of the wave in the corner of the shortest patch: frequencies grow with the wavenumber.
double fastest_hz(const Dispersion& dispersion, std::span<const Cascade> cascades, int size) {
  double shortest_m = cascades.front().patch_length_m;
  for (const Cascade& cascade : cascades) shortest_m = std::min(shortest_m, cascade.patch_length_m);
  const double highest_radpm = two_pi / shortest_m * (size / 2 - 1) * std::numbers::sqrt2;
  return dispersion.omega_radps(highest_radpm) / two_pi;
}

void require_loop_resolves(double loop_period_s, double highest_hz) {
  if (loop_period_s * highest_hz <= largest_loop_cycles) return;
  const double longest_s = std::floor(largest_loop_cycles / highest_hz);
  throw Error(
      ErrorKind::bad_input,
      fmt::format("ocean.loop_period_s: expected at most {:g} s for waves of {:.3g} Hz, the fastest on the "
                  "shortest patch, found {:g} s",
                  longest_s, highest_hz, loop_period_s),
      fmt::format("set loop_period_s to {:g} or less, or choose longer patches or a smaller size",
                  longest_s));
}

}  // namespace

WaveModes::WaveModes(const ocl::Device& device, const SeaSpectrum& spectrum,
                     std::span<const Cascade> cascades, int size, std::optional<double> loop_period_s,
                     const ModalSea* given)
    : device_(device),
      cascades_(cascades.begin(), cascades.end()),
      size_(size),
      columns_(std::max(size / 2, MODE_BLOCK_COLUMNS)),
      clock_(fastest_hz(spectrum.dispersion, cascades, size), loop_period_s),
      is_given_(given != nullptr) {
  if (loop_period_s) require_loop_resolves(*loop_period_s, fastest_hz(spectrum.dispersion, cascades, size));
  const auto n = static_cast<std::size_t>(size);
  const SpectrumTable table = tabulate(spectrum);
  const ocl::Buffer<float> table_buffer(device, table.values, "spectrum table");
  const ocl::Kernel variance_kernel =
      ocl::Program::build(device, "ocean/mode_variance.cl").kernel("mode_variance");
  std::vector<float> steps;
  for (const Cascade& cascade : cascades_) {
    const OceanSpectrumParams params{
        .wavenumber_step_radpm = static_cast<float>(wavenumber_step_radpm(cascade)),
        .k_min_radpm = static_cast<float>(cascade.k_min_radpm),
        .k_max_radpm = static_cast<float>(cascade.k_max_radpm),
        .log_k_first = static_cast<float>(table.log_k_first),
        .log_k_step = static_cast<float>(table.log_k_step),
        .wavenumber_count = table.wavenumber_count,
        .direction_count = table.direction_count,
        .padding = 0};
    steps.push_back(params.wavenumber_step_radpm);
    variance_.emplace_back(device, n * n, "mode variance");
    variance_kernel.launch({{n, n, 1}}, table_buffer, params, size, variance_.back());
  }
  initial_ = ocl::Program::build(device, "ocean/spectrum_initial.cl").kernel("spectrum_initial");
  const std::size_t modes = cascades_.size() * mode_plane_size(columns_, size);
  ModeArrays arrays{.amplitude = {}, .rate = rates(spectrum.dispersion)};
  if (given) {
    arrays.amplitude.resize(4 * modes);
    const auto variances = place_modes(*given, {cascades_, size_, columns_}, clock_, arrays);
    for (std::size_t i = 0; i < variances.size(); ++i) variance_[i].write(variances[i]);
    amplitude_ = ocl::Buffer<float>(device, arrays.amplitude, "wave amplitudes");
  } else {
    amplitude_ = ocl::Buffer<float>(device, 4 * modes, "wave amplitudes");
  }
  rate_ = ocl::Buffer<std::uint32_t>(device, arrays.rate, "wave frequencies");
  wavenumber_step_ = ocl::Buffer<float>(device, steps, "wavenumber steps");
}

std::vector<std::uint32_t> WaveModes::rates(const Dispersion& dispersion) const {
  const std::size_t plane_size = mode_plane_size(columns_, size_);
  std::vector<std::uint32_t> rates(cascades_.size() * plane_size, 0);
  for (std::size_t i = 0; i < cascades_.size(); ++i) {
    const double step = wavenumber_step_radpm(cascades_[i]);
    std::uint32_t* plane = &rates[i * plane_size];
    for (int column = 0; column < size_ / 2; ++column) {
      for (int row = 0; row < size_ / 2; ++row) {
        if (row == 0 && column == 0) continue;
        const std::uint32_t rate = clock_.rate(dispersion.omega_radps(step * std::hypot(row, column)));
        plane[mode_place(row, column, size_)] = rate;
        if (row > 0) plane[mode_place(size_ - row, column, size_)] = rate;
      }
    }
  }
  return rates;
}

void WaveModes::draw(std::uint64_t seed) {
  if (is_given_) return;
  const std::array<std::uint32_t, 2> seed_words{static_cast<std::uint32_t>(seed),
                                                static_cast<std::uint32_t>(seed >> 32)};
  for (int cascade = 0; cascade < cascade_count(); ++cascade) {
    initial_.launch({{static_cast<std::size_t>(columns_), static_cast<std::size_t>(size_), 1}},
                    variance_[static_cast<std::size_t>(cascade)], size_, seed_words, cascade, amplitude_,
                    columns_);
  }
}

std::vector<SeaMode> WaveModes::list() const {
  return list_modes({amplitude_.read(), rate_.read()}, {cascades_, size_, columns_}, clock_);
}

std::vector<float> WaveModes::variance(int cascade) const {
  return variance_[static_cast<std::size_t>(cascade)].read();
}

}  // namespace offing::ocean

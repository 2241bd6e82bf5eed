#include "host/ocean/surface/mode_lattice.h"

#include <cmath>
#include <complex>
#include <cstddef>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "kernels/shared/mode_layout.h"

namespace offing::ocean {
namespace {

using Complex = std::complex<double>;

constexpr Complex imaginary{0.0, 1.0};
constexpr double smallest_share = 1.0 / 4194304.0;  // 2^-22

double step_radpm(const Cascade& cascade) {
  return 2.0 * std::numbers::pi / cascade.patch_length_m;
}

// P and Q of kernels/ocean/spectrum_initial.cl at a place of the arrays.
Complex amplitude_at(const ModeArrays& arrays, std::size_t place, std::size_t plane, int part) {
  return {arrays.amplitude[place + static_cast<std::size_t>(part) * plane],
          arrays.amplitude[place + static_cast<std::size_t>(part + 1) * plane]};
}

}  // namespace

std::vector<SeaMode> list_modes(const ModeArrays& arrays, const ModeShape& shape, const WaveClock& clock) {
  const std::size_t plane = mode_plane_size(shape.columns, shape.size);
  std::vector<SeaMode> modes;
  for (std::size_t cascade = 0; cascade < shape.cascades.size(); ++cascade) {
    const double step = step_radpm(shape.cascades[cascade]);
    for (int column = 0; column < shape.size / 2; ++column) {
      for (int row = 0; row < shape.size; ++row) {
        if (row == shape.size / 2 || (row == 0 && column == 0)) continue;
        const std::size_t in_plane = mode_place(row, column, shape.size);
        const std::size_t place = cascade * 4 * plane + in_plane;
        const Complex p = amplitude_at(arrays, place, plane, 0), q = amplitude_at(arrays, place, plane, 2);
        // h0(K) and h0(-K), of which column 0 has the second in a row of its own.
        const Complex forward = 0.5 * (p + imaginary * q), backward = 0.5 * std::conj(p - imaginary * q);
        const double kx_radpm = column * step,
                     kz_radpm = (row < shape.size / 2 ? row : row - shape.size) * step;
        const double omega_radps = arrays.rate[cascade * plane + in_plane] * clock.radps_per_rate();
        const auto add = [&](Complex h0, Complex opposite, double sign) {
          if (std::abs(h0) <= smallest_share * std::abs(opposite)) return;
          modes.push_back({.amplitude_m = 2.0 * std::abs(h0),
                           .kx_radpm = sign * kx_radpm,
                           .kz_radpm = sign * kz_radpm,
                           .omega_radps = omega_radps,
                           .phase_rad = std::arg(h0),
                           .patch = static_cast<int>(cascade)});
        };
        add(forward, backward, 1.0);
        if (column > 0) add(backward, forward, -1.0);
      }
    }
  }
  return modes;
}

std::vector<std::vector<float>> place_modes(const ModalSea& modes, const ModeShape& shape,
                                            const WaveClock& clock, ModeArrays& arrays) {
  const int n = shape.size;
  const std::size_t plane = mode_plane_size(shape.columns, n);
  std::vector<std::vector<float>> variances(shape.cascades.size(),
                                            std::vector<float>(static_cast<std::size_t>(n) * n, 0.0f));
  arrays.amplitude.assign(arrays.amplitude.size(), 0.0f);
  std::vector<bool> has_rate(arrays.rate.size(), false);
  const auto add = [&](std::size_t cascade, int row, int column, Complex p, Complex q, std::uint32_t rate) {
    const std::size_t in_plane = mode_place(row, column, n);
    float* const target = &arrays.amplitude[cascade * 4 * plane + in_plane];
    target[0] += static_cast<float>(p.real());
    target[plane] += static_cast<float>(p.imag());
    target[2 * plane] += static_cast<float>(q.real());
    target[3 * plane] += static_cast<float>(q.imag());
    std::uint32_t& kept = arrays.rate[cascade * plane + in_plane];
    if (has_rate[cascade * plane + in_plane] && (rate > kept + 1 || kept > rate + 1)) {
      throw Error(
          ErrorKind::bad_input,
          fmt::format(
              "modes: expected one omega for waves that run against each other, got {:.9g} and {:.9g} "
              "rad/s",
              kept * clock.radps_per_rate(), rate * clock.radps_per_rate()),
          "give both the omega of still water");
    }
    has_rate[cascade * plane + in_plane] = true;
    kept = rate;
  };
  for (const SeaMode& mode : modes.modes) {
    if (mode.patch < 0 || mode.patch >= std::ssize(shape.cascades)) continue;
    const auto cascade = static_cast<std::size_t>(mode.patch);
    const Cascade& band = shape.cascades[cascade];
    const double step = step_radpm(band);
    const int x = static_cast<int>(std::lround(mode.kx_radpm / step));
    const int z = static_cast<int>(std::lround(mode.kz_radpm / step));
    const double k_radpm = step * std::hypot(x, z);
    // A mode stands for its cell of the wavenumber plane, which may reach into the band from outside.
    const double half_diagonal_radpm = 0.7072 * step;
    const bool is_in_band =
        k_radpm > band.k_min_radpm - half_diagonal_radpm && k_radpm < band.k_max_radpm + half_diagonal_radpm;
    if (!is_in_band || std::abs(x) >= n / 2 || std::abs(z) >= n / 2) continue;
    if (mode.omega_radps / clock.radps_per_rate() >
        static_cast<double>(std::numeric_limits<std::uint32_t>::max())) {
      throw Error(
          ErrorKind::bad_input,
          fmt::format("modes: expected an omega of water waves, got {:g} rad/s at a wavelength of {:g} m",
                      mode.omega_radps, 2.0 * std::numbers::pi / k_radpm),
          "omega is in rad/s");
    }
    const Complex h0 = std::polar(0.5 * mode.amplitude_m, mode.phase_rad);
    const std::uint32_t rate = clock.rate(mode.omega_radps);
    const auto row = [n](int index) { return index < 0 ? index + n : index; };
    if (x >= 0) add(cascade, row(z), x, h0, -imaginary * h0, rate);
    if (x <= 0) add(cascade, row(-z), -x, std::conj(h0), imaginary * std::conj(h0), rate);
    variances[cascade][static_cast<std::size_t>(row(z)) * n + static_cast<std::size_t>(row(x))] +=
        static_cast<float>(0.5 * mode.amplitude_m * mode.amplitude_m);
  }
  return variances;
}

}  // namespace offing::ocean

#include "tests/ocean/surface/drawn_modes.h"

#include "kernels/shared/mode_layout.h"

namespace offing::ocean {
namespace {

// Calls visit(place in one plane [columns/16][n][16] of the device's arrays, place of K, place of -K) for
// each wave with kx >= 0, once for K = (0, kz) and (0, -kz) each.
template <class Visit>
void for_half_plane(int size, Visit visit) {
  for (int column = 0; column < size / 2; ++column) {
    for (int row = 0; row < size; ++row) {
      if (row == size / 2) continue;
      visit(mode_place(row, column, size), static_cast<std::size_t>(row * size + column),
            static_cast<std::size_t>((size - row) % size * size + (size - column) % size));
    }
  }
}

std::size_t plane_size(const WaveModes& modes) {
  return mode_plane_size(modes.columns(), modes.size());
}

std::size_t mode_count(const WaveModes& modes) {
  return static_cast<std::size_t>(modes.size()) * static_cast<std::size_t>(modes.size());
}

}  // namespace

// P = h0(K) + conj(h0(-K)), Q = -i (h0(K) - conj(h0(-K))), so h0(K) = (P + i Q) / 2, h0(-K) = conj(P - i Q)
// / 2.
ComplexField drawn_amplitudes(const WaveModes& modes, int cascade) {
  using Complex = std::complex<double>;
  const std::size_t plane = plane_size(modes);
  std::vector<float> packed(4 * plane);
  modes.amplitude().read(packed, static_cast<std::size_t>(cascade) * 4 * plane);
  ComplexField amplitudes(mode_count(modes));
  for_half_plane(modes.size(), [&](std::size_t place, std::size_t wave, std::size_t opposite) {
    const Complex p(packed[place], packed[plane + place]);
    const Complex q(packed[2 * plane + place], packed[3 * plane + place]);
    amplitudes[wave] = 0.5 * (p + Complex(0.0, 1.0) * q);
    amplitudes[opposite] = 0.5 * std::conj(p - Complex(0.0, 1.0) * q);
  });
  return amplitudes;
}

std::vector<std::uint32_t> drawn_rates(const WaveModes& modes, int cascade) {
  const std::size_t plane = plane_size(modes);
  std::vector<std::uint32_t> packed(plane);
  modes.rate().read(packed, static_cast<std::size_t>(cascade) * plane);
  std::vector<std::uint32_t> rates(mode_count(modes));
  for_half_plane(modes.size(), [&](std::size_t place, std::size_t wave, std::size_t opposite) {
    rates[wave] = rates[opposite] = packed[place];
  });
  return rates;
}

}  // namespace offing::ocean

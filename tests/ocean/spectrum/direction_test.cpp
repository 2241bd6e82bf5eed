// Waves travel toward +K at omega / k: the phase of a mode advances as K.X - omega t.
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/ocean.h"
#include "tests/ocean/surface/ocean_reference.h"

namespace offing::ocean {
namespace {

constexpr int size = 256;
constexpr double patch_length_m = 1800.0;
constexpr double first_s = 100.0, step_s = 0.5;

struct Advance {
  double forward_share = 0.0;    // of the energy that travels within 90 degrees of the asked direction
  double phase_error_rad = 0.0;  // root mean square, by energy, of the advance against -omega dt
};

// From two frames: modes of the half-plane K . direction > 0, each of which stands for its partner too.
Advance advance_of(const ocl::Device& device, const SeaSpectrum& spectrum, double direction_rad) {
  Ocean sea(device, spectrum, {.size = size, .cascades = {{patch_length_m, 0.0, 1e9}}, .seed = 3});
  const auto modes_at = [&](double time_s) {
    sea.at(time_s);
    const std::vector<float> height = sea.read_surface(0).displacement_y;
    return forward_transform(ComplexField(height.begin(), height.end()), size);
  };
  const ComplexField first = modes_at(first_s), second = modes_at(first_s + step_s);
  double forward = 0.0, error = 0.0, total = 0.0;
  for (int row = -size / 2 + 1; row < size / 2; ++row) {
    for (int column = -size / 2 + 1; column < size / 2; ++column) {
      if (column * std::cos(direction_rad) + row * std::sin(direction_rad) <= 1e-9) continue;
      const auto place = static_cast<std::size_t>((row + size) % size * size + (column + size) % size);
      const double energy = std::norm(first[place]);
      const std::complex<double> turn = second[place] * std::conj(first[place]);
      const double k_radpm = 2.0 * std::numbers::pi / patch_length_m * std::hypot(column, row);
      const double late = std::arg(turn * std::polar(1.0, spectrum.dispersion.omega_radps(k_radpm) * step_s));
      forward += turn.imag() < 0.0 ? energy : 0.0;
      error += energy * late * late;
      total += energy;
    }
  }
  return {forward / total, std::sqrt(error / total)};
}

class DirectionTest : public testing::Test {
 protected:
  ocl::Device device_ = ocl::Device::open();
};

// Fails if waves run backward, sideways, or at another speed than omega / k, in any quadrant or along an
// axis, in deep water or on a shelf. cos^150(theta / 2) leaves 1e-22 of the energy beyond 90 degrees. Modes
// of one part in 1e6 of the energy have a phase to 1e-4 (rounding 1e-7 of the surface); by energy 1e-6 is
// measured; gate 1e-4.
TEST_F(DirectionTest, OneSidedSeasAdvanceTowardK) {
  for (int eighth = 0; eighth < 8; ++eighth) {
    SpectrumParameters parameters;
    parameters.model = SpectrumModel::swell;
    parameters.spreading.direction_rad = eighth * std::numbers::pi / 4.0 + 0.1;
    if (eighth % 2 == 1) parameters.dispersion.depth_m = 25.0;
    const Advance advance =
        advance_of(device_, make_sea_spectrum(parameters), parameters.spreading.direction_rad);
    EXPECT_GT(advance.forward_share, 0.999999) << eighth;
    EXPECT_LT(advance.phase_error_rad, 1e-4) << eighth;
  }
}

// Fails if the sign holds for narrow seas only, such as by a lucky pairing of K and -K: in a wind sea the
// waves that travel ahead outweigh those against them at nearly every K.
TEST_F(DirectionTest, WindSeasAdvanceDownwind) {
  for (const double direction_rad : {0.4, 2.0, 3.5, 5.1}) {
    SpectrumParameters parameters;
    parameters.wind_speed_mps = 17.0;
    parameters.fetch_m = 300e3;
    parameters.spreading.direction_rad = direction_rad;
    EXPECT_GT(advance_of(device_, make_sea_spectrum(parameters), direction_rad).forward_share, 0.95);
  }
}

}  // namespace
}  // namespace offing::ocean

// The same seed gives the same waves: at every size, in every cascade its own, and no others.
#include <cmath>
#include <complex>

#include <gtest/gtest.h>

#include "host/fft/fft2d.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/ocean.h"
#include "tests/ocean/surface/drawn_modes.h"

namespace offing::ocean {
namespace {

constexpr double patch_length_m = 500.0;

class DeterminismTest : public testing::Test {
 protected:
  DeterminismTest() {
    SpectrumParameters parameters;
    parameters.spreading.direction_rad = 0.5;
    spectrum_ = make_sea_spectrum(parameters);
  }
  // One band for all sizes, below the Nyquist wavenumber of 256 samples, so that they share its waves.
  static std::vector<Cascade> cascade(double length_m = patch_length_m) {
    return {{length_m, 0.0, resolved_wavenumber_radpm(length_m, 256)}};
  }
  WaveModes modes(int size, std::uint64_t seed) const {
    WaveModes modes(device_, spectrum_, cascade(), size, {});
    modes.draw(seed);
    return modes;
  }

  ocl::Device device_ = ocl::Device::open();
  SeaSpectrum spectrum_;
};

// Forward transform of the height over n^2: amplitudes of the modes, m.
std::vector<std::complex<double>> height_modes(const ocl::Device& device, Ocean& sea) {
  const SurfaceFields fields = sea.read_surface(0);
  const std::size_t count = fields.displacement_y.size();
  std::vector<float> values(2 * count, 0.0f);
  for (std::size_t i = 0; i < count; ++i) values[2 * i] = fields.displacement_y[i];
  fft::Fft2d forward(device, fields.size, 1, fft::Direction::forward);
  ocl::Buffer<float> buffer(device, values, "height");
  forward.transform(buffer, buffer);
  buffer.read(values);
  std::vector<std::complex<double>> modes;
  for (std::size_t i = 0; i < count; ++i)
    modes.emplace_back(values[2 * i] / static_cast<double>(count),
                       values[2 * i + 1] / static_cast<double>(count));
  return modes;
}

// Calls visit(small place, large place) for every mode of the smaller grid but its Nyquist row and column.
template <class Visit>
void for_shared_modes(int small, int large, Visit visit) {
  for (int row = -small / 2 + 1; row < small / 2; ++row) {
    for (int column = -small / 2 + 1; column < small / 2; ++column) {
      const auto place = [&](int size) {
        return static_cast<std::size_t>((row + size) % size) * static_cast<std::size_t>(size) +
               static_cast<std::size_t>((column + size) % size);
      };
      visit(place(small), place(large));
    }
  }
}

// Fails if amplitudes or frequencies depend on the size: every shared mode within 1e-5 of itself, as drawn
// and as it comes out of the transforms. Those of two sizes, there and back, add rounding errors: 4e-7 of the
// surface's root mean square, spread evenly over n^2 modes, of which the largest of 65000 is 3.3 times the
// mean; gate 8 times.
TEST_F(DeterminismTest, SharedWavesAreTheSameAtEverySize) {
  const WaveModes drawn_small = modes(256, 7);
  const ComplexField amplitude_small = drawn_amplitudes(drawn_small, 0);
  const std::vector<std::uint32_t> rate_small = drawn_rates(drawn_small, 0);
  Ocean sea_small(device_, spectrum_, {.size = 256, .cascades = cascade(), .seed = 7});
  sea_small.at(1234.5);
  const auto height_small = height_modes(device_, sea_small);
  double variance_m2 = 0.0;
  for (const std::complex<double>& mode : height_small) variance_m2 += std::norm(mode);
  const double rounding_m = 4e-7 * std::sqrt(variance_m2) / 256.0;

  for (const int size : {512, 1024}) {
    const WaveModes drawn = modes(size, 7);
    const ComplexField amplitude = drawn_amplitudes(drawn, 0);
    const std::vector<std::uint32_t> rate = drawn_rates(drawn, 0);
    double difference = 0.0;
    int carried = 0;
    for_shared_modes(256, size, [&](std::size_t small, std::size_t large) {
      ASSERT_EQ(rate[large], rate_small[small]);
      const double error = std::abs(amplitude[large] - amplitude_small[small]);
      if (error > 0.0) difference = std::max(difference, error / std::abs(amplitude_small[small]));
      carried += amplitude_small[small] != 0.0 ? 1 : 0;
    });
    EXPECT_LT(difference, 1e-5);
    EXPECT_GT(carried, 40000);

    Ocean sea(device_, spectrum_, {.size = size, .cascades = cascade(), .seed = 7});
    sea.at(1234.5);
    const auto height = height_modes(device_, sea);
    double worst = 0.0;
    for_shared_modes(256, size, [&](std::size_t small, std::size_t large) {
      const double error = std::abs(height[large] - height_small[small]);
      worst = std::max(worst, error / (1e-5 * std::abs(height_small[small]) + 8.0 * rounding_m));
    });
    EXPECT_LT(worst, 1.0);
    RecordProperty("size_" + std::to_string(size), std::to_string(worst));
  }
}

// Fails if two seeds share waves: the correlation of their surfaces is that of independent seas, 0 within
// 3 / sqrt(independent waves), some 600 here.
TEST_F(DeterminismTest, SeedsGiveIndependentSeas) {
  const auto surface = [&](std::uint64_t seed) {
    Ocean sea(device_, spectrum_, {.size = 256, .cascades = cascade(), .seed = seed});
    sea.at(0.0);
    return sea.read_surface(0).displacement_y;
  };
  const std::uint64_t seeds[] = {1, 2, 1ULL << 32, (1ULL << 32) + 1};
  std::vector<std::vector<float>> surfaces;
  for (const std::uint64_t seed : seeds) surfaces.push_back(surface(seed));
  EXPECT_EQ(surface(1), surfaces[0]);
  for (std::size_t i = 0; i < surfaces.size(); ++i) {
    for (std::size_t j = 0; j < i; ++j) {
      double product = 0.0, square_i = 0.0, square_j = 0.0;
      for (std::size_t k = 0; k < surfaces[i].size(); ++k) {
        product += surfaces[i][k] * surfaces[j][k];
        square_i += surfaces[i][k] * surfaces[i][k];
        square_j += surfaces[j][k] * surfaces[j][k];
      }
      EXPECT_LT(std::abs(product) / std::sqrt(square_i * square_j), 0.12) << seeds[i] << " " << seeds[j];
    }
  }
}

// Fails if cascades draw the same numbers: two cascades of one patch length would be the same sea twice.
TEST_F(DeterminismTest, CascadesHaveStreamsOfTheirOwn) {
  const std::vector<Cascade> twice = {cascade()[0], cascade()[0]};
  WaveModes both(device_, spectrum_, twice, 256, {});
  both.draw(7);
  ASSERT_EQ(both.variance(0), both.variance(1));
  const ComplexField first = drawn_amplitudes(both, 0), second = drawn_amplitudes(both, 1);
  int equal = 0, carried = 0;
  for (std::size_t i = 0; i < first.size(); ++i) {
    if (first[i] == 0.0) continue;
    ++carried;
    equal += std::abs(first[i] - second[i]) < 1e-6 * std::abs(first[i]) ? 1 : 0;
  }
  EXPECT_GT(carried, 40000);
  EXPECT_EQ(equal, 0);
}

}  // namespace
}  // namespace offing::ocean

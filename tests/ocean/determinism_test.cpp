// The same seed gives the same waves: at every size, in every cascade its own, and no others.
#include <cmath>
#include <complex>
#include <set>

#include <gtest/gtest.h>

#include "host/fft/fft2d.h"
#include "host/ocean/cascades.h"
#include "host/ocean/ocean.h"
#include "host/ocean/spectrum_parameters.h"
#include "host/ocean/wave_modes.h"

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
// mean; gate 5 times.
TEST_F(DeterminismTest, SharedWavesAreTheSameAtEverySize) {
  const WaveModes drawn_small = modes(256, 7);
  const std::vector<float> amplitude_small = drawn_small.amplitude().read();
  const std::vector<std::uint32_t> rate_small = drawn_small.rate().read();
  Ocean sea_small(device_, spectrum_, {.size = 256, .cascades = cascade(), .seed = 7});
  sea_small.at(1234.5);
  const auto height_small = height_modes(device_, sea_small);
  double variance_m2 = 0.0;
  for (const std::complex<double>& mode : height_small) variance_m2 += std::norm(mode);
  const double rounding_m = 4e-7 * std::sqrt(variance_m2) / 256.0;

  for (const int size : {512, 1024}) {
    const WaveModes drawn = modes(size, 7);
    const std::vector<float> amplitude = drawn.amplitude().read();
    const std::vector<std::uint32_t> rate = drawn.rate().read();
    const auto n = static_cast<std::size_t>(size), rows = static_cast<std::size_t>(drawn.rows());
    double difference = 0.0;
    std::size_t compared = 0;
    for (int row = 0; row < 128; ++row) {
      for (int column = -127; column < 128; ++column) {
        const auto place = [&](std::size_t columns) {
          return static_cast<std::size_t>(row) * columns +
                 (static_cast<std::size_t>(column) + columns) % columns;
        };
        ASSERT_EQ(rate[place(n)], rate_small[place(256)]);
        for (std::size_t plane = 0; plane < 4; ++plane) {
          const double expected = amplitude_small[plane * 128 * 256 + place(256)];
          const double found = amplitude[plane * rows * n + place(n)];
          if (expected != 0.0) {
            difference = std::max(difference, std::abs(found / expected - 1.0));
            ++compared;
          } else {
            ASSERT_EQ(found, 0.0);
          }
        }
      }
    }
    EXPECT_LT(difference, 1e-5);
    EXPECT_GT(compared, 4u * 20000u);

    Ocean sea(device_, spectrum_, {.size = size, .cascades = cascade(), .seed = 7});
    sea.at(1234.5);
    const auto height = height_modes(device_, sea);
    double worst = 0.0;
    for_shared_modes(256, size, [&](std::size_t small, std::size_t large) {
      const double error = std::abs(height[large] - height_small[small]);
      worst = std::max(worst, error / (1e-5 * std::abs(height_small[small]) + 5.0 * rounding_m));
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
  const std::vector<float> amplitude = both.amplitude().read();
  ASSERT_EQ(both.variance(0), both.variance(1));
  const std::size_t half = amplitude.size() / 2;
  std::size_t equal = 0, carried = 0;
  for (std::size_t i = 0; i < half; ++i) {
    if (amplitude[i] == 0.0f) continue;
    ++carried;
    equal += amplitude[i] == amplitude[half + i] ? 1 : 0;
  }
  EXPECT_GT(carried, 80000u);
  EXPECT_LT(equal, 10u);
}

}  // namespace
}  // namespace offing::ocean

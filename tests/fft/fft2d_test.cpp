// SPDX-License-Identifier: GPL-3.0-or-later (this test links FFTW)
// The batched two-dimensional transform against theory and against double-precision references.
//
// Bound on the relative root mean square error: log2(n^2) u (1 + 4 sqrt 2) with u = 2^-24 (Higham 2002, ch.
// 24): 3.2e-6 at n = 16, 9.5e-6 at n = 4096. Measured 1.1e-7 ... 2.3e-7 (random input, all sizes, both
// shapes). Gate 3 u log2(n^2)^(1/2): rounding errors add like a random walk over the stages; three times the
// measured value, so that one lost bit fails and noise does not.
#include "host/fft/fft2d.h"

#include <cmath>
#include <complex>
#include <cstdlib>
#include <numbers>
#include <random>
#include <vector>

#include <fftw3.h>
#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing::fft {
namespace {

using Complex = std::complex<double>;
using Field = std::vector<Complex>;  // [batch][n][n]

double gate(int size) {
  return 3.0 * 0x1p-24 * std::sqrt(2.0 * std::log2(size));
}

std::size_t square(int size) {
  return static_cast<std::size_t>(size) * static_cast<std::size_t>(size);
}

Field random_field(std::size_t count, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<float> uniform(-1.0f, 1.0f);
  Field field(count);
  for (Complex& value : field) {
    const float re = uniform(generator), im = uniform(generator);
    value = {re, im};
  }
  return field;
}

double relative_error(const Field& found, const Field& expected) {
  double error = 0.0, norm = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i) {
    error += std::norm(found[i] - expected[i]);
    norm += std::norm(expected[i]);
  }
  return std::sqrt(error / norm);
}

// The definition, one dimension at a time; for small sizes.
Field definition_2d(const Field& input, int size, Direction direction) {
  const double sign = direction == Direction::forward ? -1.0 : 1.0;
  const auto n = static_cast<std::size_t>(size);
  const auto along = [&](const Field& in, std::size_t stride, std::size_t other) {
    Field out(in.size());
    for (std::size_t line = 0; line < n; ++line) {
      for (std::size_t k = 0; k < n; ++k) {
        Complex sum = 0.0;
        for (std::size_t j = 0; j < n; ++j) {
          const double angle = sign * 2.0 * std::numbers::pi * static_cast<double>(j * k % n) / size;
          sum += in[line * other + j * stride] * std::polar(1.0, angle);
        }
        out[line * other + k * stride] = sum;
      }
    }
    return out;
  };
  return along(along(input, 1, n), n, 1);
}

Field fftw_2d(const Field& input, int size, Direction direction) {
  Field output(input.size());
  // FFTW keeps its input with FFTW_ESTIMATE; its interface has no const.
  auto* in = reinterpret_cast<fftw_complex*>(const_cast<Complex*>(input.data()));
  auto* out = reinterpret_cast<fftw_complex*>(output.data());
  fftw_plan plan = fftw_plan_dft_2d(
      size, size, in, out, direction == Direction::forward ? FFTW_FORWARD : FFTW_BACKWARD, FFTW_ESTIMATE);
  fftw_execute(plan);
  fftw_destroy_plan(plan);
  return output;
}

struct Case {
  const char* shape;  // OFFING_SHAPE: the CPU-shaped or the GPU-shaped family
  int size;
};

void PrintTo(const Case& c, std::ostream* out) {
  *out << c.shape << " " << c.size;
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
  return std::string(info.param.shape) + "_" + std::to_string(info.param.size);
}

class Fft2dReferenceTest : public testing::TestWithParam<Case> {
 protected:
  void SetUp() override { setenv("OFFING_SHAPE", GetParam().shape, 1); }
  void TearDown() override { unsetenv("OFFING_SHAPE"); }

  int size() const { return GetParam().size; }

  Field transform(const Field& input, Direction direction, int batch = 1) {
    std::vector<float> values(input.size() * 2);
    for (std::size_t i = 0; i < input.size(); ++i) {
      values[2 * i] = static_cast<float>(input[i].real());
      values[2 * i + 1] = static_cast<float>(input[i].imag());
    }
    Fft2d fft(device_, size(), batch, direction);
    const ocl::Buffer<float> in(device_, values, "input");
    ocl::Buffer<float> out(device_, values.size(), "output");
    fft.transform(in, out);
    out.read(values);
    Field output(input.size());
    for (std::size_t i = 0; i < output.size(); ++i) output[i] = {values[2 * i], values[2 * i + 1]};
    return output;
  }

  ocl::Device device_ = ocl::Device::open();
};

class Fft2dTest : public Fft2dReferenceTest {};  // properties, on the sizes that show them

// Would fail on any wrong twiddle, order, or sign: both directions of a random field against a double
// reference.
TEST_P(Fft2dReferenceTest, AgreesWithDoubleReference) {
  const Field input = random_field(square(size()), 7);
  for (const Direction direction : {Direction::inverse, Direction::forward}) {
    const Field expected =
        size() <= 64 ? definition_2d(input, size(), direction) : fftw_2d(input, size(), direction);
    EXPECT_LT(relative_error(transform(input, direction), expected), gate(size()));
  }
}

// Would fail if one transform of a batch read or wrote another's data.
TEST_P(Fft2dTest, TransformsEachFieldOfABatch) {
  const int batch = 3;
  const Field input = random_field(square(size()) * batch, 11);
  const Field output = transform(input, Direction::inverse, batch);
  for (int b = 0; b < batch; ++b) {
    const auto first = static_cast<std::ptrdiff_t>(square(size())) * b;
    const auto last = first + static_cast<std::ptrdiff_t>(square(size()));
    const Field one(input.begin() + first, input.begin() + last);
    EXPECT_LT(relative_error(Field(output.begin() + first, output.begin() + last),
                             fftw_2d(one, size(), Direction::inverse)),
              gate(size()));
  }
}

// Would fail if rows and columns were exchanged: an impulse at (row 1, column 2) gives e^{2 pi i (z + 2 x) /
// n}. Every value is one product of twiddles: 4 u absolute (two roundings of the tables, two of the product).
TEST_P(Fft2dTest, ImpulseGivesAPlaneWave) {
  Field input(square(size()));
  input[static_cast<std::size_t>(size()) + 2] = 1.0;
  const Field output = transform(input, Direction::inverse);
  double worst = 0.0;
  for (int z = 0; z < size(); ++z) {
    for (int x = 0; x < size(); ++x) {
      const Complex expected = std::polar(1.0, 2.0 * std::numbers::pi * ((z + 2 * x) % size()) / size());
      worst = std::max(worst, std::abs(output[static_cast<std::size_t>(z * size() + x)] - expected));
    }
  }
  // Measured 2.4e-7: up to four rotations in a row, each within 2 u.
  EXPECT_LT(worst, 16 * 0x1p-24);
}

// Theory: a shift by (dz, dx) multiplies the transform by a phase; a wrong index in any pass breaks it.
TEST_P(Fft2dTest, ShiftTurnsThePhase) {
  const int dz = 3, dx = 5;
  const Field input = random_field(square(size()), 13);
  Field shifted(input.size());
  for (int z = 0; z < size(); ++z) {
    for (int x = 0; x < size(); ++x) {
      shifted[static_cast<std::size_t>((z + dz) % size() * size() + (x + dx) % size())] =
          input[static_cast<std::size_t>(z * size() + x)];
    }
  }
  Field expected = transform(input, Direction::inverse);
  for (int z = 0; z < size(); ++z) {
    for (int x = 0; x < size(); ++x) {
      expected[static_cast<std::size_t>(z * size() + x)] *=
          std::polar(1.0, 2.0 * std::numbers::pi * ((z * dz + x * dx) % size()) / size());
    }
  }
  EXPECT_LT(relative_error(transform(shifted, Direction::inverse), expected), 2 * gate(size()));
}

TEST_P(Fft2dTest, IsLinear) {
  const Field a = random_field(square(size()), 17), b = random_field(square(size()), 19);
  Field sum(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) sum[i] = 2.0 * a[i] - 0.5 * b[i];
  const Field of_a = transform(a, Direction::inverse), of_b = transform(b, Direction::inverse);
  Field expected(a.size());
  for (std::size_t i = 0; i < a.size(); ++i) expected[i] = 2.0 * of_a[i] - 0.5 * of_b[i];
  EXPECT_LT(relative_error(transform(sum, Direction::inverse), expected), 2 * gate(size()));
}

// Parseval: sum |X|^2 = n^2 sum |x|^2; and forward after inverse gives n^2 times the input.
TEST_P(Fft2dTest, KeepsEnergyAndInverts) {
  const Field input = random_field(square(size()), 23);
  const Field output = transform(input, Direction::inverse);
  double before = 0.0, after = 0.0;
  for (std::size_t i = 0; i < input.size(); ++i) {
    before += std::norm(input[i]);
    after += std::norm(output[i]);
  }
  const auto count = static_cast<double>(square(size()));
  // Twice the amplitude error, to first order.
  EXPECT_NEAR(after / (before * count), 1.0, 2 * gate(size()));
  Field back = transform(output, Direction::forward);
  for (Complex& value : back) value /= count;
  EXPECT_LT(relative_error(back, input), 2 * gate(size()));
}

std::vector<Case> cases_up_to(int largest_simd, int largest_group) {
  std::vector<Case> cases;
  for (int size = 16; size <= largest_simd; size *= 2) cases.push_back({"simd", size});
  for (int size = 16; size <= largest_group; size *= 2) cases.push_back({"workgroup", size});
  return cases;
}
// All sizes and both shapes against a double reference; a CPU runs the GPU shape a work-item at a time, so
// its largest sizes are few. Properties need no more than one size of each kind of plan.
INSTANTIATE_TEST_SUITE_P(Sizes, Fft2dReferenceTest, testing::ValuesIn(cases_up_to(4096, 4096)), case_name);
INSTANTIATE_TEST_SUITE_P(Sizes, Fft2dTest, testing::ValuesIn(cases_up_to(512, 256)), case_name);

TEST(Fft2d, RefusesWrongSizes) {
  const ocl::Device device = ocl::Device::open();
  for (const int size : {0, -16, 8, 100, 8192})
    EXPECT_THROW(Fft2d(device, size, 1, Direction::inverse), Error);
  EXPECT_THROW(Fft2d(device, 16, 0, Direction::inverse), Error);
}

TEST(Fft2d, RefusesShortBuffers) {
  const ocl::Device device = ocl::Device::open();
  Fft2d fft(device, 16, 2, Direction::inverse);
  const ocl::Buffer<float> enough(device, fft.float_count(), "enough");
  ocl::Buffer<float> short_one(device, fft.float_count() - 1, "short");
  EXPECT_THROW(fft.transform(enough, short_one), Error);
}

}  // namespace
}  // namespace offing::fft

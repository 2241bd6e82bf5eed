#include "tests/ocean/surface/ocean_reference.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "kernels/shared/random.h"

namespace offing::ocean {
namespace {

using Complex = std::complex<double>;
using std::numbers::pi;

// Wave number of an index in units of the patch's wavenumber step.
int wave_of(int index, int size) {
  return index < size / 2 ? index : index - size;
}

std::size_t place_of(int column, int row, int size) {
  return static_cast<std::size_t>((row + size) % size) * static_cast<std::size_t>(size) +
         static_cast<std::size_t>((column + size) % size);
}

Complex initial_amplitude(double variance_m2, std::uint64_t seed, int cascade, int column, int row) {
  const PhiloxBlock block =
      philox_block(static_cast<std::uint32_t>(seed), static_cast<std::uint32_t>(seed >> 32),
                   OFFING_STREAM_OCEAN_CASCADE + static_cast<std::uint32_t>(cascade), column, row, 0);
  const auto uniform = [&](int word) { return ((block.v[word] >> 9) + 0.5) / 8388608.0; };
  return std::polar(0.5 * std::sqrt(variance_m2) * std::sqrt(-2.0 * std::log(uniform(0))),
                    2.0 * pi * uniform(1));
}

// Radix 2, decimation in time, straight from the definition: even and odd values, then both halves.
void transform_line(Complex* values, std::size_t count, double sign) {
  if (count == 1) return;
  const std::size_t half = count / 2;
  std::vector<Complex> parts(count);
  for (std::size_t i = 0; i < count; ++i) parts[i / 2 + i % 2 * half] = values[i];
  transform_line(parts.data(), half, sign);
  transform_line(parts.data() + half, half, sign);
  for (std::size_t i = 0; i < half; ++i) {
    const Complex odd =
        std::polar(1.0, sign * pi * static_cast<double>(i) / static_cast<double>(half)) * parts[half + i];
    values[i] = parts[i] + odd;
    values[half + i] = parts[i] - odd;
  }
}

ComplexField transform(ComplexField values, int size, double sign) {
  const auto n = static_cast<std::size_t>(size);
  for (std::size_t row = 0; row < n; ++row) transform_line(&values[row * n], n, sign);
  std::vector<Complex> line(n);
  for (std::size_t column = 0; column < n; ++column) {
    for (std::size_t row = 0; row < n; ++row) line[row] = values[row * n + column];
    transform_line(line.data(), n, sign);
    for (std::size_t row = 0; row < n; ++row) values[row * n + column] = line[row];
  }
  return values;
}

}  // namespace

ComplexField inverse_transform(const ComplexField& spectrum, int size) {
  return transform(spectrum, size, 1.0);
}

ComplexField forward_transform(const ComplexField& field, int size) {
  return transform(field, size, -1.0);
}

OceanReference::OceanReference(const Dispersion& dispersion, const OceanParameters& parameters,
                               const std::vector<std::vector<float>>& variance)
    : dispersion_(dispersion), parameters_(parameters) {
  const int n = parameters.size;
  for (std::size_t cascade = 0; cascade < variance.size(); ++cascade) {
    ComplexField initial(variance[cascade].size());
    for (int row = -n / 2 + 1; row < n / 2; ++row) {
      for (int column = -n / 2 + 1; column < n / 2; ++column) {
        const std::size_t place = place_of(column, row, n);
        initial[place] = initial_amplitude(variance[cascade][place], parameters.seed,
                                           static_cast<int>(cascade), column, row);
      }
    }
    initial_.push_back(std::move(initial));
  }
}

double OceanReference::omega_radps(int cascade, int column, int row, Frequencies frequencies) const {
  const double step_radpm = 2.0 * pi / parameters_.cascades[static_cast<std::size_t>(cascade)].patch_length_m;
  const double exact = dispersion_.omega_radps(step_radpm * std::hypot(column, row));
  if (frequencies == Frequencies::exact) return exact;
  if (parameters_.loop_period_s) {
    return 2.0 * pi / *parameters_.loop_period_s *
           std::max(1.0, std::round(exact / (2.0 * pi) * *parameters_.loop_period_s));
  }
  const double clock_hz = std::max(0x1p-27, 0x1p-32 * std::exp2(std::floor(std::log2(fastest_hz())) + 1.0));
  return 2.0 * pi * clock_hz * std::round(exact / (2.0 * pi) / clock_hz);
}

double OceanReference::fastest_hz() const {
  double fastest_radps = 0.0;
  for (std::size_t cascade = 0; cascade < initial_.size(); ++cascade) {
    const int last = parameters_.size / 2 - 1;
    fastest_radps =
        std::max(fastest_radps, omega_radps(static_cast<int>(cascade), last, last, Frequencies::exact));
  }
  return fastest_radps / (2.0 * pi);
}

OceanReference::Evolved OceanReference::evolved(int cascade, double time_s, Frequencies frequencies) const {
  const int n = parameters_.size;
  const ComplexField& initial = initial_[static_cast<std::size_t>(cascade)];
  Evolved evolved{ComplexField(initial.size()), ComplexField(initial.size())};
  for (int row = -n / 2 + 1; row < n / 2; ++row) {
    for (int column = -n / 2 + 1; column < n / 2; ++column) {
      const double omega = omega_radps(cascade, column, row, frequencies);
      // Long double, because the phase at a year is 1e8 turns.
      const auto phase = static_cast<double>(
          std::fmod(static_cast<long double>(omega) * time_s, 2.0L * std::numbers::pi_v<long double>));
      const std::size_t place = place_of(column, row, n);
      const Complex along = initial[place] * std::polar(1.0, -phase);
      const Complex against = std::conj(initial[place_of(-column, -row, n)]) * std::polar(1.0, phase);
      evolved.height[place] = along + against;
      evolved.rise[place] = Complex(0.0, -omega) * (along - against);
    }
  }
  return evolved;
}

// The real field whose spectrum is factor(kx, kz) times `spectrum`, wavenumbers in rad/m.
template <class Factor>
RealField OceanReference::field(int cascade, const ComplexField& spectrum, Factor factor) const {
  const int n = parameters_.size;
  const double step_radpm = 2.0 * pi / parameters_.cascades[static_cast<std::size_t>(cascade)].patch_length_m;
  ComplexField product(spectrum.size());
  for (int row = 0; row < n; ++row) {
    for (int column = 0; column < n; ++column) {
      if (row == 0 && column == 0) continue;
      const std::size_t place = place_of(column, row, n);
      product[place] =
          factor(step_radpm * wave_of(column, n), step_radpm * wave_of(row, n)) * spectrum[place];
    }
  }
  const ComplexField values = inverse_transform(product, n);
  RealField field(values.size());
  std::transform(values.begin(), values.end(), field.begin(), [](const Complex& v) { return v.real(); });
  return field;
}

ReferenceSurface OceanReference::surface(int cascade, double time_s, Frequencies frequencies) const {
  const ComplexField height = evolved(cascade, time_s, frequencies).height;
  const double a = parameters_.choppiness;
  const auto make = [&](auto factor) { return field(cascade, height, factor); };
  ReferenceSurface fields{
      .displacement_x = make([a](double x, double z) { return Complex(0.0, a * x / std::hypot(x, z)); }),
      .displacement_y = make([](double, double) { return Complex(1.0); }),
      .displacement_z = make([a](double x, double z) { return Complex(0.0, a * z / std::hypot(x, z)); }),
      .slope_x = make([](double x, double) { return Complex(0.0, x); }),
      .slope_z = make([](double, double z) { return Complex(0.0, z); }),
      .gradient_xx = make([a](double x, double z) { return Complex(-a * x * x / std::hypot(x, z)); }),
      .gradient_xz = make([a](double x, double z) { return Complex(-a * x * z / std::hypot(x, z)); }),
      .gradient_zz = make([a](double x, double z) { return Complex(-a * z * z / std::hypot(x, z)); }),
      .jacobian = {},
      .jacobian_min_eigenvalue = {}};
  for (std::size_t i = 0; i < fields.gradient_xx.size(); ++i) {
    const double xx = 1.0 + fields.gradient_xx[i], xz = fields.gradient_xz[i],
                 zz = 1.0 + fields.gradient_zz[i];
    fields.jacobian.push_back(xx * zz - xz * xz);
    fields.jacobian_min_eigenvalue.push_back(0.5 * (xx + zz) - std::hypot(0.5 * (xx - zz), xz));
  }
  return fields;
}

ReferenceVelocity OceanReference::velocity(int cascade, double time_s, double depth_m,
                                           Frequencies frequencies) const {
  const ComplexField rise = evolved(cascade, time_s, frequencies).rise;
  const double bed_m = dispersion_.depth_m;
  // sinh k(D - d) / sinh kD; both e^{-kd} where the hyperbolic functions would overflow.
  const auto vertical = [=](double k) {
    return k * bed_m > 300.0 ? std::exp(-k * depth_m)
                             : std::sinh(k * (bed_m - depth_m)) / std::sinh(k * bed_m);
  };
  const auto horizontal = [=](double k) {
    return k * bed_m > 300.0 ? std::exp(-k * depth_m)
                             : std::cosh(k * (bed_m - depth_m)) / std::sinh(k * bed_m);
  };
  const auto make = [&](auto factor) { return field(cascade, rise, factor); };
  return {make([&](double x, double z) {
            const double k = std::hypot(x, z);
            return Complex(0.0, x / k * horizontal(k));
          }),
          make([&](double x, double z) { return Complex(vertical(std::hypot(x, z))); }),
          make([&](double x, double z) {
            const double k = std::hypot(x, z);
            return Complex(0.0, z / k * horizontal(k));
          })};
}

}  // namespace offing::ocean

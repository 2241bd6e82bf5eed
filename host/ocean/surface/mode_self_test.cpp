#include "host/ocean/surface/mode_self_test.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <complex>
#include <cstdint>
#include <cstdlib>
#include <functional>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "host/ocl/buffer.h"
#include "kernels/shared/mode_layout.h"
#include "kernels/shared/query_params.h"

namespace offing::ocean {
namespace {

using Complex = std::complex<double>;
using HalfRow = std::vector<Complex>;  // [n/2] of kx = 0 ... n/2 - 1, in steps

// The device's values are P + iQ of shared/mode_layout.h at t = 0: the height is P, and dh/dt is Q at one
// radian a second.
constexpr int usual_planes = 4;
constexpr int height_plane = 0, rate_plane = 2;

constexpr int row_budget = 1 << 22;  // modes times rows

class RandomModes {
 public:
  /// The row of the shortest waves along z: kernels read it, or leave it out as they may.
  enum class LastRow { full, empty };

  /// Of `size` rows, for fields of `samples` along a side.
  RandomModes(int size, int samples, int planes, LastRow last_row)
      : size_(size),
        samples_(samples),
        columns_((size / 2 + MODE_BLOCK_COLUMNS - 1) / MODE_BLOCK_COLUMNS * MODE_BLOCK_COLUMNS),
        amplitude_(static_cast<std::size_t>(planes) * mode_plane_size(columns_, size), 0.0f),
        roots_(static_cast<std::size_t>(samples)) {
    for (int j = 0; j < samples; ++j)
      roots_[static_cast<std::size_t>(j)] = std::polar(1.0, 2.0 * std::numbers::pi * j / samples);
    std::mt19937 random(1);
    // Column 0 stays 0: its rows would have to be conjugate to each other. So do waves that the samples do
    // not tell apart.
    const int most = std::min(size, samples) / 2;
    for (int plane = 0; plane < planes; ++plane) {
      for (int row = 0; row < size; ++row) {
        if (last_row == LastRow::empty && std::abs(signed_row(row)) >= most) continue;
        for (int column = 1; column < most; ++column)
          amplitude_[place(plane, row, column)] = static_cast<float>(random()) * 0x1p-31f - 1.0f;
      }
    }
  }

  int samples() const { return samples_; }
  std::size_t plane_size() const { return mode_plane_size(columns_, size_); }
  const std::vector<float>& amplitude() const { return amplitude_; }
  /// Wavenumbers up to 1 rad/m along each axis.
  float step_radpm() const { return 2.0f / static_cast<float>(size_); }

  /// The sum over kz of kz^power A e^{i kz z}, over k if `by_wavenumber`.
  HalfRow column_sums(int plane, int power, bool by_wavenumber, int z) const {
    HalfRow sums(static_cast<std::size_t>(size_ / 2));
    const double step = step_radpm();
    for (int row = 0; row < size_; ++row) {
      const double kz = step * signed_row(row);
      const Complex factor = root(signed_row(row), z) * std::pow(kz, power);
      for (int column = 1; column < size_ / 2; ++column) {
        const Complex value(amplitude_[place(plane, row, column)], amplitude_[place(plane + 1, row, column)]);
        const double kx = step * column, scale = by_wavenumber ? 1.0 / std::sqrt(kx * kx + kz * kz) : 1.0;
        sums[static_cast<std::size_t>(column)] += factor * value * scale;
      }
    }
    return sums;
  }

  /// A row of the real field: twice the real part of the sum over kx of factor kx^power S e^{i kx x}.
  std::vector<double> real_row(const HalfRow& sums, Complex factor, int power) const {
    std::vector<double> row(static_cast<std::size_t>(samples_), 0.0);
    for (int column = 1; column < size_ / 2; ++column) {
      const double kx = static_cast<double>(step_radpm()) * column;
      const Complex value = 2.0 * factor * std::pow(kx, power) * sums[static_cast<std::size_t>(column)];
      for (int x = 0; x < samples_; ++x) row[static_cast<std::size_t>(x)] += (value * root(column, x)).real();
    }
    return row;
  }

 private:
  std::size_t place(int plane, int row, int column) const {
    return static_cast<std::size_t>(plane) * plane_size() + mode_place(row, column, size_);
  }
  int signed_row(int row) const { return row < size_ / 2 ? row : row - size_; }
  const Complex& root(int a, int b) const {
    return roots_[static_cast<std::size_t>((a * b) & (samples_ - 1))];
  }

  int size_, samples_, columns_;
  std::vector<float> amplitude_;  // [planes][columns/16][n][16]
  std::vector<Complex> roots_;    // e^{2 pi i j / samples}
};

// What the kernels read, on the device.
struct ModeBuffers {
  ModeBuffers(const ocl::Device& device, const RandomModes& modes)
      : amplitude(device, modes.amplitude(), "self-test amplitudes"),
        rate(device, modes.plane_size(), "self-test rates"),
        wavenumber_step(device, std::vector{modes.step_radpm()}, "self-test wavenumber step") {
    rate.fill(1u);
  }
  ocl::Buffer<float> amplitude;
  ocl::Buffer<std::uint32_t> rate;
  ocl::Buffer<float> wavenumber_step;
};

ocl::Buffer<float> map_for(const ocl::Device& device, int size) {
  const auto n = static_cast<std::size_t>(size);
  return {device, 4 * n * n, "self-test map"};
}

// The rows that a map is compared on: spread over the work-groups, at all places in them.
std::vector<int> compared_rows(int size) {
  const int count = std::clamp(row_budget / (size * size), 2, size), stride = size / count;
  std::vector<int> rows;
  for (int i = 0; i < count; ++i) rows.push_back(i * stride + 5 * i % stride);
  return rows;
}

// Four real fields of a map [n][n] float4, at a row.
using RowOfMap = std::array<std::vector<double>, 4>;

// The sum of the relative errors of the pairs of fields that complex transforms make. NaN stays NaN.
double relative_error(const RandomModes& modes, const ocl::Buffer<float>& map,
                      const std::array<std::pair<int, int>, 2>& pairs,
                      const std::function<RowOfMap(int z)>& expected_row) {
  const auto n = static_cast<std::size_t>(modes.samples());
  std::vector<float> found(4 * n);
  std::array<double, 4> error{}, norm{};
  for (const int z : compared_rows(modes.samples())) {
    map.read(found, static_cast<std::size_t>(z) * found.size());
    const RowOfMap expected = expected_row(z);
    for (std::size_t field = 0; field < 4; ++field) {
      for (std::size_t x = 0; x < n; ++x) {
        const double difference = found[4 * x + field] - expected[field][x];
        error[field] += difference * difference;
        norm[field] += expected[field][x] * expected[field][x];
      }
    }
  }
  double sum = 0.0;
  for (const auto& [a, b] : pairs) {
    const auto i = static_cast<std::size_t>(a), j = static_cast<std::size_t>(b);
    sum += std::sqrt((error[i] + error[j]) / (norm[i] + norm[j]));
  }
  return sum;
}

constexpr Complex i_unit{0.0, 1.0};

}  // namespace

double surface_self_test(const ocl::Device& device, ModeTransform& transform, const ModeTransform::Grid& grid,
                         const ModeTransform::Request& /*request*/) {
  const int size = grid.size;
  const RandomModes modes(size, size, usual_planes, RandomModes::LastRow::full);
  const ModeBuffers buffers(device, modes);
  ocl::Buffer<float> displacement = map_for(device, size), gradient = map_for(device, size);
  transform.advance(buffers.amplitude, buffers.rate, buffers.wavenumber_step, 0u, 0.0f, 1.0f);
  transform.assemble(buffers.wavenumber_step, displacement, gradient);
  // (dx, dz) = i K/k h at choppiness 1; slopes are i K h: ocean/surface_assemble.cl.
  const auto displacement_row = [&](int z) -> RowOfMap {
    const HalfRow chop = modes.column_sums(height_plane, 0, true, z);
    const HalfRow chop_kz = modes.column_sums(height_plane, 1, true, z);
    return {modes.real_row(chop, i_unit, 1),
            modes.real_row(modes.column_sums(height_plane, 0, false, z), 1.0, 0),
            modes.real_row(chop_kz, i_unit, 0), modes.real_row(chop_kz, -1.0, 1)};
  };
  const auto gradient_row = [&](int z) -> RowOfMap {
    return {modes.real_row(modes.column_sums(height_plane, 0, false, z), i_unit, 1),
            modes.real_row(modes.column_sums(height_plane, 1, false, z), i_unit, 0),
            modes.real_row(modes.column_sums(height_plane, 0, true, z), -1.0, 2),
            modes.real_row(modes.column_sums(height_plane, 2, true, z), -1.0, 0)};
  };
  return relative_error(modes, displacement, {{{0, 2}, {1, 3}}}, displacement_row) +
         relative_error(modes, gradient, {{{0, 1}, {2, 3}}}, gradient_row);
}

double velocity_self_test(const ocl::Device& device, ModeTransform& transform,
                          const ModeTransform::Grid& grid, const ModeTransform::Request& /*request*/) {
  const int size = grid.size;
  const RandomModes modes(size, size, usual_planes, RandomModes::LastRow::full);
  const ModeBuffers buffers(device, modes);
  ocl::Buffer<float> velocity = map_for(device, size);
  // At the surface of bottomless water, where no factor is left but that of the direction.
  const float radps_per_rate = 1.0f, depth_below_surface_m = 0.0f, water_depth_m = 1e6f;
  transform.advance(buffers.amplitude, buffers.rate, buffers.wavenumber_step, 0u, 0.0f, radps_per_rate,
                    depth_below_surface_m, water_depth_m);
  transform.assemble(buffers.wavenumber_step, velocity);
  return relative_error(modes, velocity, {{{0, 2}, {1, 3}}}, [&](int z) -> RowOfMap {
    return {modes.real_row(modes.column_sums(rate_plane, 0, true, z), i_unit, 1),
            modes.real_row(modes.column_sums(rate_plane, 0, false, z), 1.0, 0),
            modes.real_row(modes.column_sums(rate_plane, 1, true, z), i_unit, 0),
            modes.real_row(modes.column_sums(height_plane, 0, false, z), 1.0, 0)};
  });
}

// Shorts of seven standard deviations alone make the limit's half.
double query_map_self_test(const ocl::Device& device, ModeTransform& transform,
                           const ModeTransform::Grid& grid, const ModeTransform::Request& request) {
  const auto n = static_cast<std::size_t>(grid.size),
             map_fields = static_cast<std::size_t>(request.half_fields);
  const RandomModes modes(request.mode_rows, grid.size, 2 * QUERY_FIELDS, RandomModes::LastRow::empty);
  const ocl::Buffer<float> fields(device, modes.amplitude(), "self-test fields");
  ocl::Buffer<float> filter(device, static_cast<std::size_t>(std::max(request.mode_rows, grid.size)),
                            "self-test filter");
  filter.fill(1.0f);
  // Of derivatives in cycles, which for modes() are half as many as its wavenumbers' steps.
  const double cycles_per_radpm = 1.0 / static_cast<double>(modes.step_radpm());
  const auto expected_row = [&](std::size_t field, int z) {
    const int source = 2 * std::max(static_cast<int>(field) - 1, 0);
    const HalfRow sums = modes.column_sums(source, field == 1 ? 1 : 0, false, z);
    std::vector<double> row = modes.real_row(sums, field < 2 ? i_unit : 1.0, field == 0 ? 1 : 0);
    for (double& value : row) value *= field < 2 ? cycles_per_radpm : 1.0;
    return row;
  };
  const std::vector<int> rows = compared_rows(grid.size);
  std::vector<float> inverse_scales;
  std::vector<std::vector<std::vector<double>>> expected(QUERY_MAP_FIELDS);
  for (std::size_t field = 0; field < map_fields; ++field) {
    double squares = 0.0;
    for (const int z : rows) {
      expected[field].push_back(expected_row(field, z));
      for (const double value : expected[field].back()) squares += value * value;
    }
    const double rms = std::sqrt(squares / static_cast<double>(rows.size() * n));
    inverse_scales.push_back(static_cast<float>(QUERY_MAP_LARGEST / (7.0 * rms)));
  }
  inverse_scales.resize(QUERY_MAP_FIELDS, 1.0f);
  const ocl::Buffer<float> scales(device, inverse_scales, "self-test scales");
  const std::size_t pitch = (n + QUERY_MAP_HALO) * map_fields / 2;
  ocl::Buffer<float> map(device, n * pitch, "self-test map");
  transform.advance(fields, filter);
  transform.assemble(scales, map);
  double worst = 0.0;
  std::vector<float> row(n * map_fields / 2);
  for (std::size_t field = 0; field < map_fields; ++field) {
    double error = 0.0, norm = 0.0;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      map.read(row, static_cast<std::size_t>(rows[i]) * pitch);
      for (std::size_t x = 0; x < n; ++x) {
        const auto pair = std::bit_cast<std::array<std::int16_t, 2>>(row[(x * map_fields + field) / 2]);
        const double found = pair[field % 2] / static_cast<double>(inverse_scales[field]);
        error += std::pow(found - expected[field][i][x], 2);
        norm += std::pow(expected[field][i][x], 2);
      }
    }
    const double relative = std::sqrt(error / norm);
    worst = relative <= worst ? worst : relative;  // also where it is not a number
  }
  return worst;
}

}  // namespace offing::ocean

#include "host/terrain/generate/fractal_terrain.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "kernels/shared/random.h"

namespace offing::terrain {
namespace {

// How much steep ground weakens the octaves that follow: at a slope of 1 to a third.
constexpr double weakening = 2.0;
// Of gradient noise in two dimensions, lowest to highest, and of a sum of octaves of it.
constexpr double range_of_sum = 1.6;
// Gullies: the widest beside the largest hills, how many kinds of half the width of the one before, and how
// deep their cuts are beside their width.
constexpr double widest_share = 0.09;
constexpr int most_gullies = 5;
constexpr double gully_depth = 0.3;
constexpr double least_posts_a_gully = 4.0;

void require(bool is_valid, const char* name, const char* expected, double found) {
  if (is_valid) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("fractal ground: {}: expected {}, found {:g}", name, expected, found),
              "see `offing terrain generate --help` for the ranges");
}

/// Weight of the next lattice point and its derivative: 6 t^5 - 15 t^4 + 10 t^3.
std::pair<double, double> faded(double t) {
  return {t * t * t * (t * (6.0 * t - 15.0) + 10.0), 30.0 * t * t * (t * (t - 2.0) + 1.0)};
}

}  // namespace

void require_valid(const FractalParameters& parameters) {
  require(parameters.posts >= 2 && parameters.posts <= 65536, "posts", "2 ... 65536", parameters.posts);
  require(parameters.side_m >= 1.0 && parameters.side_m <= 1e7, "side_m", "1 ... 1e7 m", parameters.side_m);
  require(parameters.relief_m >= 0.0 && parameters.relief_m <= 2e4, "relief_m", "0 ... 20000 m",
          parameters.relief_m);
  require(std::abs(parameters.mean_m) <= 1e4, "mean_m", "-10000 ... 10000 m", parameters.mean_m);
  require(parameters.longest_m >= 1e-3 * parameters.side_m && parameters.longest_m <= 1e7, "longest_m",
          "a thousandth of the side ... 1e7 m", parameters.longest_m);
  require(parameters.roughness >= 0.2 && parameters.roughness <= 0.8, "roughness", "0.2 ... 0.8",
          parameters.roughness);
  const double island_m = parameters.island_radius_m.value_or(1.0);
  require(island_m >= 1.0 && island_m <= 1e7, "island_radius_m", "1 ... 1e7 m", island_m);
  require(parameters.erosion >= 0.0 && parameters.erosion <= 1.0, "erosion", "0 ... 1", parameters.erosion);
}

FractalTerrain::FractalTerrain(const FractalParameters& parameters) : parameters_(parameters) {
  require_valid(parameters);
  const double spacing_m = parameters.side_m / (parameters.posts - 1);
  double height_m = parameters.relief_m * (1.0 - parameters.roughness) / range_of_sum * 2.0;
  double wavelength_m = parameters.longest_m;
  do {
    octaves_.push_back({wavelength_m, height_m, static_cast<int>(octaves_.size()), -1, {}, {}});
    wavelength_m *= 0.5;
    height_m *= parameters.roughness;
  } while (wavelength_m >= 2.0 * spacing_m);
  double width_m = widest_share * parameters.longest_m;
  for (int i = 0; i < most_gullies && parameters.erosion > 0.0 && width_m >= least_posts_a_gully * spacing_m;
       ++i, width_m *= 0.5) {
    gullies_.emplace_back(width_m, gully_depth * parameters.erosion, parameters.side_m, parameters.seed, i);
  }
}

void FractalTerrain::fill_lattice(Octave& octave, int lattice_row, std::vector<Gradient>& gradients) const {
  const auto columns = static_cast<std::size_t>(parameters_.side_m / octave.wavelength_m) + 3;
  gradients.resize(columns);  // one on each side of the last post, which rounding may put beyond the side
  for (std::size_t column = 0; column < columns; ++column) {
    const PhiloxBlock block =
        philox_block(static_cast<std::uint32_t>(parameters_.seed),
                     static_cast<std::uint32_t>(parameters_.seed >> 32), OFFING_STREAM_TERRAIN_FRACTAL,
                     static_cast<int>(column), lattice_row, static_cast<std::uint32_t>(octave.index));
    const double angle = 2.0 * std::numbers::pi * uniform_open01(block.v[0]);
    gradients[column] = {std::cos(angle), std::sin(angle)};
  }
}

// Steep in the middle, and ever less toward the shore and beyond.
double FractalTerrain::sinking_m(double x_m, double z_m) const {
  if (!parameters_.island_radius_m) return 0.0;
  const double middle_m = 0.5 * parameters_.side_m;
  const double share =
      std::min(1.0, std::hypot(x_m - middle_m, z_m - middle_m) / *parameters_.island_radius_m);
  return parameters_.relief_m * share * (2.0 - share);
}

void FractalTerrain::fill_row(int row, std::span<float> heights_m) {
  const double spacing_m = parameters_.side_m / (parameters_.posts - 1);
  for (Octave& octave : octaves_) {
    const int top = static_cast<int>(row * spacing_m / octave.wavelength_m);
    if (top == octave.top) continue;
    if (octave.top >= 0 && top == octave.top + 1) {
      std::swap(octave.upper, octave.lower);
    } else {
      fill_lattice(octave, top, octave.upper);
    }
    fill_lattice(octave, top + 1, octave.lower);
    octave.top = top;
  }
  for (Gullies& gullies : gullies_) gullies.move_to(row * spacing_m);
  for (int column = 0; column < parameters_.posts; ++column) {
    double height_m = parameters_.mean_m - sinking_m(column * spacing_m, row * spacing_m), slope_x = 0.0,
           slope_z = 0.0;
    double terrain_x = 0.0, terrain_z = 0.0;  // slopes of what is wider than gullies
    for (const Octave& octave : octaves_) {
      const double x = column * spacing_m / octave.wavelength_m, z = row * spacing_m / octave.wavelength_m;
      const auto left = static_cast<std::size_t>(x);
      const double u = x - static_cast<double>(left), v = z - octave.top;
      const auto [across, across_slope] = faded(u);
      const auto [down, down_slope] = faded(v);
      const Gradient g00 = octave.upper[left], g10 = octave.upper[left + 1], g01 = octave.lower[left],
                     g11 = octave.lower[left + 1];
      const double n00 = g00.x * u + g00.z * v, n10 = g10.x * (u - 1.0) + g10.z * v;
      const double n01 = g01.x * u + g01.z * (v - 1.0), n11 = g11.x * (u - 1.0) + g11.z * (v - 1.0);
      const double north = std::lerp(n00, n10, across), south = std::lerp(n01, n11, across);
      const double noise_x = std::lerp(std::lerp(g00.x, g10.x, across) + (n10 - n00) * across_slope,
                                       std::lerp(g01.x, g11.x, across) + (n11 - n01) * across_slope, down);
      const double noise_z =
          std::lerp(std::lerp(g00.z, g10.z, across), std::lerp(g01.z, g11.z, across), down) +
          (south - north) * down_slope;
      slope_x += noise_x * octave.height_m / octave.wavelength_m;
      slope_z += noise_z * octave.height_m / octave.wavelength_m;
      const double weight = 1.0 / (1.0 + weakening * (slope_x * slope_x + slope_z * slope_z));
      height_m += octave.height_m * std::lerp(north, south, down) * weight;
      if (octave.wavelength_m >= widest_share * parameters_.longest_m) {
        terrain_x += noise_x * octave.height_m / octave.wavelength_m * weight;
        terrain_z += noise_z * octave.height_m / octave.wavelength_m * weight;
      }
    }
    for (const Gullies& gullies : gullies_) {
      const Gullies::Cut cut = gullies.at(column * spacing_m, row * spacing_m, terrain_x, terrain_z);
      height_m += cut.height_m;
      terrain_x += cut.slope_x;
      terrain_z += cut.slope_z;
    }
    heights_m[static_cast<std::size_t>(column)] = static_cast<float>(height_m);
  }
}

RowMakers::RowMakers(const FractalParameters& parameters)
    : posts_(parameters.posts),
      makers_(std::max(1u, std::thread::hardware_concurrency()), FractalTerrain(parameters)),
      heights_m_(static_cast<std::size_t>(rows_at_once()) * static_cast<std::size_t>(posts_)) {}

std::span<const float> RowMakers::make(int first) {
  const auto posts = static_cast<std::size_t>(posts_);
  const int rows = std::min(rows_at_once(), posts_ - first);
  {
    std::vector<std::jthread> threads;
    for (int begin = 0; begin < rows; begin += rows_a_maker) {
      threads.emplace_back([this, posts, first, begin, end = std::min(begin + rows_a_maker, rows)] {
        FractalTerrain& maker = makers_[static_cast<std::size_t>(begin / rows_a_maker)];
        for (int row = begin; row < end; ++row) {
          maker.fill_row(first + row,
                         std::span(heights_m_).subspan(static_cast<std::size_t>(row) * posts, posts));
        }
      });
    }
  }
  return std::span(heights_m_).first(static_cast<std::size_t>(rows) * posts);
}

}  // namespace offing::terrain

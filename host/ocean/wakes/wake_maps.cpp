#include "host/ocean/wakes/wake_maps.h"

#include <cmath>
#include <numbers>

#include "kernels/shared/query_params.h"

namespace offing::ocean {
namespace {

constexpr double tile_m = SURFACE_QUERY_TILE_M;
// Below the surface all waves of a window are taken to be as long as this share of it: the depth to which
// each reaches is not known from the map.
constexpr double usual_wavelength = 1.0 / 16.0;

std::size_t texels_of(const WakeLayer& layer) {
  return static_cast<std::size_t>(layer.size) * static_cast<std::size_t>(layer.size);
}

}  // namespace

WakeMaps::WakeMaps(const ocl::Device& device)
    : device_(device),
      maps_(device, 4, "wake maps"),
      shown_(device, 4, "shown wakes"),
      layers_buffer_(device, 1, "wake layers") {}

void WakeMaps::at(std::span<WakeWindow> windows, double time_s,
                  const WakeWindow::AddDisplaced& add_displaced) {
  layers_.clear();
  places_.clear();
  std::size_t texels = 0;
  for (const WakeWindow& window : windows) {
    const WakeGrid grid = window.grid();
    const double cell_m = window.parameters().cell_m();
    const Place place{grid.first_column * cell_m, grid.first_row * cell_m, cell_m};
    const double tile_x = std::nearbyint(place.origin_x_m / tile_m),
                 tile_z = std::nearbyint(place.origin_z_m / tile_m);
    const int mask = grid.size - 1;
    layers_.push_back({.tile_x = static_cast<int>(tile_x),
                       .tile_z = static_cast<int>(tile_z),
                       .origin_x_m = static_cast<float>(place.origin_x_m - tile_x * tile_m),
                       .origin_z_m = static_cast<float>(place.origin_z_m - tile_z * tile_m),
                       .cells_per_m = static_cast<float>(1.0 / cell_m),
                       .size = grid.size,
                       .first_column = grid.first_column & mask,
                       .first_row = grid.first_row & mask,
                       .first_texel = static_cast<int>(texels),
                       .decay_radpm = static_cast<float>(2.0 * std::numbers::pi / usual_wavelength /
                                                         window.parameters().length_m)});
    places_.push_back(place);
    texels += texels_of(layers_.back());
  }
  if (layers_.empty()) return;
  if (maps_.size() < 4 * texels) {
    maps_ = ocl::Buffer<float>(device_, 4 * texels, "wake maps");
    shown_ = ocl::Buffer<float>(device_, 4 * texels, "shown wakes");
  }
  if (layers_buffer_.size() < layers_.size()) {
    layers_buffer_ = ocl::Buffer<WakeLayer>(device_, layers_.size(), "wake layers");
  }
  layers_buffer_.write(layers_);
  for (std::size_t i = 0; i < windows.size(); ++i) {
    const auto first = static_cast<std::size_t>(layers_[i].first_texel);
    windows[i].draw(time_s, maps_, first, add_displaced);
    windows[i].show(time_s, maps_, shown_, first);
  }
}

std::vector<WakeSamples> WakeMaps::samples_of(const SampleGrid& grid) const {
  std::vector<WakeSamples> samples;
  for (const Place& place : places_) {
    samples.push_back({.column = static_cast<float>((grid.origin_x_m - place.origin_x_m) / place.cell_m),
                       .row = static_cast<float>((grid.origin_z_m - place.origin_z_m) / place.cell_m),
                       .column_step = static_cast<float>(grid.spacing_x_m / place.cell_m),
                       .row_step = static_cast<float>(grid.spacing_z_m / place.cell_m)});
  }
  return samples;
}

std::vector<WakeMaps::Instant> WakeMaps::read() const {
  std::vector<Instant> instants;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    Instant instant{.layer = layers_[i],
                    .origin_x_m = places_[i].origin_x_m,
                    .origin_z_m = places_[i].origin_z_m,
                    .cell_m = places_[i].cell_m,
                    .map = std::vector<float>(4 * texels_of(layers_[i]))};
    maps_.read(instant.map, 4 * static_cast<std::size_t>(layers_[i].first_texel));
    instants.push_back(std::move(instant));
  }
  return instants;
}

std::vector<WakeFields> WakeMaps::read_fields() const {
  std::vector<WakeFields> windows;
  for (const Instant& instant : read()) {
    std::vector<float> shown(instant.map.size());
    shown_.read(shown, 4 * static_cast<std::size_t>(instant.layer.first_texel));
    WakeGrid grid{};
    grid.size = instant.layer.size;
    grid.first_column = instant.layer.first_column;
    grid.first_row = instant.layer.first_row;
    windows.push_back(unrolled_wake(grid, instant.map, shown));
    windows.back().origin_x_m = instant.origin_x_m;
    windows.back().origin_z_m = instant.origin_z_m;
    windows.back().cell_m = instant.cell_m;
  }
  return windows;
}

std::array<double, 4> WakeMaps::Instant::at(double x_m, double z_m) const {
  const double column = (x_m - origin_x_m) / cell_m, row = (z_m - origin_z_m) / cell_m;
  const int last = layer.size - 1;
  std::array<double, 4> sum{};
  if (!(column >= 0.0 && column < last && row >= 0.0 && row < last)) return sum;
  const int x = static_cast<int>(column), z = static_cast<int>(row);
  for (int j = 0; j < 2; ++j) {
    for (int i = 0; i < 2; ++i) {
      const double weight = std::abs(1 - i - (column - x)) * std::abs(1 - j - (row - z));
      const auto texel = static_cast<std::size_t>(((layer.first_row + z + j) & last) * layer.size +
                                                  ((layer.first_column + x + i) & last));
      for (std::size_t field = 0; field < 4; ++field) sum[field] += weight * map[4 * texel + field];
    }
  }
  return sum;
}

}  // namespace offing::ocean

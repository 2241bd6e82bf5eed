#include "host/cli/pictures/sea_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <cstddef>
#include <numeric>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

#include "host/base/error.h"
#include "host/base/parallel_for.h"

namespace offing::cli {
namespace {

constexpr int smallest_side = 256, largest_side = 1024;
constexpr float steepening = 3.0f;
/// Toward the light: from the upper left, 40 degrees high.
const glm::vec3 to_light = glm::normalize(glm::vec3(-1.0f, 1.187f, -1.0f));
/// Linear colours of water in troughs, at the mean level and on crests, and of foam.
constexpr glm::vec3 trough{0.004f, 0.03f, 0.08f}, middle{0.02f, 0.13f, 0.24f}, crest{0.22f, 0.52f, 0.58f},
    white{0.9f, 0.93f, 0.95f};

std::size_t at(int column, int row, int side) {
  return static_cast<std::size_t>(row) * side + column;
}

/// Heights and foam of a cascade, averaged over squares of its samples.
struct Layer {
  int side = 0;
  double sample_m = 0.0, texel_m = 0.0;
  std::vector<float> heights_m, foam;
};

std::vector<float> averaged(std::span<const float> fine, int side, int factor) {
  if (fine.empty() || factor == 1) return {fine.begin(), fine.end()};
  const int coarse_side = side / factor;
  const float share = 1.0f / static_cast<float>(factor * factor);
  std::vector<float> coarse(static_cast<std::size_t>(coarse_side) * coarse_side);
  for (int row = 0; row < coarse_side; ++row) {
    std::vector<float> sums(static_cast<std::size_t>(side));
    for (int i = 0; i < factor; ++i) {
      const float* const samples = &fine[at(0, factor * row + i, side)];
      for (int column = 0; column < side; ++column) sums[column] += samples[column];
    }
    for (int column = 0; column < coarse_side; ++column) {
      const float* const first = &sums[static_cast<std::size_t>(factor) * column];
      coarse[at(column, row, coarse_side)] = share * std::accumulate(first, first + factor, 0.0f);
    }
  }
  return coarse;
}

Layer layer_of(const SeaMapCascade& cascade, double pixel_m) {
  const int side = cascade.surface->size;
  const double sample_m = cascade.patch_length_m / side;
  int factor = 1;
  while (factor < side && 1.5 * factor * sample_m < pixel_m) factor *= 2;
  return {side / factor, sample_m, factor * sample_m, averaged(cascade.surface->displacement_y, side, factor),
          averaged(cascade.foam, side, factor)};
}

/// The two texels beside a place, and the share of the second one.
struct Between {
  int first, second;
  float share;
};

Between between(const Layer& layer, double place_m) {
  const double texel = (place_m + 0.5 * layer.sample_m) / layer.texel_m - 0.5;
  const double floor = std::floor(texel);
  const int first = static_cast<int>(floor) & (layer.side - 1);  // a power of two
  return {first, (first + 1) & (layer.side - 1), static_cast<float>(texel - floor)};
}

float mixed(float first, float second, float share) {
  return first + share * (second - first);
}

/// Values of a layer along x, at a place between two of its rows.
std::vector<float> row_at(const std::vector<float>& values, int side, const Between& z) {
  const float* const first = &values[at(0, z.first, side)];
  const float* const second = &values[at(0, z.second, side)];
  std::vector<float> row(static_cast<std::size_t>(side));
  for (int i = 0; i < side; ++i) row[i] = mixed(first[i], second[i], z.share);
  return row;
}

class SeaMap {
 public:
  SeaMap(std::span<const SeaMapCascade> cascades, const ocean::GerstnerInstant& long_waves, int side)
      : side_(side),
        pixel_m_(cascades[0].patch_length_m / side),
        first_m_(0.5 * pixel_m_ - 0.5 * cascades[0].patch_length_m / cascades[0].surface->size),
        heights_m_(static_cast<std::size_t>(side) * side),
        foam_(heights_m_.size()) {
    for (const SeaMapCascade& cascade : cascades) layers_.push_back(layer_of(cascade, pixel_m_));
    for (const Layer& layer : layers_) {
      for (int column = 0; column < side; ++column) columns_.push_back(between(layer, place_m(column)));
    }
    for (const ocean::GerstnerInstant::Wave& wave : long_waves.waves()) waves_.push_back(long_wave(wave));
  }

  void fill_row(int row) {
    float* const heights = &heights_m_[at(0, row, side_)];
    float* const foam = &foam_[at(0, row, side_)];
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      const Layer& layer = layers_[i];
      const Between z = between(layer, place_m(row));
      const Between* const columns = &columns_[i * side_];
      const std::vector<float> layer_heights = row_at(layer.heights_m, layer.side, z);
      for (int column = 0; column < side_; ++column) {
        const Between& x = columns[column];
        heights[column] += mixed(layer_heights[x.first], layer_heights[x.second], x.share);
      }
      if (layer.foam.empty()) continue;
      const std::vector<float> layer_foam = row_at(layer.foam, layer.side, z);
      for (int column = 0; column < side_; ++column) {
        const Between& x = columns[column];
        const float more = std::clamp(mixed(layer_foam[x.first], layer_foam[x.second], x.share), 0.0f, 1.0f);
        foam[column] += (1.0f - foam[column]) * more;
      }
    }
    for (const LongWave& wave : waves_) add_wave(wave, row, heights);
  }

  void shade_row(int row, double hs_m, RgbImage& image) const {
    const int above = std::max(row - 1, 0), below = std::min(row + 1, side_ - 1);
    for (int column = 0; column < side_; ++column) {
      const int left = std::max(column - 1, 0), right = std::min(column + 1, side_ - 1);
      const float scale = steepening / static_cast<float>(pixel_m_);
      const float slope_x =
          scale * (height_m(right, row) - height_m(left, row)) / static_cast<float>(right - left);
      const float slope_z =
          scale * (height_m(column, below) - height_m(column, above)) / static_cast<float>(below - above);
      const glm::vec3 normal = glm::normalize(glm::vec3(-slope_x, 1.0f, -slope_z));
      const float light = 0.25f + 0.75f * std::max(glm::dot(normal, to_light), 0.0f) / to_light.y;
      const float level = std::clamp(height_m(column, row) / static_cast<float>(hs_m), -1.0f, 1.0f);
      const glm::vec3 water =
          level < 0.0f ? glm::mix(middle, trough, -level) : glm::mix(middle, crest, level);
      const glm::vec3 colour = light * glm::mix(water, white, foam_[at(column, row, side_)]);
      std::uint8_t* const pixel = &image.rgb[3 * at(column, row, side_)];
      const float noise = dither_noise(column, row);
      for (int channel = 0; channel < 3; ++channel) pixel[channel] = dithered_srgb(colour[channel], noise);
    }
  }

 private:
  double place_m(int pixel) const { return first_m_ + pixel * pixel_m_; }
  float height_m(int column, int row) const { return heights_m_[at(column, row, side_)]; }

  /// A wave of phase kx x + z_phase has the height A cos(z_phase) cos(kx x) - A sin(z_phase) sin(kx x). The
  /// factors of x are the same for all rows.
  struct LongWave {
    double amplitude_m, kz_radpm, phase_rad;
    std::vector<float> cosines, sines;  ///< of kx x, by column
  };

  /// Rotates the phase from pixel to pixel, which needs no cosine for each.
  LongWave long_wave(const ocean::GerstnerInstant::Wave& wave) const {
    LongWave along_x{wave.amplitude_m, wave.kz_radpm, wave.phase_rad, {}, {}};
    std::complex<double> now = std::polar(1.0, wave.kx_radpm * place_m(0));
    const std::complex<double> turn = std::polar(1.0, wave.kx_radpm * pixel_m_);
    for (int column = 0; column < side_; ++column) {
      along_x.cosines.push_back(static_cast<float>(now.real()));
      along_x.sines.push_back(static_cast<float>(now.imag()));
      now = {now.real() * turn.real() - now.imag() * turn.imag(),
             now.real() * turn.imag() + now.imag() * turn.real()};
    }
    return along_x;
  }

  void add_wave(const LongWave& wave, int row, float* heights) const {
    const double z_phase = wave.kz_radpm * place_m(row) + wave.phase_rad;
    const float cosine = static_cast<float>(wave.amplitude_m * std::cos(z_phase)),
                sine = static_cast<float>(wave.amplitude_m * std::sin(z_phase));
    for (int column = 0; column < side_; ++column)
      heights[column] += cosine * wave.cosines[column] - sine * wave.sines[column];
  }

  int side_;
  double pixel_m_, first_m_;  ///< the first pixel's centre
  std::vector<Layer> layers_;
  std::vector<Between> columns_;  ///< [layer][column]
  std::vector<LongWave> waves_;
  std::vector<float> heights_m_, foam_;
};

}  // namespace

RgbImage draw_sea_map(std::span<const SeaMapCascade> cascades, const ocean::GerstnerInstant& long_waves,
                      double hs_m) {
  if (cascades.empty()) throw Error(ErrorKind::bad_input, "preview: no cascade", "give at least one");
  const int side = std::clamp(cascades[0].surface->size, smallest_side, largest_side);
  SeaMap map(cascades, long_waves, side);
  RgbImage image{side, side, std::vector<std::uint8_t>(std::size_t{3} * side * side)};
  parallel_rows(side, [&](int row) { map.fill_row(row); });
  parallel_rows(side, [&](int row) { map.shade_row(row, hs_m, image); });
  return image;
}

}  // namespace offing::cli

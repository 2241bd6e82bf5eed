#include "host/world/hidden_slopes.h"

#include <cmath>
#include <cstddef>
#include <utility>

namespace offing::world {
namespace {

void add(ocean::SlopeCovariance& sum, const ocean::SlopeCovariance& slopes) {
  sum.xx += slopes.xx;
  sum.xz += slopes.xz;
  sum.zz += slopes.zz;
}

ocean::SlopeCovariance slopes_of(const std::vector<ocean::GerstnerWave>& waves) {
  ocean::SlopeCovariance sum;
  for (const ocean::GerstnerWave& wave : waves) {
    const double steepness = wave.wavenumber_radpm * wave.amplitude_m;
    const double mean_square = 0.5 * steepness * steepness;
    const double x = std::cos(wave.direction_rad), z = std::sin(wave.direction_rad);
    add(sum, {.xx = mean_square * x * x, .xz = mean_square * x * z, .zz = mean_square * z * z});
  }
  return sum;
}

}  // namespace

std::vector<std::vector<ocean::SlopeCovariance>> hidden_by_levels(
    const ocean::OceanParameters& ocean, const std::vector<std::vector<float>>& variances) {
  std::vector<std::vector<ocean::SlopeCovariance>> hidden;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    hidden.push_back(ocean::hidden_slopes(variances[i], ocean.size, ocean.cascades[i].patch_length_m));
  }
  return hidden;
}

HiddenSlopes shared_out(std::vector<std::vector<ocean::SlopeCovariance>> cascades,
                        const std::vector<ocean::GerstnerWave>& gerstner_waves, const RippleWind& wind) {
  HiddenSlopes hidden{
      .cascades = std::move(cascades), .gerstner_waves = slopes_of(gerstner_waves), .ripples = {}};
  ocean::SlopeCovariance drawn = hidden.gerstner_waves;
  for (const std::vector<ocean::SlopeCovariance>& levels : hidden.cascades) add(drawn, levels.back());
  hidden.ripples = ocean::remaining_slopes(ocean::measured_slopes(wind.speed_mps, wind.direction_rad), drawn);
  return hidden;
}

}  // namespace offing::world

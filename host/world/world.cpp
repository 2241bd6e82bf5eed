#include "host/world/world.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace offing::world {
namespace {

// The sky changes so little with the eye's height that steps of a percent cannot be seen. The steps are
// fixed, so that a frame does not depend on those before it.
constexpr double altitude_step = 0.01;
constexpr double reach_deviations = 6.0;

std::vector<std::vector<float>> variances_of(const ocean::Ocean& ocean) {
  std::vector<std::vector<float>> variances;
  for (std::size_t i = 0; i < ocean.parameters().cascades.size(); ++i) {
    variances.push_back(ocean.mode_variance(static_cast<int>(i)));
  }
  return variances;
}

HiddenSlopes hidden_slopes_of(const WorldParameters& parameters,
                              const std::vector<std::vector<float>>& variances) {
  HiddenSlopes hidden;
  ocean::SlopeCovariance resolved;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    hidden.cascades.push_back(ocean::hidden_slopes(variances[i], parameters.ocean.size,
                                                   parameters.ocean.cascades[i].patch_length_m));
    const ocean::SlopeCovariance& all = hidden.cascades.back().back();
    resolved.xx += all.xx;
    resolved.xz += all.xz;
    resolved.zz += all.zz;
  }
  hidden.ripples = ocean::remaining_slopes(
      ocean::measured_slopes(parameters.wind_speed_mps, parameters.wind_direction_rad), resolved);
  return hidden;
}

double deviation_m(const std::vector<std::vector<float>>& variances) {
  double variance_m2 = 0.0;
  for (const std::vector<float>& modes : variances) {
    variance_m2 = std::accumulate(modes.begin(), modes.end(), variance_m2);
  }
  return std::sqrt(variance_m2);
}

double height_of_rings_m(const std::vector<ocean::Raindrop>& drops, double time_s) {
  double height_m = 0.0;
  for (const ocean::Raindrop& drop : drops) {
    const double age_s = time_s - drop.time_s;
    if (age_s >= 0.0) height_m += std::abs(drop.amplitude_m) * std::exp(-age_s / drop.decay_s);
  }
  return height_m;
}

}  // namespace

World::World(const ocl::Device& device, const WorldParameters& parameters)
    : device_(device),
      parameters_(parameters),
      ocean_(device, parameters.spectrum, parameters.ocean),
      sky_(device, parameters.atmosphere) {
  ocean::require_valid_trochoids(parameters.trochoids);
  const std::vector<std::vector<float>> variances = variances_of(ocean_);
  hidden_slopes_ = hidden_slopes_of(parameters, variances);
  deviation_m_ = deviation_m(variances);
}

void World::set_sun(const std::array<double, 3>& direction, double distance_au) {
  parameters_.sun_direction = direction;
  parameters_.sun_distance_au = distance_au;
  sky_altitude_m_.reset();
}

void World::set_atmosphere(const sky::Atmosphere& atmosphere) {
  sky_ = sky::ClearSky(device_, atmosphere);
  parameters_.atmosphere = atmosphere;
  sky_altitude_m_.reset();
}

void World::set_trochoids(const ocean::TrochoidSea& trochoids) {
  ocean::require_valid_trochoids(trochoids);
  parameters_.trochoids = trochoids;
}

void World::reseed(std::uint64_t seed, const ocean::TrochoidSea& trochoids) {
  ocean::require_valid_trochoids(trochoids);
  ocean_.reseed(seed);
  parameters_.ocean.seed = seed;
  parameters_.trochoids = trochoids;
}

void World::set_sea(const WorldParameters& parameters) {
  ocean::require_valid_trochoids(parameters.trochoids);
  ocean::Ocean changed(device_, parameters.spectrum, parameters.ocean);
  const std::vector<std::vector<float>> variances = variances_of(changed);
  hidden_slopes_ = hidden_slopes_of(parameters, variances);
  deviation_m_ = deviation_m(variances);
  ocean_ = std::move(changed);
  parameters_.spectrum = parameters.spectrum;
  parameters_.ocean = parameters.ocean;
  parameters_.trochoids = parameters.trochoids;
  parameters_.wind_speed_mps = parameters.wind_speed_mps;
  parameters_.wind_direction_rad = parameters.wind_direction_rad;
}

ocean::SurfaceReach World::reach() const {
  const double waves_m = reach_deviations * deviation_m_;
  double trochoids_m = 0.0;
  for (const ocean::Trochoid& wave : parameters_.trochoids.waves) trochoids_m += wave.amplitude_m;
  return {.horizontal_m = parameters_.ocean.choppiness * waves_m +
                          ocean::horizontal_scale(parameters_.trochoids).scale * trochoids_m,
          .vertical_m = waves_m + trochoids_m + height_of_rings_m(parameters_.trochoids.raindrops, time_s_)};
}

void World::look_at_sky(double eye_altitude_m) {
  const double steps = std::round(std::log(std::max(eye_altitude_m, 1.0)) / altitude_step);
  const double altitude_m = std::exp(steps * altitude_step);
  if (sky_altitude_m_ == altitude_m) return;
  sky_.at({.sun_direction = parameters_.sun_direction,
           .sun_distance_au = parameters_.sun_distance_au,
           .eye_altitude_m = altitude_m});
  illuminance_ = sky_.read_illuminance();
  sky_altitude_m_ = altitude_m;
}

void World::at(double time_s, double eye_altitude_m) {
  look_at_sky(eye_altitude_m);
  ocean_.at(time_s);
  ocean_.foam_map();
  time_s_ = time_s;
}

}  // namespace offing::world

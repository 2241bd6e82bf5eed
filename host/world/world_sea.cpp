// The sea of a world: how it is made and changed.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "host/world/sea_bed.h"
#include "host/world/world.h"

namespace offing::world {
namespace {

constexpr double reach_deviations = 6.0;
constexpr std::size_t rings_that_meet = 8;

std::vector<std::vector<float>> variances_of(const ocean::Ocean& ocean) {
  std::vector<std::vector<float>> variances;
  for (std::size_t i = 0; i < ocean.parameters().cascades.size(); ++i) {
    variances.push_back(ocean.mode_variance(static_cast<int>(i)));
  }
  return variances;
}

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

/// What the mip levels of each cascade hide, of the expected variances of its modes [n][n] m^2.
std::vector<std::vector<ocean::SlopeCovariance>> hidden_by_levels(
    const ocean::OceanParameters& ocean, const std::vector<std::vector<float>>& variances) {
  std::vector<std::vector<ocean::SlopeCovariance>> hidden;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    hidden.push_back(ocean::hidden_slopes(variances[i], ocean.size, ocean.cascades[i].patch_length_m));
  }
  return hidden;
}

/// Of the slopes that the wind makes, what Gerstner waves and cascades leave is the ripples'.
HiddenSlopes shared_out(std::vector<std::vector<ocean::SlopeCovariance>> cascades,
                        const WorldParameters& parameters) {
  HiddenSlopes hidden{.cascades = std::move(cascades),
                      .gerstner_waves = slopes_of(parameters.ocean.gerstner_waves.waves),
                      .ripples = {}};
  ocean::SlopeCovariance drawn = hidden.gerstner_waves;
  for (const std::vector<ocean::SlopeCovariance>& levels : hidden.cascades) add(drawn, levels.back());
  hidden.ripples = ocean::remaining_slopes(ocean::measured_slopes(parameters.wind), drawn);
  return hidden;
}

std::vector<ocean::ShoalingBand> bands_of(const std::vector<std::vector<float>>& variances,
                                          const ocean::OceanParameters& ocean) {
  std::vector<ocean::ShoalingBand> bands;
  for (std::size_t i = 0; i < variances.size(); ++i) {
    bands.push_back(ocean::band_of_modes(variances[i], ocean.size, ocean.cascades[i].patch_length_m));
  }
  return bands;
}

double deviation_m(const std::vector<std::vector<float>>& variances) {
  double variance_m2 = 0.0;
  for (const std::vector<float>& modes : variances) {
    variance_m2 = std::accumulate(modes.begin(), modes.end(), variance_m2);
  }
  return std::sqrt(variance_m2);
}

/// Of the tallest rings alone: so many seldom meet in one place, and a scene may have thousands.
double height_of_rings_m(const std::vector<ocean::Raindrop>& drops, double time_s) {
  std::vector<double> heights_m;
  for (const ocean::Raindrop& drop : drops) {
    const double age_s = time_s - drop.time_s;
    if (age_s >= 0.0) heights_m.push_back(std::abs(drop.amplitude_m) * std::exp(-age_s / drop.decay_s));
  }
  const auto counted =
      heights_m.begin() + static_cast<std::ptrdiff_t>(std::min(heights_m.size(), rings_that_meet));
  std::partial_sort(heights_m.begin(), counted, heights_m.end(), std::greater<>());
  return std::accumulate(heights_m.begin(), counted, 0.0);
}

}  // namespace

void World::make_sea(const WorldParameters& parameters) {
  if (!parameters.has_sea) {
    ocean_.reset();
    spare_ocean_.reset();
    cascade_bands_.clear();
    hidden_slopes_ = {};
    deviation_m_ = 0.0;
    return;
  }
  ocean::Ocean made(device_, parameters.spectrum, parameters.ocean);
  const std::vector<std::vector<float>> variances = variances_of(made);
  hidden_slopes_ = shared_out(hidden_by_levels(parameters.ocean, variances), parameters);
  deviation_m_ = deviation_m(variances);
  travel_rad_ = ocean::integrate_sea_state(parameters.spectrum).mean_direction_rad;
  cascade_bands_ = bands_of(variances, parameters.ocean);
  ocean_ = std::move(made);
  spare_ocean_.reset();
  fit_sea(parameters);
}

void World::fit_sea(const WorldParameters& parameters) {
  ocean::OceanParameters wanted = parameters.ocean;
  wanted.size = std::min(wanted.size, most_samples_);
  if (!ocean_ || ocean_->parameters().size == wanted.size) return;
  if (!spare_ocean_ || spare_ocean_->parameters().size != wanted.size)
    spare_ocean_.emplace(device_, parameters.spectrum, wanted);
  std::swap(ocean_, spare_ocean_);
  hidden_slopes_ = shared_out(hidden_by_levels(wanted, variances_of(*ocean_)), parameters);
}

void World::set_sea_samples(int most) {
  most_samples_ = most;
  if (!ocean_ || sea_samples() == std::min(parameters_.ocean.size, most)) return;
  fit_sea(parameters_);
  ocean_->set_gerstner_waves(parameters_.ocean.gerstner_waves);
  ocean_->set_wakes(wakes_ ? wakes_->maps() : nullptr);
  ocean_->set_shoals(shoals_);
  ocean_->at(time_s_);
}

void World::make_shoals() {
  std::shared_ptr<const ocean::Shoals> made;
  swash_.reset();
  if (ocean_ && terrain_ && parameters_.has_shoals) {
    if (!bed_)
      bed_ =
          std::make_shared<const ocean::DepthMap>(sea_bed(terrain_->parameters(), parameters_.sea_level_m));
    const ocean::ShoalTable table(
        parameters_.spectrum.dispersion,
        ocean::shoaling_bands(cascade_bands_, parameters_.ocean.gerstner_waves.waves));
    if (bed_->shallowest_m() < table.deepest_m()) {
      made = std::make_shared<const ocean::Shoals>(device_, bed_, table);
      const double slope = beach_slope(*bed_);
      if (slope > 0.0)
        swash_.emplace(parameters_.spectrum.dispersion, table.bands(), slope, travel_rad_,
                       parameters_.ocean.seed);
    }
  }
  shoals_ = std::move(made);
  if (ocean_) ocean_->set_shoals(shoals_);
  if (bodies_) bodies_->set_shoals(shoals_);
}

void World::set_gerstner_waves(const ocean::GerstnerSea& gerstner_waves) {
  ocean::require_valid_gerstner_waves(gerstner_waves);
  parameters_.ocean.gerstner_waves = gerstner_waves;
  hidden_slopes_ = shared_out(std::move(hidden_slopes_.cascades), parameters_);
  if (ocean_) ocean_->set_gerstner_waves(gerstner_waves);
  if (bodies_) bodies_->set_gerstner_waves(gerstner_waves);
  make_shoals();
}

void World::set_wakes(const std::vector<WakeSettings>& wakes) {
  std::optional<WorldWakes> made;
  if (ocean_ && !wakes.empty()) made.emplace(device_, wakes, time_s_);
  wakes_ = std::move(made);
  set_most_wake_steps(most_wake_steps_);
  if (ocean_) ocean_->set_wakes(wakes_ ? wakes_->maps() : nullptr);
  parameters_.wakes = wakes;
}

void World::set_most_wake_steps(int most) {
  most_wake_steps_ = most;
  if (wakes_) wakes_->set_most_steps(most);
}

void World::reseed(std::uint64_t seed, const ocean::GerstnerSea& gerstner_waves) {
  ocean().reseed(seed, gerstner_waves);
  spare_ocean_.reset();
  parameters_.ocean.seed = seed;
  parameters_.ocean.gerstner_waves = gerstner_waves;
  hidden_slopes_ = shared_out(std::move(hidden_slopes_.cascades), parameters_);
  make_shoals();
  if (bodies_) bodies_->set_sea(body_sea());
}

void World::set_sea(const WorldParameters& parameters) {
  make_sea(parameters);
  set_sea_level(parameters.sea_level_m);
  parameters_.has_sea = parameters.has_sea;
  parameters_.spectrum = parameters.spectrum;
  parameters_.ocean = parameters.ocean;
  parameters_.wind = parameters.wind;
  parameters_.has_shoals = parameters.has_shoals;
  make_shoals();
  set_wakes(parameters.wakes);
  if (bodies_ && has_sea()) {
    bodies_->set_sea(body_sea());
  } else {
    set_bodies(parameters_.bodies, parameters_.run_up_s);
  }
}

ocean::SurfaceReach World::reach() const {
  if (!ocean_) return {};
  const double growth = shoals_ ? shoals_->instant().table.largest_share() : 1.0;
  const double waves_m = growth * reach_deviations * deviation_m_;
  const ocean::GerstnerSea& gerstner_waves = parameters_.ocean.gerstner_waves;
  double gerstner_waves_m = 0.0;
  for (const ocean::GerstnerWave& wave : gerstner_waves.waves) gerstner_waves_m += growth * wave.amplitude_m;
  return {.horizontal_m = parameters_.ocean.choppiness * waves_m +
                          ocean::horizontal_scale(gerstner_waves).scale * gerstner_waves_m,
          .vertical_m = waves_m + gerstner_waves_m + height_of_rings_m(gerstner_waves.raindrops, time_s_) +
                        (swash_ ? swash_->farthest_m() : 0.0) + (wakes_ ? wakes_->reach_m(time_s_) : 0.0) +
                        (wakes_ && bodies_ ? bodies_->draught_m() : 0.0)};
}

}  // namespace offing::world

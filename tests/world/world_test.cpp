// The simulations of a scene together: what one time and one eye give, in any order.
#include "host/world/world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/gerstner_choice.h"
#include "host/sky/sun_position.h"

namespace offing::world {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

WorldParameters parameters() {
  ocean::SpectrumParameters spectrum;
  spectrum.wind_speed_mps = 11.0;
  spectrum.fetch_m = 50e3;
  const double split_radpm = ocean::split_at_wavelength_radpm(60.0);
  WorldParameters result;
  result.spectrum = ocean::make_sea_spectrum(spectrum);
  result.ocean.size = 64;
  const std::array lengths{170.0};
  result.ocean.cascades = ocean::cascades_from_patches(lengths, result.ocean.size, split_radpm);
  result.ocean.gerstner_waves.waves =
      ocean::choose_gerstner_waves(result.spectrum, {.split_radpm = split_radpm, .count = 8});
  result.ocean.foam.fraction = ocean::whitecap_fraction(11.0);
  result.wind.wind_speed_mps = 11.0;
  result.sun.sun_direction = sky::direction_of(1.0, 0.5);
  return result;
}

class WorldTest : public testing::Test {
 protected:
  ocl::Device device_ = ocl::Device::open();
  World world_{device_, parameters()};
};

// Fails if a frame depends on those before it: the sky's tables, foam or maps of another time.
TEST_F(WorldTest, DependsOnTimeAndEyeAlone) {
  const auto maps = [&](double time_s, double eye_m) {
    world_.at(time_s, eye_m);
    return std::tuple(world_.ocean().displacement_map().read(), world_.ocean().gradient_map().read(),
                      world_.ocean().foam_map().read(), world_.sky().view_table().read());
  };
  const auto first = maps(4.0, 10.0);
  EXPECT_NE(maps(9.0, 300.0), first);
  EXPECT_EQ(maps(4.0, 10.0), first);
  EXPECT_EQ(world_.time_s(), 4.0);
}

// Fails if a world's water is asked of another time, or without its Gerstner waves.
TEST_F(WorldTest, AnswersForItsWater) {
  world_.at(12.3, 5.0);
  const std::array points{ocean::WaterPoint{3.0, -40.0}, ocean::WaterPoint{1e5, 7.0}};
  const auto samples = world_.sample(points);
  ocean::Ocean alone(device_, parameters().spectrum, parameters().ocean);
  alone.at(12.3);
  const auto expected = alone.sample(points);
  ASSERT_EQ(samples.size(), 2u);
  for (const std::size_t i : {0u, 1u}) EXPECT_EQ(samples[i].height_m, expected[i].height_m);
  alone.set_gerstner_waves({});
  EXPECT_NE(samples[0].height_m, alone.sample(points)[0].height_m);
}

// Fails if the maps are those of a past instant that foam was computed from.
TEST_F(WorldTest, HoldsTheSurfaceOfItsTime) {
  world_.at(12.3, 5.0);
  ocean::Ocean alone(device_, parameters().spectrum, parameters().ocean);
  alone.at(12.3);
  EXPECT_EQ(world_.ocean().displacement_map().read(), alone.displacement_map().read());
}

// Fails if a sea of fewer samples is not the one that is made with so many, if the light loses the slopes of
// the waves that it leaves out, or if the whole sea does not come back, with the Gerstner waves of now.
TEST_F(WorldTest, ShowsTheSeaInFewerSamples) {
  const auto surface = [&] {
    world_.at(12.3, 5.0);
    return std::pair(world_.ocean().displacement_map().read(), world_.ocean().foam_map().read());
  };
  const auto all_slopes = [&] {
    const HiddenSlopes& hidden = world_.hidden_slopes();
    return hidden.cascades.front().back().xx + hidden.gerstner_waves.xx + hidden.ripples.xx;
  };
  const auto whole = surface();
  const double slopes = all_slopes();
  const double drawn = world_.hidden_slopes().cascades.front().back().xx;
  world_.set_sea_samples(32);
  EXPECT_EQ(world_.sea_samples(), 32);
  const double height_m = world_.sample(std::array{ocean::WaterPoint{3.0, -40.0}}).front().height_m;
  ocean::OceanParameters coarse = parameters().ocean;
  coarse.size = 32;
  ocean::Ocean alone(device_, parameters().spectrum, coarse);
  alone.at(12.3);
  EXPECT_EQ(surface().first, alone.displacement_map().read());
  EXPECT_EQ(height_m, world_.sample(std::array{ocean::WaterPoint{3.0, -40.0}}).front().height_m)
      << "it had another time";
  // Where waves along one axis have more slope than the wind makes, ripples cannot have less than none: 0.8
  // %.
  EXPECT_NEAR(all_slopes(), slopes, 0.02 * slopes);
  EXPECT_LT(world_.hidden_slopes().cascades.front().back().xx, drawn - 0.04 * slopes);
  world_.set_gerstner_waves({});
  world_.set_sea_samples(1024);
  EXPECT_TRUE(world_.ocean().parameters().gerstner_waves.waves.empty()) << "waves of before came back";
  world_.set_sea_samples(32);
  world_.reseed(9, parameters().ocean.gerstner_waves);
  EXPECT_NE(surface().first, alone.displacement_map().read());
  world_.set_sea_samples(1024);
  world_.reseed(parameters().ocean.seed, parameters().ocean.gerstner_waves);
  EXPECT_EQ(surface(), whole);
  EXPECT_EQ(all_slopes(), slopes);
}

// Fails if the sun stays where it was, or its light does not reach the eye.
TEST_F(WorldTest, TurnsTheSun) {
  world_.at(0.0, 2.0);
  const double high = sky::luminance(world_.illuminance().sun_klx);
  world_.set_sun({sky::direction_of(0.0, -3.0 * degree)});
  world_.at(0.0, 2.0);
  EXPECT_GT(high, 50.0);
  EXPECT_EQ(sky::luminance(world_.illuminance().sun_klx), 0.0) << "the sun has set";
  EXPECT_GT(sky::luminance(world_.illuminance().sky_klx), 0.0) << "but it is dusk";
  EXPECT_LT(world_.sky().params().sun_direction_y, 0.0f);
}

// Fails if waves reach farther than the grid's margins: the largest displacement of the cascades over 20
// instants, and all Gerstner waves in phase.
TEST_F(WorldTest, ReachesAsFarAsItsWaves) {
  double gerstner_waves_m = 0.0;
  for (const ocean::GerstnerWave& wave : world_.parameters().ocean.gerstner_waves.waves)
    gerstner_waves_m += wave.amplitude_m;
  double highest_m = 0.0, farthest_m = 0.0;
  for (int i = 0; i < 20; ++i) {
    world_.at(7.0 * i, 5.0);
    const ocean::SurfaceFields fields = world_.ocean().read_surface(0);
    for (std::size_t j = 0; j < fields.displacement_y.size(); ++j) {
      highest_m = std::max(highest_m, std::abs(static_cast<double>(fields.displacement_y[j])));
      farthest_m = std::max(farthest_m, std::hypot(static_cast<double>(fields.displacement_x[j]),
                                                   static_cast<double>(fields.displacement_z[j])));
    }
  }
  EXPECT_GT(world_.reach().vertical_m, highest_m + gerstner_waves_m);
  EXPECT_GT(world_.reach().horizontal_m, farthest_m + gerstner_waves_m);
  EXPECT_LT(world_.reach().vertical_m, 3.0 * (highest_m + gerstner_waves_m)) << "wider than it need be";
}

// Fails if slopes are counted twice or left out: those of the maps, the Gerstner waves and the ripples add up
// to the measured ones, also when the Gerstner waves change.
TEST_F(WorldTest, SharesTheSlopesOut) {
  const HiddenSlopes& hidden = world_.hidden_slopes();
  ASSERT_EQ(hidden.cascades.size(), 1u);
  const double resolved = hidden.cascades[0].back().mean_square();
  const double all = ocean::measured_slopes({11.0, 0.0}).mean_square();
  ASSERT_LT(resolved, 0.9 * all);
  EXPECT_NEAR(resolved + hidden.gerstner_waves.mean_square() + hidden.ripples.mean_square(), all, 1e-9);
  ocean::GerstnerSea gerstner_waves = world_.parameters().ocean.gerstner_waves;
  gerstner_waves.waves = {ocean::make_swell({.amplitude_m = 1.0, .wavelength_m = 80.0}, {})};
  world_.set_gerstner_waves(gerstner_waves);
  // A sine's mean square slope: (k A)^2 / 2.
  EXPECT_NEAR(hidden.gerstner_waves.mean_square(), 0.5 * std::pow(2.0 * std::numbers::pi / 80.0, 2), 1e-12);
  EXPECT_NEAR(resolved + hidden.gerstner_waves.mean_square() + hidden.ripples.mean_square(), all, 1e-9);
}

// Everything that a picture is made from, at one time.
auto everything(World& world) {
  world.at(3.0, 10.0);
  return std::tuple(world.ocean().displacement_map().read(), world.ocean().gradient_map().read(),
                    world.ocean().foam_map().read(), world.sky().view_table().read(),
                    world.illuminance().sky_klx, world.reach().vertical_m, world.reach().horizontal_m,
                    world.hidden_slopes().ripples.xx, world.parameters().ocean.gerstner_waves.waves.size());
}

// Fails if a world that was changed while it ran differs in anything from one that was made so: maps, foam
// (of which the old sea's past must be forgotten), sky, reach, slopes.
TEST_F(WorldTest, ChangedEqualsMadeSo) {
  const auto before = everything(world_);
  WorldParameters changed = parameters();
  const auto expect_as_new = [&](const char* what) {
    World fresh(device_, changed);
    const auto now = everything(world_);
    EXPECT_NE(now, before) << what;
    EXPECT_EQ(now, everything(fresh)) << what;
  };
  changed.ocean.gerstner_waves.waves.push_back(
      ocean::make_swell({.amplitude_m = 2.0}, changed.spectrum.dispersion));
  changed.ocean.gerstner_waves.raindrops.push_back({.time_s = 2.0, .amplitude_m = -0.1});
  world_.set_gerstner_waves(changed.ocean.gerstner_waves);
  expect_as_new("gerstner waves");
  changed.atmosphere.aerosol_optical_depth = 0.5;
  world_.set_atmosphere(changed.atmosphere);
  expect_as_new("atmosphere");
  changed.sun.sun_direction = sky::direction_of(2.0, 0.1);
  world_.set_sun(changed.sun);
  expect_as_new("sun");
  changed.ocean.seed = 9;
  changed.ocean.gerstner_waves.waves[0].phase_rad += 1.0;
  world_.reseed(9, changed.ocean.gerstner_waves);
  expect_as_new("seed");
  changed.ocean.size = 32;
  changed.ocean.choppiness = 0.5;
  changed.wind.wind_speed_mps = 15.0;
  changed.ocean.gerstner_waves.waves.clear();
  world_.set_sea(changed);
  expect_as_new("sea");
}

// Fails if a change that is refused leaves half of it behind.
TEST_F(WorldTest, RefusedChangesChangeNothing) {
  const auto before = everything(world_);
  WorldParameters bad = parameters();
  bad.ocean.gerstner_waves.choppiness = -1.0;
  EXPECT_THROW(world_.set_gerstner_waves(bad.ocean.gerstner_waves), Error);
  EXPECT_THROW(world_.reseed(9, bad.ocean.gerstner_waves), Error);
  EXPECT_THROW(world_.set_sea(bad), Error);
  EXPECT_THROW(World(device_, bad), Error);
  WorldParameters windy = parameters();
  windy.ocean.size = 32;
  windy.wind.wind_speed_mps = -1.0;
  EXPECT_THROW(world_.set_sea(windy), Error);
  sky::Atmosphere black;
  black.aerosol_albedo = 2.0;
  EXPECT_THROW(world_.set_atmosphere(black), Error);
  EXPECT_EQ(everything(world_), before);
}

// Fails if rings reach higher than the margins, or still widen them when they have faded or not begun.
TEST_F(WorldTest, ReachFollowsTheRings) {
  world_.at(0.0, 5.0);
  const double without_m = world_.reach().vertical_m;
  ocean::GerstnerSea gerstner_waves = parameters().ocean.gerstner_waves;
  gerstner_waves.raindrops = {{.time_s = 1.0, .amplitude_m = -0.5, .decay_s = 2.0}};
  world_.set_gerstner_waves(gerstner_waves);
  EXPECT_EQ(world_.reach().vertical_m, without_m);
  world_.at(3.0, 5.0);
  EXPECT_NEAR(world_.reach().vertical_m, without_m + 0.5 * std::exp(-1.0), 1e-12);
}

TEST_F(WorldTest, RefusesWhatItsSimulationsRefuse) {
  EXPECT_THROW(world_.at(std::nan(""), 5.0), Error);
  world_.set_sun({{1.0, 1.0, 1.0}});
  EXPECT_THROW(world_.at(0.0, 5.0), Error);
}

}  // namespace
}  // namespace offing::world

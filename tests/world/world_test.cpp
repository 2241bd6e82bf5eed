// The simulations of a scene together: what one time and one eye give, in any order.
#include "host/world/world.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <tuple>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/spectrum_parameters.h"
#include "host/ocean/trochoid_choice.h"
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
  result.trochoids.waves = ocean::choose_trochoids(result.spectrum, {.split_radpm = split_radpm, .count = 8});
  result.wind_speed_mps = 11.0;
  result.sun_direction = sky::direction_of(1.0, 0.5);
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

// Fails if the maps are those of a past instant that foam was computed from.
TEST_F(WorldTest, HoldsTheSurfaceOfItsTime) {
  world_.at(12.3, 5.0);
  ocean::Ocean alone(device_, parameters().spectrum, parameters().ocean);
  alone.at(12.3);
  EXPECT_EQ(world_.ocean().displacement_map().read(), alone.displacement_map().read());
}

// Fails if the sun stays where it was, or its light does not reach the eye.
TEST_F(WorldTest, TurnsTheSun) {
  world_.at(0.0, 2.0);
  const double high = sky::luminance(world_.illuminance().sun_klx);
  world_.set_sun(sky::direction_of(0.0, -3.0 * degree), 1.0);
  world_.at(0.0, 2.0);
  EXPECT_GT(high, 50.0);
  EXPECT_EQ(sky::luminance(world_.illuminance().sun_klx), 0.0) << "the sun has set";
  EXPECT_GT(sky::luminance(world_.illuminance().sky_klx), 0.0) << "but it is dusk";
  EXPECT_LT(world_.sky().params().sun_direction_y, 0.0f);
}

// Fails if waves reach farther than the grid's margins: the largest displacement of the cascades over 20
// instants, and all trochoids in phase.
TEST_F(WorldTest, ReachesAsFarAsItsWaves) {
  double trochoids_m = 0.0;
  for (const ocean::Trochoid& wave : world_.parameters().trochoids.waves) trochoids_m += wave.amplitude_m;
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
  EXPECT_GT(world_.reach().vertical_m, highest_m + trochoids_m);
  EXPECT_GT(world_.reach().horizontal_m, farthest_m + trochoids_m);
  EXPECT_LT(world_.reach().vertical_m, 3.0 * (highest_m + trochoids_m)) << "wider than it need be";
}

// Fails if slopes are counted twice or left out: those of the maps and of the ripples add up to the measured
// ones.
TEST_F(WorldTest, SharesTheSlopesOut) {
  const HiddenSlopes& hidden = world_.hidden_slopes();
  ASSERT_EQ(hidden.cascades.size(), 1u);
  const double resolved = hidden.cascades[0].back().mean_square();
  const double all = ocean::measured_slopes(11.0, 0.0).mean_square();
  ASSERT_LT(resolved, 0.9 * all);
  EXPECT_NEAR(resolved + hidden.ripples.mean_square(), all, 1e-9);
}

TEST_F(WorldTest, RefusesWhatItsSimulationsRefuse) {
  EXPECT_THROW(world_.at(std::nan(""), 5.0), Error);
  world_.set_sun({1.0, 1.0, 1.0}, 1.0);
  EXPECT_THROW(world_.at(0.0, 5.0), Error);
}

}  // namespace
}  // namespace offing::world

// Skies of many clouds: as much cover as asked for, the same each time.
#include "host/clouds/light/scattered_sky.h"

#include <cmath>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "tests/ocl/expect_error.h"

namespace offing::clouds {
namespace {

/// Share of 20,000 places of the square that lie below 0.8 radii of a ball: low-discrepancy places (Roberts
/// 2018, R2), which give a share to 0.3 %.
double covered_share(const SkyCover& cover, const std::vector<CloudParameters>& clouds) {
  constexpr int places = 20'000;
  int covered = 0;
  for (int i = 0; i < places; ++i) {
    const double u = std::fmod(0.5 + i * 0.7548776662466927, 1.0),
                 v = std::fmod(0.5 + i * 0.5698402909980532, 1.0);
    const glm::dvec2 place_m = cover.middle_m + cover.extent_m * (glm::dvec2(u, v) - 0.5);
    const auto is_below = [&](const CloudParameters& cloud) {
      for (const Metaball& ball : cloud.balls) {
        const glm::dvec2 middle_m(cloud.position_m.x + ball.centre_m.x, cloud.position_m.z + ball.centre_m.z);
        if (glm::distance(place_m, middle_m) < 0.8 * ball.radius_m) return true;
      }
      return false;
    };
    for (const CloudParameters& cloud : clouds) {
      if (!is_below(cloud)) continue;
      ++covered;
      break;
    }
  }
  return static_cast<double>(covered) / places;
}

// A cumulus covers 0.4 % of the square, and the last one goes beyond the share: gate 1.5 %.
TEST(ScatteredSkyTest, CoversTheShareOfTheGroundThatIsAskedFor) {
  for (const double coverage : {0.0, 0.1, 0.4, 0.8}) {
    const SkyCover cover{
        .genus = Genus::cumulus, .coverage = coverage, .middle_m = {5e4, -2e4}, .most_clouds = 2000};
    const auto clouds = scattered_sky(cover, 17);
    EXPECT_NEAR(covered_share(cover, clouds), coverage, 0.015);
  }
}

TEST(ScatteredSkyTest, MoreCoverAddsClouds) {
  const auto few = scattered_sky({.coverage = 0.2}, 5), many = scattered_sky({.coverage = 0.5}, 5);
  ASSERT_GT(many.size(), few.size());
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].position_m, many[i].position_m);
    EXPECT_EQ(few[i].seed, many[i].seed);
    EXPECT_EQ(few[i].balls.front().centre_m, many[i].balls.front().centre_m);
  }
  EXPECT_NE(scattered_sky({.coverage = 0.2}, 6).front().position_m, few.front().position_m);
}

TEST(ScatteredSkyTest, RefusesWhatCannotBeCovered) {
  offing::test::expect_error(ErrorKind::bad_input, "cloud_layer.coverage",
                     [] { scattered_sky({.coverage = 1.2}, 1); });
  offing::test::expect_error(ErrorKind::bad_input, "5 cumulus cover",
                     [] { scattered_sky({.coverage = 0.9, .most_clouds = 5}, 1); });
}

}  // namespace
}  // namespace offing::clouds

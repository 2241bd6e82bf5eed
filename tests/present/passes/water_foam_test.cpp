// Foam of waves, by the wind.
#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/present/passes/still_sea.h"

namespace offing::present {
namespace {

class WaterFoamTest : public test::StillSea {
 protected:
  /// Pixels that the foam of a young, steep sea makes brighter.
  int foamy_pixels(double wind_mps, const std::string& foam = "") {
    const std::string sea =
        fmt::format("[wind]\nspeed_mps = {}\n[ocean]\nfetch_m = 3e3\n[sun]\nelevation_deg = 50\n", wind_mps);
    Camera camera = square_camera({0.0, 40.0, 0.0});
    camera.pitch_rad = -0.7;
    const std::vector<float> with = light(sea + "[ocean.foam]\n" + foam, camera, 0);
    const std::vector<float> without = light(sea + "[ocean.foam]\nonset_jacobian = -10\n", camera, 0);
    int count = 0;
    for (std::size_t i = 0; i < with.size(); i += 4) count += with[i] > without[i] ? 1 : 0;
    return count;
  }
};

// Fails if a sea that is too calm for whitecaps has foam, however steep its waves, or a windy one, or one
// whose foam was asked for, has it on less than a thousandth of its picture.
TEST_F(WaterFoamTest, NeedsWind) {
  EXPECT_EQ(foamy_pixels(3.0), 0);
  EXPECT_GT(foamy_pixels(9.0), side_px * side_px / 1000);
  EXPECT_GT(foamy_pixels(3.0, "onset_jacobian = 0.8\n"), side_px * side_px / 1000);
}

// Fails if foam hides more or less of a picture than it covers of the water: mean opacity against mean
// coverage, seen from above. From 40 m, pixels are 0.5 m wide and the picture as wide as five tiles of the
// pattern, whose mean over foam of 6 % differs by some 10 % from its expectation (measured: 8 %); from 800 m
// pixels are 10 m wide and 4 % remain, of the light of foam. Before the pattern's values were normal, foam
// hid three times what it covered.
TEST_F(WaterFoamTest, HidesAsMuchAsItCovers) {
  for (const auto& [height_m, tolerance] : {std::pair{40.0, 0.2}, {800.0, 0.1}}) {
    const std::string sea =
        "[wind]\nspeed_mps = 20\n[ocean]\nsize = 128\n[sun]\nelevation_deg = 50\n[ocean.foam]\n";
    const std::string without_foam = sea + "onset_jacobian = -10\n", much_foam = sea + "fraction = 0.5\n";
    Camera camera = square_camera({0.0, height_m, 0.0});
    camera.pitch_rad = -1.57;
    const std::vector<float> with = light(sea, camera, 0), without = light(without_foam, camera, 0);
    const std::vector<float> much = light(much_foam, camera, 0);
    shown_ = WaterShow::foam;
    const std::vector<float> coverage = light(sea, camera, 0), most = light(much_foam, camera, 0);
    shown_ = WaterShow::none;

    // The light of whole foam.
    const float whole = *std::max_element(most.begin(), most.end());
    double foam_light = 0.0;
    int foams = 0;
    for (std::size_t i = 0; i < much.size(); i += 4) {
      if (most[i] < 0.98f * whole) continue;
      ++foams;
      foam_light += static_cast<double>(much[i]);
    }
    ASSERT_GT(foams, 0);
    foam_light /= foams;

    double hidden = 0.0, covered = 0.0;
    for (std::size_t i = 0; i < with.size(); i += 4) {
      hidden += static_cast<double>(with[i] - without[i]) / (foam_light - static_cast<double>(without[i]));
      covered += static_cast<double>(coverage[i] / whole);
    }
    EXPECT_GT(covered, 0.04 * side_px * side_px) << height_m;
    EXPECT_NEAR(hidden / covered, 1.0, tolerance) << height_m;
  }
}

}  // namespace
}  // namespace offing::present

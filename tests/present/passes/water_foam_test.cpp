// Foam of waves, by the wind.
#include <string>

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

}  // namespace
}  // namespace offing::present

// What an eye in the water sees.
#include "present/passes/water/underwater_pass.h"

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/ocean/surface/water_optics.h"
#include "tests/present/passes/still_sea.h"

namespace offing::present {
namespace {

class UnderwaterPassTest : public test::StillSea {};

double luminance(const float* light) {
  return 0.2126 * light[0] + 0.7152 * light[1] + 0.0722 * light[2];
}

// Snell's window: the sky is seen within asin(1 / 1.34), 48.27 degrees of straight up, and the deep beyond.
// Gate: a pixel and a half to both sides.
TEST_F(UnderwaterPassTest, SeesTheSkyInSnellsWindow) {
  Camera camera = square_camera({0.0, -2.0, 0.0});
  camera.pitch_rad = std::numbers::pi / 2.0;
  camera.vertical_field_of_view_rad = 2.0;
  const std::vector<float> seen = light(still_sea, camera, side_px);
  const double edge_px =
      0.5 * side_px * std::tan(std::asin(1.0 / 1.34)) / std::tan(0.5 * camera.vertical_field_of_view_rad);
  const int inside = static_cast<int>(0.5 * side_px + edge_px - 1.5);
  const int outside = static_cast<int>(std::ceil(0.5 * side_px + edge_px + 1.5));
  ASSERT_LT(outside, side_px);
  EXPECT_GT(luminance(pixel(seen, inside, side_px / 2)), 3.0 * luminance(pixel(seen, outside, side_px / 2)));
  EXPECT_GT(luminance(pixel(seen, outside, side_px / 2)), 0.0);
}

// Straight down on a level bed of depth d, from an eye e below the surface: D exp(-K (d + d - e)) of what the
// dry bed sends, D, and of the water's own light just below its surface A exp(-K e) (1 - exp(-K (d - e))).
// Two eyes give D and A, a third one must see what follows. Gate 3 %: of the ground's mottling each sees
// another part.
TEST_F(UnderwaterPassTest, BedsFadeOnTheWayUp) {
  const std::string bed = std::string(still_sea) +
                          "water = \"1C\"\n[sun]\nelevation_deg = 50\n[terrain]\nposts = 33\nside_m = 1000\n"
                          "relief_m = 0\nmean_m = -6\n";
  const auto mean_red = [&](double eye_m) {
    Camera camera = square_camera({0.0, -eye_m, 0.0});
    camera.pitch_rad = -1.5707;
    const std::vector<float> seen = light(bed, camera, side_px);
    double sum = 0.0;
    for (std::size_t i = 0; i < seen.size(); i += 4) sum += seen[i];
    return 4.0 * sum / static_cast<double>(seen.size());
  };
  const double perm = ocean::water_optics(ocean::WaterType::coastal_1).attenuation_perm[0];
  const auto of_bed = [&](double eye_m) { return std::exp(-perm * (12.0 - eye_m)); };
  const auto of_water = [&](double eye_m) {
    return std::exp(-perm * eye_m) * (1.0 - std::exp(-perm * (6.0 - eye_m)));
  };
  const double at_2_m = mean_red(2.0), at_4_m = mean_red(4.0);
  const double determinant = of_bed(2.0) * of_water(4.0) - of_bed(4.0) * of_water(2.0);
  const double bed_kcdpm2 = (at_2_m * of_water(4.0) - at_4_m * of_water(2.0)) / determinant;
  const double water_kcdpm2 = (of_bed(2.0) * at_4_m - of_bed(4.0) * at_2_m) / determinant;
  EXPECT_GT(bed_kcdpm2, 0.0);
  EXPECT_GT(water_kcdpm2, 0.0);
  const double expected = bed_kcdpm2 * of_bed(3.0) + water_kcdpm2 * of_water(3.0);
  EXPECT_NEAR(mean_red(3.0), expected, 0.03 * expected);
}

}  // namespace
}  // namespace offing::present

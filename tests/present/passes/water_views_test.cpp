// What water mirrors and what is seen through it, on a sea without waves: closed forms.
#include "present/passes/water/water_views.h"

#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/ocean/surface/water_optics.h"
#include "tests/present/passes/still_sea.h"

namespace offing::present {
namespace {

class WaterViewsTest : public test::StillSea {};

double fresnel(double cosine) {
  const double index = 1.34, inside = std::sqrt(index * index - 1.0 + cosine * cosine);
  const double across = (cosine - inside) / (cosine + inside);
  const double along = (index * index * cosine - inside) / (index * index * cosine + inside);
  return 0.5 * (across * across + along * along);
}

// A red ball that stands in the water 25 m before the eye: the water before it shows its image upside down,
// which adds red light and hides the blue of the sky that the water shows without views. The image is in
// Fresnel's share of the ball's own light, which is seen as far above the horizon as the image below it.
// Gate: a third to three times that share: the image shows the ball from below, where it is in its own shade.
TEST_F(WaterViewsTest, MirrorsWhatStandsInIt) {
  const std::string ball = std::string(still_sea) +
                           "[sun]\nazimuth_deg = 180\nelevation_deg = 20\n[[mesh]]\nshape = \"sphere\"\n"
                           "size_m = 7\nz_m = -25\ny_m = 2\ncolour = [0.8, 0.05, 0.05]\nspecular = "
                           "0\n[[mesh.highlight]]\nlight = \"sun\"\nopacity = 0\n";
  Camera camera = square_camera({0.0, 2.0, 0.0});
  camera.vertical_field_of_view_rad = 0.7;
  const std::vector<float> with = light(ball, camera, side_px), without = light(ball, camera, 0);
  for (const int below : {18, 21, 24}) {
    const float* own = pixel(with, side_px / 2, side_px / 2 + below - 1);
    ASSERT_GT(own[0], 3.0f * own[2]) << "no ball " << below << " pixels above the horizon";
    const float* image = pixel(with, side_px / 2, side_px / 2 - below);
    const float* bare = pixel(without, side_px / 2, side_px / 2 - below);
    EXPECT_LT(image[2], bare[2]);
    const double sine = std::sin(std::atan((below - 0.5) / (side_px / 2) * std::tan(0.35)));
    const double share = (image[0] - bare[0]) / (fresnel(sine) * own[0]);
    EXPECT_GT(share, 1.0 / 3.0) << below;
    EXPECT_LT(share, 3.0) << below;
    // Beside the ball there is the sky in both.
    const float* beside = pixel(with, 1, side_px / 2 - below);
    const float* beside_bare = pixel(without, 1, side_px / 2 - below);
    EXPECT_NEAR(beside[0], beside_bare[0], 0.1 * beside_bare[0]) << below;
  }
}

// Fails if what reaches below the height 0 of a world is cut away there, as what water mirrors is: a box of
// 4 m whose middle lies 1 m below, seen from the side. The lower row shows it at -2.5 m.
TEST_F(WaterViewsTest, ShowsMeshesBelowTheLevelSea) {
  const std::string box =
      "[[mesh]]\nshape = \"box\"\nsize_m = 4\ny_m = -1\ncolour = [0.8, 0.05, 0.05]\n"
      "specular = 0\nhighlights = \"off\"\n";
  Camera camera = square_camera({0.0, -1.0, 14.0});
  camera.vertical_field_of_view_rad = 2.0 * std::atan(3.0 / 12.0);
  const std::vector<float> seen = light(box, camera, side_px);
  for (const double height_m : {0.5, -0.5, -2.5}) {
    const int row = static_cast<int>((0.5 + (height_m + 1.0) / 6.0) * side_px);
    const float* texel = pixel(seen, side_px / 2, row);
    EXPECT_GT(texel[0], 3.0f * texel[2]) << height_m;
  }
}

// A level bed of sand: what is seen of it straight from above falls with depth as exp(-2 K d), channel by
// channel, beside the light of deep water and that of the surface. Gate: 3 % of the ratio: halves round to
// 2^-11, the ground's air and its mottling differ by less than a percent over two metres.
TEST_F(WaterViewsTest, BedsFadeWithDepth) {
  Camera camera = square_camera({0.0, 30.0, 0.0});
  camera.pitch_rad = -1.5707;
  camera.vertical_field_of_view_rad = 0.3;
  const auto bed = [&](double depth_m) {
    return fmt::format(
        "{}water = \"1C\"\n[sun]\nelevation_deg = 50\n[terrain]\nposts = 33\nside_m = 1000\nrelief_m = "
        "0\nmean_m = {}\n",
        still_sea, -depth_m);
  };
  const auto mean = [&](const std::vector<float>& light, std::size_t channel) {
    double sum = 0.0;
    for (std::size_t i = 0; i < light.size() / 4; ++i) sum += light[4 * i + channel];
    return sum / static_cast<double>(light.size() / 4);
  };
  const std::vector<float> deep = light(bed(3.0), camera, 0);
  const std::vector<float> at_3_m = light(bed(3.0), camera, side_px),
                           at_5_m = light(bed(5.0), camera, side_px);
  const ocean::WaterOptics optics = ocean::water_optics(ocean::WaterType::coastal_1);
  for (std::size_t channel = 0; channel < 3; ++channel) {
    // Beside the bed's light, a share of what deep water sends is hidden by it; it falls alike.
    const double ratio =
        (mean(at_5_m, channel) - mean(deep, channel)) / (mean(at_3_m, channel) - mean(deep, channel));
    const double expected = std::exp(-2.0 * optics.attenuation_perm[channel] * 2.0);
    EXPECT_GT(mean(at_3_m, channel), mean(deep, channel));
    EXPECT_NEAR(ratio, expected, 0.03 * expected) << "channel " << channel;
  }
}

// Waves gather sunlight on a bed of 3 m and spread it: they move light, and make none. Gate: the mean within
// 8 % of that below a sea without waves, since the densest light is cut at three times; its deviation 1.5
// times that of the sand alone, which has grain and ripples of its own: gate 1.3.
TEST_F(WaterViewsTest, WavesGatherLightOnBeds) {
  const std::string bed =
      "[sun]\nelevation_deg = 60\n[terrain]\nposts = 33\nside_m = 1000\nrelief_m = 0\nmean_m = -3\n";
  const std::string breeze = "[wind]\nspeed_mps = 3\n[ocean]\nsize = 128\nfetch_m = 3e3\n";
  Camera camera = square_camera({0.0, 12.0, 0.0});
  camera.pitch_rad = -1.5707;
  camera.vertical_field_of_view_rad = 0.8;
  struct Greens {
    double mean = 0.0, deviation = 0.0;
  };
  const auto of_bed = [&](const std::string& sea) {
    const std::vector<float> with = light(sea + bed, camera, side_px), deep = light(sea + bed, camera, 0);
    const double count = static_cast<double>(with.size() / 4);
    Greens greens;
    for (std::size_t i = 1; i < with.size(); i += 4) greens.mean += (with[i] - deep[i]) / count;
    for (std::size_t i = 1; i < with.size(); i += 4) {
      greens.deviation += std::pow(with[i] - deep[i] - greens.mean, 2) / count;
    }
    greens.deviation = std::sqrt(greens.deviation);
    return greens;
  };
  const Greens still = of_bed(still_sea), rough = of_bed(breeze);
  EXPECT_NEAR(rough.mean, still.mean, 0.08 * still.mean);
  EXPECT_GT(rough.deviation, 1.3 * still.deviation);
}

// Fails if a sea is drawn otherwise where there is nothing but water.
TEST_F(WaterViewsTest, LeavesTheOpenSeaAsItIs) {
  Camera camera = square_camera({0.0, 5.0, 0.0});
  camera.pitch_rad = -0.2;
  EXPECT_EQ(light(still_sea, camera, side_px), light(still_sea, camera, 0));
}

}  // namespace
}  // namespace offing::present

// Woods over ground: where they grow, how light falls on them, and what is left of crowns that are smaller
// than a pixel; and which crowns rays hit. Pictures of level ground in red light, with one ray a pixel.
#include "host/terrain/shading/canopy.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/numbers/degrees.h"
#include "tests/terrain/canopy/crown_reference.h"
#include "tests/terrain/example_maps.h"
#include "tests/terrain/terrain_painter.h"

namespace offing {
namespace {

using terrain::Canopy;
using terrain::Texel;

/// A plain or a slope of 2.56 km without shores, trees' end or snow. The sun is in the east.
class CanopyTest : public testing::Test {
 protected:
  static constexpr int posts_a_side = 129, side_px = 96;
  static constexpr double spacing_m = 20.0, side_m = spacing_m * (posts_a_side - 1);

  /// With water up to a height.
  void make(double rise, double sun_elevation_deg, float water_m = -1e6f) {
    map_ = test::square_map(posts_a_side, spacing_m, [&](double x_m, double) { return rise * x_m; });
    test::PaintedTerrain scene;
    scene.sun_elevation_rad = sun_elevation_deg * radians_per_degree;
    scene.light.sea_level_m = scene.light.beach_line_m = scene.light.still_water_m = water_m;
    scene.light.tree_line_m = scene.light.snow_line_m = 1e6f;
    painter_ = std::make_unique<test::TerrainPainter>(map_, scene);
  }

  /// Of a square about a place, from so far away: 90 degrees up is from above, yaw 0 looks north.
  Camera camera(double x_m, double shown_m, double distance_m, double up_deg, double yaw_deg) const {
    const double up_rad = up_deg * radians_per_degree, yaw_rad = yaw_deg * radians_per_degree;
    const double level_m = distance_m * std::cos(up_rad);
    return {.eye_m = {x_m - level_m * std::sin(yaw_rad), distance_m * std::sin(up_rad),
                      0.5 * side_m + level_m * std::cos(yaw_rad)},
            .yaw_rad = yaw_rad,
            .pitch_rad = -up_rad,
            .vertical_field_of_view_rad = 2.0 * std::atan(0.5 * shown_m / distance_m),
            .width_px = side_px,
            .height_px = side_px};
  }

  std::vector<Texel> draw(const Camera& camera, const std::optional<Canopy>& canopy) {
    std::optional<terrain::CanopyLayer> layer;
    if (canopy) layer.emplace(painter_->device(), *canopy);
    return painter_->draw(camera, {.sampling = {.rays = 1}, .canopy = layer ? &*layer : nullptr});
  }

  /// Between these shares of the picture's width.
  static double mean_red(const std::vector<Texel>& image, double from = 0.0, double to = 1.0) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t pixel = 0; pixel < image.size(); ++pixel) {
      const double x = (static_cast<double>(pixel % side_px) + 0.5) / side_px;
      if (x < from || x > to) continue;
      sum += static_cast<double>(image[pixel][0]);
      ++count;
    }
    return sum / count;
  }

  test::HeightMap map_;
  std::unique_ptr<test::TerrainPainter> painter_;
};

// Fails if woods grow at other heights than the scene says: on a slope of 5 degrees from 0 to 224 m, from 80
// to 150 m. Where there are none, the picture is that without woods, to the last bit. In a dense wood the
// dark crowns and their shadows leave less than half of the light of a meadow.
TEST_F(CanopyTest, GrowBetweenTheirHeights) {
  const double rise = std::tan(5.0 * radians_per_degree), whole_m = rise * side_m;
  make(rise, 35.0);
  const Camera above = camera(0.5 * side_m, side_m, 20e3, 90.0, 0.0);
  const std::vector<Texel> plain = draw(above, {}), wooded = draw(above, Canopy{.colour = glm::dvec3(0.03),
                                                                                .lowest_m = 80.0,
                                                                                .highest_m = 150.0,
                                                                                .edge_m = 4.0,
                                                                                .share = 1.0});
  double largest = 0.0;
  for (std::size_t pixel = 0; pixel < plain.size(); ++pixel) {
    const double height_m = whole_m * (static_cast<double>(pixel % side_px) + 0.5) / side_px;
    if (height_m > 65.0 && height_m < 165.0) continue;
    largest = std::max(largest, std::abs(static_cast<double>(plain[pixel][0] - wooded[pixel][0])));
  }
  EXPECT_EQ(largest, 0.0);
  const double from = 90.0 / whole_m, to = 140.0 / whole_m;
  EXPECT_LT(mean_red(wooded, from, to), 0.5 * mean_red(plain, from, to));
}

// Fails if the map does not say where woods are: white in the west, black in the east, transparent in a strip
// between. As it decides alone, the rules' share of 0 has no part.
TEST_F(CanopyTest, GrowWhereTheMapSays) {
  make(0.0, 35.0);
  ColourMap picture{
      .columns = 4, .rows = 1, .rgba = {}, .left = 0.0, .top = 0.0, .right = 128.0, .bottom = 128.0};
  picture.rgba = {255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 0, 255, 0, 0, 0, 255};
  const Camera above = camera(0.5 * side_m, side_m, 20e3, 90.0, 0.0);
  const std::vector<Texel> plain = draw(above, {});
  const std::optional<Canopy> wood =
      terrain::wood_of({.colour = glm::dvec3(0.03)}, terrain::cover_map(picture), 2000.0);
  ASSERT_TRUE(wood);
  const std::vector<Texel> wooded = draw(above, wood);
  EXPECT_LT(mean_red(wooded, 0.0, 0.1), 0.5 * mean_red(plain, 0.0, 0.1));
  EXPECT_EQ(mean_red(wooded, 0.45, 1.0), mean_red(plain, 0.45, 1.0));
  EXPECT_FALSE(terrain::wood_of({}, nullptr, 2000.0));
}

// Fails if woods cover another share of the ground. The map shows some tens of patches: 0.1 of the share.
// Under a high sun, as woods shade the meadows beside them.
TEST_F(CanopyTest, CoverTheirShare) {
  make(0.0, 80.0);
  const Camera above = camera(0.5 * side_m, side_m, 20e3, 90.0, 0.0);
  Canopy wood{.colour = glm::dvec3(0.03), .share = 1.0, .patch_m = 200.0};
  const double none = mean_red(draw(above, {})), all = mean_red(draw(above, wood));
  for (const double share : {0.2, 0.5, 0.8}) {
    wood.share = share;
    EXPECT_NEAR((mean_red(draw(above, wood)) - none) / (all - none), share, 0.1) << share;
  }
}

// Fails if a wood gets brighter or darker where its crowns are smaller than a pixel: a square of 60 m in
// pixels of 0.6 m against one in pixels of 30 m. Fits of the means are within 14 %.
TEST_F(CanopyTest, KeepTheirLightFarAway) {
  for (const double sun_deg : {20.0, 50.0}) {
    make(0.0, sun_deg);
    for (const double up_deg : {90.0, 50.0, 25.0}) {
      for (const double yaw_deg : {90.0, 0.0, -90.0}) {
        const Canopy wood{.share = 1.0};
        const Camera near = camera(0.5 * side_m, 60.0, 300.0, up_deg, yaw_deg);
        Camera far = near;
        far.width_px = far.height_px = 2;
        const double fine = mean_red(draw(near, wood));
        double coarse = 0.0;
        for (const Texel& texel : draw(far, wood)) coarse += 0.25 * static_cast<double>(texel[0]);
        EXPECT_NEAR(coarse / fine, 1.0, 0.14)
            << "sun " << sun_deg << ", view " << up_deg << ", " << yaw_deg << ": " << fine;
      }
    }
  }
}

// Fails if crowns do not shade one another: from 35 degrees above the ground, a wood is at least twice as
// bright with the sun behind the eye as against it. A meadow is not, nor a wood from straight above.
TEST_F(CanopyTest, AreDarkAgainstTheSun) {
  make(0.0, 35.0);
  const Canopy wood{.share = 1.0};
  const auto ratio = [&](const std::optional<Canopy>& canopy, double up_deg) {
    const double x_m = 0.5 * side_m;
    return mean_red(draw(camera(x_m, 100.0, 200.0, up_deg, -90.0), canopy)) /
           mean_red(draw(camera(x_m, 100.0, 200.0, up_deg, 90.0), canopy));
  };
  EXPECT_GT(ratio(wood, 35.0), 2.0);
  EXPECT_LT(ratio({}, 35.0), 1.3);
  EXPECT_NEAR(ratio(wood, 90.0), 1.0, 0.1);
}

// From 20 km above a slope of 5 degrees, where pixels are larger than crowns: hits are those of the ground.
// Fails if they lose its normal or their distance.
TEST_F(CanopyTest, HitsOfTheGroundStay) {
  make(std::tan(5.0 * radians_per_degree), 35.0);
  const Camera above = camera(0.5 * side_m, 0.8 * side_m, 20e3, 90.0, 0.0);
  const auto hits_with = [&](const std::optional<Canopy>& wood) {
    draw(above, wood);
    return painter_->hits();
  };
  const std::vector<TerrainHit> plain = hits_with({}), wooded = hits_with(Canopy{.share = 1.0});
  for (std::size_t pixel = 0; pixel < plain.size(); ++pixel) {
    ASSERT_EQ(wooded[pixel].distance_m, plain[pixel].distance_m) << pixel;
    ASSERT_EQ(wooded[pixel].normal_x, plain[pixel].normal_x) << pixel;
  }
}

// Fails if a ray passes through a crown, hits one where there is none, or is off by more than 1e-3 of a cell:
// on a plain and on a slope of 20 degrees, from far above, from close above and from a glade. A slow test has
// a million rays.
TEST_F(CanopyTest, RaysHitTheCrownsOfADoubleMarch) {
  ColourMap white{
      .columns = 1, .rows = 1, .rgba = {}, .left = 0.0, .top = 0.0, .right = 128.0, .bottom = 128.0};
  white.rgba = {255, 255, 255, 255};
  const std::optional<Canopy> wood = terrain::wood_of({.height_m = 20.0}, terrain::cover_map(white), 2000.0);
  for (const double rise : {0.0, std::tan(20.0 * radians_per_degree)}) {
    make(rise, 35.0);
    for (const auto& [above_m, pitch_rad] : {std::pair(150.0, -0.7), {32.0, -0.35}, {1.7, -0.05}}) {
      const Camera view{.eye_m = {0.5 * side_m, 0.5 * side_m * rise + above_m, 0.5 * side_m},
                        .yaw_rad = 0.6,
                        .pitch_rad = pitch_rad,
                        .vertical_field_of_view_rad = 0.5,
                        .width_px = side_px,
                        .height_px = side_px};
      draw(view, wood);
      const test::CrownComparison found = test::compare_crowns(map_, 20.0, view, 800.0, painter_->hits());
      EXPECT_EQ(found.wrong, 0u) << rise << ", " << above_m;
      EXPECT_LE(found.touching, found.rays / 500) << rise << ", " << above_m;
      EXPECT_LE(found.worst_cells, 1e-3) << rise << ", " << above_m;
      EXPECT_GT(found.crowns, found.rays / 20) << rise << ", " << above_m;
    }
  }
}

// Fails if far crowns on a shore are as bright as the ground below them, where the wood ends within a crown:
// on a slope of 30 degrees it does so in 4 m. Crowns are black.
TEST_F(CanopyTest, CrownsOnAShoreAreNotTheGround) {
  const double rise = -std::tan(30.0 * radians_per_degree), middle_m = 0.5 * side_m;
  make(rise, 35.0, static_cast<float>(rise * (middle_m + 20.0)));
  Camera view = camera(middle_m, 380.0, 500.0, 35.0, -90.0);
  view.eye_m.y += rise * middle_m;
  const std::vector<Texel> plain = draw(view, {});
  const std::vector<Texel> wooded = draw(view, Canopy{.colour = glm::dvec3(1e-3), .share = 1.0});
  const std::vector<TerrainHit> hits = painter_->hits();
  float sand = 0.0f;
  for (const Texel& texel : plain) sand = std::max(sand, texel[0]);
  std::size_t crowns = 0, bright = 0;
  for (std::size_t pixel = 0; pixel < wooded.size(); ++pixel) {
    const double column = static_cast<double>(pixel % side_px), row = static_cast<double>(pixel / side_px);
    const glm::dvec3 way = glm::normalize(
        ray_direction(view, {2.0 * (column + 0.5) / side_px - 1.0, 1.0 - 2.0 * (row + 0.5) / side_px}));
    const glm::dvec3 hit_m = view.eye_m + static_cast<double>(hits[pixel].distance_m) * way;
    if (hit_m.y < rise * hit_m.x + 0.1 || hit_m.x < middle_m + 12.0) continue;
    ++crowns;
    bright += wooded[pixel][0] > 0.4f * sand ? 1 : 0;
  }
  EXPECT_GT(crowns, 20u);
  EXPECT_LT(bright, crowns / 20);
  std::printf("%zu of %zu crowns are bright\n", bright, crowns);
}

// Fails if crowns end where the wood does, and are cut: rays along the straight edge of a wood, 2.5 m and
// more beside it, hit crowns whose middles are in it.
TEST_F(CanopyTest, CrownsHangOverTheEdgeOfTheirWood) {
  make(0.0, 35.0);
  constexpr int columns = 1280;
  ColourMap picture{
      .columns = columns, .rows = 1, .rgba = {}, .left = 0.0, .top = 0.0, .right = 128.0, .bottom = 128.0};
  for (int column = 0; column < columns; ++column) {
    const std::uint8_t cover = column < columns / 2 ? 0 : 255;
    picture.rgba.insert(picture.rgba.end(), {cover, cover, cover, 255});
  }
  const std::optional<Canopy> wood =
      terrain::wood_of({.height_m = 20.0}, terrain::cover_map(picture), 2000.0);
  const Camera view{.eye_m = {0.5 * side_m - 4.0, 8.0, 0.5 * side_m + 100.0},
                    .vertical_field_of_view_rad = 0.2,
                    .width_px = side_px,
                    .height_px = side_px};
  draw(view, wood);
  const std::vector<TerrainHit> hits = painter_->hits();
  int crowns = 0;
  for (std::size_t pixel = 0; pixel < hits.size(); ++pixel) {
    const double column = static_cast<double>(pixel % side_px), row = static_cast<double>(pixel / side_px);
    const glm::dvec3 way = glm::normalize(
        ray_direction(view, {2.0 * (column + 0.5) / side_px - 1.0, 1.0 - 2.0 * (row + 0.5) / side_px}));
    const glm::dvec3 hit_m = view.eye_m + static_cast<double>(hits[pixel].distance_m) * way;
    if (hits[pixel].distance_m < 190.0f && hit_m.y > 1.0 && hit_m.x < 0.5 * side_m - 2.0) ++crowns;
  }
  EXPECT_GT(crowns, 40);
  std::printf("%d rays hit crowns beside the wood\n", crowns);
}

// Fails if woods do not stand against the sky: from 1.7 m above a meadow, a wood from 100 m on hides the sky
// up to half its height at least, and none above its height. Its map says where it is. Rays from the same eye
// hit the ground as they do without it.
TEST_F(CanopyTest, StandAgainstTheSky) {
  make(0.0, 35.0);
  ColourMap picture{
      .columns = 128, .rows = 1, .rgba = {}, .left = 0.0, .top = 0.0, .right = 128.0, .bottom = 128.0};
  for (int cell = 0; cell < 128; ++cell) {
    const std::uint8_t cover = cell < 64 ? 0 : 255;
    picture.rgba.insert(picture.rgba.end(), {cover, cover, cover, 255});
  }
  const std::optional<Canopy> wood =
      terrain::wood_of({.height_m = 20.0}, terrain::cover_map(picture), 2000.0);
  const Camera view{.eye_m = {0.5 * side_m - 150.0, 1.7, 0.5 * side_m},
                    .yaw_rad = 90.0 * radians_per_degree,
                    .vertical_field_of_view_rad = 0.6,
                    .width_px = side_px,
                    .height_px = side_px};
  EXPECT_EQ(painter_->draw(view, {.sampling = {.rays = 1}})[0][3], 0.0f);
  const std::vector<Texel> image = draw(view, wood);
  const std::vector<TerrainHit> hits = painter_->hits();
  for (std::size_t pixel = 0; pixel < image.size(); ++pixel) {
    const double row = static_cast<double>(pixel / side_px);
    const glm::dvec3 way = glm::normalize(ray_direction(view, {0.0, 1.0 - 2.0 * (row + 0.5) / side_px}));
    const double at_wood_m = 1.7 + 150.0 * way.y / way.x;
    if (at_wood_m > 21.0) {
      EXPECT_EQ(image[pixel][3], 0.0f) << pixel;
    }
    if (at_wood_m > 0.0 && at_wood_m < 8.0) {
      EXPECT_EQ(image[pixel][3], 1.0f) << pixel;
      EXPECT_GT(hits[pixel].distance_m, 90.0f) << pixel;
      EXPECT_LT(hits[pixel].distance_m, 260.0f) << pixel;
    }
  }
}

}  // namespace
}  // namespace offing

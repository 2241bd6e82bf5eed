// Materials of a scene over the ground's own cover, as albedos: ground in the light of an even sky, seen from
// above, with one ray a pixel.
#include "host/terrain/shading/materials.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <memory>
#include <numbers>
#include <vector>

#include <glm/vec3.hpp>
#include <gtest/gtest.h>

#include "host/base/numbers/degrees.h"
#include "tests/terrain/example_maps.h"
#include "tests/terrain/terrain_painter.h"

namespace offing {
namespace {

using terrain::Landscape;
using terrain::Material;
using terrain::MaterialLike;
using terrain::Texel;

/// Meadows of 2.6 km without shores, trees' end or snow.
class MaterialsTest : public testing::Test {
 protected:
  static constexpr int posts_a_side = 129;
  static constexpr double spacing_m = 20.0, side_m = spacing_m * (posts_a_side - 1);
  static constexpr float sky_klx = 10.0f;

  void make(const std::function<double(double x_m, double z_m)>& height_m) {
    map_ = test::square_map(posts_a_side, spacing_m, height_m);
    test::PaintedTerrain scene;
    scene.light.sun_red_klx = 0.0f;
    scene.light.sky_red_klx = scene.light.sky_green_klx = scene.light.sky_blue_klx = sky_klx;
    scene.light.sea_level_m = scene.light.beach_line_m = -1e6f;
    scene.light.tree_line_m = scene.light.snow_line_m = 1e6f;
    painter_ = std::make_unique<test::TerrainPainter>(map_, scene);
  }

  /// The whole map from 20 km above, or a square of it about its middle.
  std::vector<Texel> draw(const std::vector<Material>& materials, double shown_m = side_m) {
    constexpr double eye_m = 20e3;
    const Camera camera{.eye_m = {0.5 * side_m, eye_m, 0.5 * side_m},
                        .pitch_rad = -0.5 * std::numbers::pi,
                        .vertical_field_of_view_rad = 2.0 * std::atan(0.5 * shown_m / eye_m),
                        .width_px = side_px,
                        .height_px = side_px};
    if (materials.empty()) return painter_->draw(camera, {.sampling = {.rays = 1}});
    const terrain::MaterialLayer layer(painter_->device(), materials);
    return painter_->draw(camera, {.sampling = {.rays = 1}, .materials = &layer});
  }

  /// Mean red of pixels between these shares of the picture's width.
  static double mean_red(const std::vector<Texel>& image, double from, double to) {
    double sum = 0.0;
    int count = 0;
    for (std::size_t pixel = 0; pixel < image.size(); ++pixel) {
      const double x = (static_cast<double>(pixel % side_px) + 0.5) / side_px;
      if (x < from || x > to) continue;
      sum += image[pixel][0];
      ++count;
    }
    return sum / count;
  }
  static double largest_difference(const std::vector<Texel>& a, const std::vector<Texel>& b, double from,
                                   double to) {
    double largest = 0.0;
    for (std::size_t pixel = 0; pixel < a.size(); ++pixel) {
      const double x = (static_cast<double>(pixel % side_px) + 0.5) / side_px;
      if (x < from || x > to) continue;
      largest = std::max(largest, std::abs(static_cast<double>(a[pixel][0] - b[pixel][0])));
    }
    return largest;
  }

  static constexpr std::size_t side_px = 128;
  test::HeightMap map_;
  std::unique_ptr<test::TerrainPainter> painter_;
};

// Fails if a material has another colour, or lies at other heights than it says: on a slope of 5 degrees from
// 0 to 224 m, one between 80 and 150 m. Its mean is within 10 % of its colour: patterns are brighter here and
// darker there. Elsewhere the picture is that without it, to the last bit.
TEST_F(MaterialsTest, LieBetweenTheirHeights) {
  const double rise = std::tan(5.0 * radians_per_degree);
  make([&](double x_m, double) { return rise * x_m; });
  const std::vector<Texel> plain = draw({});
  const double whole_m = rise * side_m;
  for (const MaterialLike like :
       {MaterialLike::grass, MaterialLike::scree, MaterialLike::rock, MaterialLike::sand}) {
    const std::vector<Texel> laid = draw(
        {{.like = like, .colour = {0.5, 0.1, 0.1}, .lowest_m = 80.0, .highest_m = 150.0, .edge_m = 4.0}});
    EXPECT_EQ(largest_difference(plain, laid, 0.0, 70.0 / whole_m), 0.0);
    EXPECT_EQ(largest_difference(plain, laid, 160.0 / whole_m, 1.0), 0.0);
    // The sky's light on a slope, and what the slope sees of level ground instead.
    const double due = 0.5 * sky_klx / std::numbers::pi;
    EXPECT_NEAR(mean_red(laid, 90.0 / whole_m, 140.0 / whole_m), due, 0.1 * due) << static_cast<int>(like);
  }
}

// Fails if a material lies on other slopes than it says: 10 degrees in the west, 40 in the east.
TEST_F(MaterialsTest, LieBetweenTheirSlopes) {
  make([](double x_m, double) {
    return x_m * std::tan(10.0 * radians_per_degree) +
           std::max(x_m - 0.5 * side_m, 0.0) *
               (std::tan(40.0 * radians_per_degree) - std::tan(10.0 * radians_per_degree));
  });
  const std::vector<Texel> plain = draw({});
  const Material red{.colour = {0.5, 0.1, 0.1}};
  Material steep = red, gentle = red;
  steep.gentlest_rad = 25.0 * radians_per_degree;
  gentle.steepest_rad = 25.0 * radians_per_degree;
  const std::vector<Texel> on_steep = draw({steep}), on_gentle = draw({gentle});
  EXPECT_LT(mean_red(on_steep, 0.05, 0.45), 1.1 * mean_red(plain, 0.05, 0.45));
  EXPECT_GT(mean_red(on_steep, 0.55, 0.95), 2.0 * mean_red(plain, 0.55, 0.95));
  EXPECT_GT(mean_red(on_gentle, 0.05, 0.45), 2.0 * mean_red(plain, 0.05, 0.45));
  EXPECT_LT(mean_red(on_gentle, 0.55, 0.95), 1.1 * mean_red(plain, 0.55, 0.95));
}

// Fails if patches cover another share of the ground, or a later material lies under an earlier one. Patches
// are as large as hundreds of metres, of which the map shows some tens: 0.1 of the share.
TEST_F(MaterialsTest, CoverTheirShare) {
  make([](double, double) { return 100.0; });
  const double none = mean_red(draw({}), 0.0, 1.0);
  Material white{.like = MaterialLike::sand, .colour = glm::dvec3(0.6)};
  const double all = mean_red(draw({white}), 0.0, 1.0);
  for (const double share : {0.0, 0.2, 0.5, 0.8}) {
    white.share = share;
    const double covered = (mean_red(draw({white}), 0.0, 1.0) - none) / (all - none);
    EXPECT_NEAR(covered, share, 0.1) << share;
  }
  const Material black{.like = MaterialLike::sand, .colour = glm::dvec3(0.01)};
  white.share = 1.0;
  EXPECT_LT(mean_red(draw({white, black}), 0.0, 1.0), 0.05 * all);
  EXPECT_GT(mean_red(draw({black, white}), 0.0, 1.0), 0.95 * all);
}

// Fails if two landscapes look alike, or roughness does nothing: the contrast of neighbours in a square of
// 20 m.
TEST_F(MaterialsTest, LandscapesDiffer) {
  make([](double x_m, double) { return 0.3 * std::abs(x_m - 0.5 * side_m); });
  EXPECT_TRUE(terrain::materials_of(Landscape::plain, {}).empty());
  std::vector<double> reds{mean_red(draw({}), 0.0, 1.0)};
  for (const Landscape landscape :
       {Landscape::alpine, Landscape::desert, Landscape::tropical, Landscape::volcanic}) {
    const double red =
        mean_red(draw(terrain::materials_of(landscape, {.shore_m = 0.0, .tree_line_m = 150.0})), 0.0, 1.0);
    for (const double other : reds)
      EXPECT_GT(std::abs(red / other - 1.0), 0.05) << static_cast<int>(landscape);
    reds.push_back(red);
  }
  const auto contrast = [&](double roughness) {
    const std::vector<Texel> image = draw({{.like = MaterialLike::rock, .roughness = roughness}}, 20.0);
    double sum = 0.0;
    for (std::size_t pixel = 1; pixel < image.size(); ++pixel)
      sum += std::abs(static_cast<double>(image[pixel][0] - image[pixel - 1][0]));
    return sum;
  };
  EXPECT_GT(contrast(2.0), 1.2 * contrast(0.0));
}

}  // namespace
}  // namespace offing

// Pictures of lakes whose water is still and black: what they mirror, and where, against geometry in double
// precision.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/terrain/cast/image_rays.h"
#include "host/terrain/lakes/lake_layer.h"
#include "tests/terrain/terrain_painter.h"

namespace offing {
namespace {

using terrain::Lake;
using terrain::Texel;

constexpr int posts_a_side = 65;
constexpr double spacing_m = 2.0;

/// Ground of 128 x 128 m with a lake, and pictures of it with one ray a pixel.
class LakeScene {
 public:
  LakeScene(const std::function<double(double, double)>& height_m, double level_m,
            const test::PaintedTerrain& painted = {}, float ripples = 0.0f)
      : map_{.name = "made",
             .grid = {.columns = posts_a_side,
                      .rows = posts_a_side,
                      .spacing_x_m = spacing_m,
                      .spacing_z_m = spacing_m},
             .heights_m = {}} {
    for (int row = 0; row < posts_a_side; ++row) {
      for (int column = 0; column < posts_a_side; ++column)
        map_.heights_m.push_back(static_cast<float>(height_m(spacing_m * column, spacing_m * row)));
    }
    posts_ = test::posts_of(map_);
    lake_ = std::make_shared<const Lake>(terrain::fill_lake(posts_, 64.0, 64.0, level_m));
    painter_ = std::make_unique<test::TerrainPainter>(map_, painted);
    layer_ = std::make_unique<terrain::LakeLayer>(painter_->device(), std::vector{lake_});
    terrain::LakeLook black;
    black.water.attenuation_red_perm = black.water.attenuation_green_perm =
        black.water.attenuation_blue_perm = 1e3f;
    black.water.ripples_xx = black.water.ripples_zz = ripples;
    layer_->set_looks({&black, 1});
  }

  std::vector<Texel> draw(const Camera& camera, bool has_lake) {
    return painter_->draw(camera, {.sampling = {.rays = 1}, .lakes = has_lake ? layer_.get() : nullptr});
  }

  /// Distances of the ground and the water.
  std::vector<float> distances_m(const Camera& camera) {
    const auto pixels = static_cast<std::size_t>(camera.width_px * camera.height_px);
    const terrain::HeightField& field = painter_->field();
    terrain::HeightField own(painter_->device(), map_.grid, map_.heights_m);
    ocl::Buffer<TerrainHit> hits(painter_->device(), pixels, "hits");
    own.cast(camera, hits);
    std::vector<float> distances_m;
    for (const TerrainHit& hit : hits.read()) distances_m.push_back(hit.distance_m);
    ocl::Buffer<float> planes(painter_->device(), distances_m, "distances");
    layer_->stand_before(field, camera, hits, planes);
    return planes.read();
  }

  double depth_m(double x_m, double z_m) const { return terrain::depth_of_lake(*lake_, posts_, x_m, z_m); }
  double level_m() const { return lake_->level_m; }

 private:
  test::HeightMap map_;
  terrain::TerrainPosts posts_;
  std::shared_ptr<const Lake> lake_;
  std::unique_ptr<test::TerrainPainter> painter_;
  std::unique_ptr<terrain::LakeLayer> layer_;
};

glm::dvec3 ray_of(const Camera& camera, int column, int row) {
  return glm::normalize(ray_direction(
      camera, {(2.0 * column + 1.0) / camera.width_px - 1.0, 1.0 - (2.0 * row + 1.0) / camera.height_px}));
}

/// Fresnel's equations for water, unpolarised.
double mirrored_share(double cosine) {
  const double n = 1.333, inside = std::sqrt(n * n - 1.0 + cosine * cosine);
  const double across = (cosine - inside) / (cosine + inside);
  const double along = (n * n * cosine - inside) / (n * n * cosine + inside);
  return 0.5 * (across * across + along * along);
}

// Fails if water is drawn beyond its shore or left out within, mirrors another share of the sky, or stands at
// another distance: a bowl from above.
TEST(LakeLightTest, MirrorsTheSkyWithinItsShore) {
  LakeScene scene(
      [](double x_m, double z_m) {
        return std::min(10.0, 0.005 * (std::pow(x_m - 64.0, 2) + std::pow(z_m - 64.0, 2)));
      },
      6.0);
  const Camera camera{.eye_m = {64.0, 80.0, 64.0},
                      .pitch_rad = -1.57079,
                      .vertical_field_of_view_rad = 0.9,
                      .width_px = 61,
                      .height_px = 45};
  const std::vector<Texel> dry = scene.draw(camera, false), wet = scene.draw(camera, true);
  const std::vector<float> distances_m = scene.distances_m(camera);
  int on_water = 0, on_land = 0;
  for (int row = 0; row < camera.height_px; ++row) {
    for (int column = 0; column < camera.width_px; ++column) {
      const std::size_t pixel = static_cast<std::size_t>(row * camera.width_px + column);
      const glm::dvec3 ray = ray_of(camera, column, row);
      const double way_m = (scene.level_m() - camera.eye_m.y) / ray.y;
      const glm::dvec3 place_m = camera.eye_m + way_m * ray;
      const double depth_m = scene.depth_m(place_m.x, place_m.z);
      if (depth_m > 0.2) {
        ++on_water;
        EXPECT_NEAR(wet[pixel][0], 3.0 * mirrored_share(-ray.y), 0.01 * 3.0 * mirrored_share(-ray.y));
        EXPECT_NEAR(distances_m[pixel], way_m, 1e-3);
      } else if (scene.depth_m(place_m.x + 1.0, place_m.z) == 0.0 &&
                 scene.depth_m(place_m.x - 1.0, place_m.z) == 0.0 && depth_m == 0.0) {
        ++on_land;
        EXPECT_NEAR(wet[pixel][0], dry[pixel][0], 1e-5);
      }
    }
  }
  EXPECT_GT(on_water, 500);
  EXPECT_GT(on_land, 500);
}

// Fails if still water mirrors the shore across it anywhere but where a mirror would: a hillside that rises
// at 45 degrees in the east, which has one light.
TEST(LakeLightTest, MirrorsTheGroundAcross) {
  test::PaintedTerrain painted;
  painted.sun_elevation_rad = 1.2;  // whose mirror image is not in the picture
  LakeScene scene(
      [](double x_m, double z_m) {
        const bool is_rim = x_m < 24.0 || z_m < 10.0 || z_m > 118.0;
        return std::max(is_rim ? 10.0 : 0.0, x_m - 80.0);
      },
      6.0, painted);
  // High enough to see the sky mirrored below the hill.
  const Camera camera{.eye_m = {10.0, 40.0, 64.0},
                      .yaw_rad = 0.5 * 3.14159265358979,
                      .pitch_rad = -0.4,
                      .vertical_field_of_view_rad = 0.9,
                      .width_px = 40,
                      .height_px = 64};
  const std::vector<Texel> image = scene.draw(camera, true);
  double hillside = 0.0;
  int of_hill = 0, of_sky = 0;
  for (int row = 0; row < camera.height_px; ++row) {
    for (int column = 15; column < 25; ++column) {
      const glm::dvec3 ray = ray_of(camera, column, row);
      const double seen = image[static_cast<std::size_t>(row * camera.width_px + column)][0];
      const double to_hill_m = (camera.eye_m.y + 80.0 - camera.eye_m.x) / (ray.x - ray.y);
      const double height_m = camera.eye_m.y + to_hill_m * ray.y;
      if (height_m > 10.0 && height_m < 40.0) hillside = seen;
      const double way_m = (scene.level_m() - camera.eye_m.y) / ray.y;
      const glm::dvec3 place_m = camera.eye_m + way_m * ray;
      if (way_m < 0.0 || scene.depth_m(place_m.x, place_m.z) < 1.0) continue;
      const bool is_over_rim = camera.eye_m.y + 14.0 * ray.y / ray.x > 10.0;
      if (!is_over_rim) continue;
      // The mirrored ray rises as the other falls.
      const double across_m = (scene.level_m() + 80.0 - place_m.x) / (ray.x + ray.y);
      const double top_m = scene.level_m() - across_m * ray.y;
      const double share = mirrored_share(-ray.y);
      if (across_m > 0.0 && top_m < 46.0) {
        ++of_hill;
        EXPECT_NEAR(seen, hillside * share, 0.02 * hillside * share) << column << ' ' << row;
      } else if (across_m < 0.0 || top_m > 50.0) {
        ++of_sky;
        EXPECT_NEAR(seen, 3.0 * share, 0.01 * 3.0 * share) << column << ' ' << row;
      }
    }
  }
  EXPECT_GT(hillside, 0.0);
  EXPECT_GT(of_hill, 50);
  EXPECT_GT(of_sky, 50);
}

// Fails if ruffled water mirrors the line between a hill and the sky as a line: slopes of 0.05 spread it over
// tens of rows. From row to row the mirrored light, over what water mirrors there, changes by less than 15 %
// of the difference between hill and sky. With two rays for all facets it changed by half of it.
TEST(LakeLightTest, RipplesBlurTheSkyline) {
  constexpr float slope = 0.05f;
  LakeScene scene(
      [](double x_m, double z_m) {
        const bool is_rim = x_m < 24.0 || z_m < 10.0 || z_m > 118.0;
        return std::max(is_rim ? 10.0 : 0.0, std::min(x_m - 80.0, 14.0));
      },
      6.0, {}, slope * slope);
  const Camera camera{.eye_m = {22.0, 12.0, 64.0},
                      .yaw_rad = 0.5 * 3.14159265358979,
                      .pitch_rad = -0.2,
                      .vertical_field_of_view_rad = 0.3,
                      .width_px = 1,
                      .height_px = 96};
  const std::vector<Texel> image = scene.draw(camera, true);
  std::vector<double> mirrored;
  for (int row = 0; row < camera.height_px; ++row) {
    const glm::dvec3 ray = ray_of(camera, 0, row);
    const glm::dvec3 place_m = camera.eye_m + (scene.level_m() - camera.eye_m.y) / ray.y * ray;
    if (ray.y < 0.0 && scene.depth_m(place_m.x, place_m.z) > 1.0)
      mirrored.push_back(static_cast<double>(image[static_cast<std::size_t>(row)][0]) /
                         mirrored_share(-ray.y));
  }
  ASSERT_GT(mirrored.size(), 60u);
  const auto [least, most] = std::ranges::minmax(mirrored);
  EXPECT_GT(most, 1.3 * least) << "no skyline in sight";
  double largest = 0.0;
  for (std::size_t i = 1; i < mirrored.size(); ++i)
    largest = std::max(largest, std::abs(mirrored[i] - mirrored[i - 1]) / (most - least));
  RecordProperty("largest_step", std::to_string(largest));
  EXPECT_LT(largest, 0.15);
}

// Fails if boxes of lakes with more cells than kernels can count are taken. Before: cells of the second one
// were looked up at overflowed places.
TEST(LakeLightTest, RefusesMoreCellsThanAnIntCounts) {
  const auto vast = std::make_shared<const Lake>(Lake{.columns = 40000, .rows = 40000});
  try {
    terrain::LakeLayer(ocl::Device::open(), {vast, vast});
    ADD_FAILURE() << "taken";
  } catch (const Error& error) {
    EXPECT_EQ(
        error.what(),
        std::string("lakes: expected boxes around them of at most 2147483647 cells in all, found more"));
  }
}

// Fails if meadows reach down to the water, or gravel reaches on: between 0.05 and 0.15 m above it ground is
// gravel, which is redder than green, and from 3 m on the picture is the one without a lake. Before: meadows.
TEST(LakeLightTest, ShoresAreBare) {
  test::PaintedTerrain meadows;
  meadows.light.sun_red_klx = 0.0f;
  meadows.light.sky_red_klx = meadows.light.sky_green_klx = meadows.light.sky_blue_klx = 10.0f;
  meadows.light.sea_level_m = meadows.light.beach_line_m = -1e6f;
  meadows.light.tree_line_m = meadows.light.snow_line_m = 1e6f;
  LakeScene scene(
      [](double x_m, double z_m) { return std::max(0.1 * std::hypot(x_m - 64.0, z_m - 64.0), 0.5); }, 3.0,
      meadows);
  const Camera camera{.eye_m = {64.0, 80.0, 64.0},
                      .pitch_rad = -1.57079,
                      .vertical_field_of_view_rad = 1.3,
                      .width_px = 128,
                      .height_px = 128};
  const std::vector<Texel> dry = scene.draw(camera, false), wet = scene.draw(camera, true);
  double gravel_red = 0.0, gravel_green = 0.0, meadow_red = 0.0, meadow_green = 0.0;
  int on_meadow = 0;
  for (int row = 0; row < camera.height_px; ++row) {
    for (int column = 0; column < camera.width_px; ++column) {
      const std::size_t pixel = static_cast<std::size_t>(row * camera.width_px + column);
      const glm::dvec3 ray = ray_of(camera, column, row);
      // Of the cone that the bowl is.
      const double out = std::hypot(ray.x, ray.z), way_m = camera.eye_m.y / (0.1 * out - ray.y);
      const double above_m = 0.1 * out * way_m - scene.level_m();
      if (above_m > 0.05 && above_m < 0.15) {
        gravel_red += static_cast<double>(wet[pixel][0]);
        gravel_green += static_cast<double>(wet[pixel][1]);
        meadow_red += static_cast<double>(dry[pixel][0]);
        meadow_green += static_cast<double>(dry[pixel][1]);
      } else if (above_m > 3.0) {
        ++on_meadow;
        EXPECT_EQ(wet[pixel], dry[pixel]) << column << ' ' << row;
      }
    }
  }
  EXPECT_GT(meadow_green, meadow_red);
  EXPECT_GT(gravel_red, 1.05 * gravel_green);
  EXPECT_GT(on_meadow, 100);
}

}  // namespace
}  // namespace offing

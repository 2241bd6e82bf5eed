// The ground that is drawn near the eye: its posts against the relief in double precision, and what rays hit
// of it.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <memory>
#include <numbers>
#include <optional>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/lakes/lake_layer.h"
#include "host/terrain/walk/relief_height.h"
#include "tests/terrain/relief/relief_reference.h"
#include "tests/terrain/terrain_painter.h"

namespace offing {
namespace {

using terrain::ReliefSettings;
using terrain::ReliefSurface;
using test::PostSheet;

// Meadows, scree and, where it is steep, rock; something stands beside the eye of the first test.
constexpr terrain::LevelDisc disc{.x_m = 520.0, .z_m = 445.0, .radius_m = 12.0};
const ReliefSettings settings{.shore_m = -20.0, .tree_line_m = 25.0, .snow_line_m = 5000.0, .discs = {disc}};

// Materials of all kinds, in patches, between heights and between slopes of that map.
const std::vector<terrain::Material> materials{
    {.like = terrain::MaterialLike::sand, .roughness = 1.5, .highest_m = 20.0, .edge_m = 15.0},
    {.like = terrain::MaterialLike::scree, .roughness = 0.7, .share = 0.6},
    {.like = terrain::MaterialLike::grass, .lowest_m = 10.0, .steepest_rad = 0.5, .share = 0.4},
    {.like = terrain::MaterialLike::rock, .roughness = 1.3, .gentlest_rad = 0.45}};

test::HeightMap rolling_map() {
  return test::valleys({.columns = 90, .rows = 75, .spacing_x_m = 12.0, .spacing_z_m = 15.0});
}

terrain::Lake largest_lake(const terrain::TerrainPosts& posts) {
  terrain::Lake largest;
  for (int row = 3; row < posts.rows - 3; row += 3) {
    for (int column = 3; column < posts.columns - 3; column += 3) {
      try {
        terrain::Lake lake =
            terrain::fill_lake(posts, column * posts.spacing_x_m, row * posts.spacing_z_m, std::nullopt);
        if (lake.area_m2 > largest.area_m2) largest = std::move(lake);
      } catch (const Error&) {
        continue;  // from where water runs off the map
      }
    }
  }
  return largest;
}

class ReliefSurfaceTest : public testing::Test {
 protected:
  double ground_m(double x_m, double z_m) const { return terrain::terrain_at(posts_, x_m, z_m)->height_m; }
  /// An eye so far above the map's surface.
  Camera camera_at(double x_m, double z_m, double above_m) const {
    return {
        .eye_m = {x_m, ground_m(x_m, z_m) + above_m, z_m}, .yaw_rad = 0.7, .width_px = 320, .height_px = 180};
  }
  std::vector<TerrainHit> cast(const Camera& camera, const ReliefSettings& how = settings) {
    relief_.at(field_, camera, camera.eye_m.y - ground_m(camera.eye_m.x, camera.eye_m.z), how);
    ocl::Buffer<TerrainHit> hits(device_, static_cast<std::size_t>(camera.width_px * camera.height_px),
                                 "hits");
    field_.cast(camera, relief_, hits);
    return hits.read();
  }

  /// Relief of posts below an eye that sees them, on the device and in double precision.
  void compare_posts(const ReliefSettings& how);

  test::HeightMap map_ = rolling_map();
  terrain::TerrainPosts posts_ = test::posts_of(map_);
  ocl::Device device_ = ocl::Device::open();
  terrain::HeightField field_{device_, map_.grid, map_.heights_m};
  ReliefSurface relief_{device_};
};

void ReliefSurfaceTest::compare_posts(const ReliefSettings& how) {
  // High enough for the bowl that is left open around the eye, with what is below it in the picture.
  Camera camera = camera_at(500.0, 430.0, 12.0);
  camera.pitch_rad = -0.5 * std::numbers::pi;
  camera.vertical_field_of_view_rad = 3.1;
  cast(camera, how);
  ASSERT_EQ(relief_.params().levels, 3);
  double worst_m = 0.0, highest_m = 0.0;
  int compared = 0, compared_on_disc = 0;
  for (const PostSheet& sheet : test::sheets_of(map_, relief_)) {
    if (sheet.columns != TERRAIN_RELIEF_POSTS) continue;  // the map
    for (int z = 3; z < sheet.cells_z; z += 7) {
      for (int x = 2; x < sheet.cells_x; x += 7) {
        const double x_m = sheet.left_m + x * sheet.step_x_m, z_m = sheet.top_m + z * sheet.step_z_m;
        const double below_m = camera.eye_m.y - ground_m(x_m, z_m);
        if (below_m < 0.05 * std::hypot(x_m - camera.eye_m.x, z_m - camera.eye_m.z)) continue;
        ++compared;
        const double to_disc_m = std::hypot(x_m - disc.x_m, z_m - disc.z_m);
        if (to_disc_m < disc.radius_m) {
          ++compared_on_disc;
          EXPECT_NEAR(sheet.post_m(x, z), ground_m(x_m, z_m), 1e-4);
        }
        const double expected_m = terrain::relief_height_m(posts_, how, x_m, z_m, camera.eye_m);
        const double found_m = static_cast<double>(sheet.post_m(x, z)) - ground_m(x_m, z_m);
        worst_m = std::max(worst_m, std::abs(found_m - expected_m));
        highest_m = std::max(highest_m, expected_m);
      }
    }
  }
  std::printf("posts differ by up to %.2g m, relief of up to %.2f m\n", worst_m, highest_m);
  EXPECT_LE(worst_m, 1e-3);
  EXPECT_GE(highest_m, 0.5);
  EXPECT_GE(compared, 2000);
  EXPECT_GE(compared_on_disc, 20);
}

// Bound: places are exact to 1e-3 steps of the noise, 1e-5 m, on slopes of up to 2, and heights of 100 m to
// 1e-5 m. Found 1e-5 m, limit 1e-3 m, in relief of up to 3 m. Fails if the kernel's relief is not that of
// relief_height_m(), on which walkers stand, if any octave is left out, doubled or in another place, or if
// there is any under what stands there.
TEST_F(ReliefSurfaceTest, PostsAreThoseOfDoublePrecision) {
  compare_posts(settings);
}

// The same limit. Fails if materials have another share of the drawn ground than of the ground on which
// walkers stand, or another relief.
TEST_F(ReliefSurfaceTest, PostsWithMaterialsAreThoseOfDoublePrecision) {
  ReliefSettings how = settings;
  how.materials = materials;
  compare_posts(how);
}

// A third of relief is two thirds less: limits of 20 % for what float and the bowl at the eye do. Fails if
// relief is that of the ground's own cover where a material lies on it, or stays when materials have changed.
// Before: materials changed the light alone.
TEST_F(ReliefSurfaceTest, FollowsMaterials) {
  Camera camera = camera_at(500.0, 430.0, 12.0);
  camera.pitch_rad = -0.5 * std::numbers::pi;
  camera.vertical_field_of_view_rad = 3.1;
  const auto deviation_m = [&](const std::vector<terrain::Material>& laid) {
    ReliefSettings how = settings;
    how.discs.clear();
    how.materials = laid;
    cast(camera, how);
    double sum = 0.0;
    int count = 0;
    const PostSheet sheet = test::sheets_of(map_, relief_).front();
    for (int z = 3; z < sheet.cells_z; ++z) {
      for (int x = 3; x < sheet.cells_x; ++x) {
        const double x_m = sheet.left_m + x * sheet.step_x_m, z_m = sheet.top_m + z * sheet.step_z_m;
        if (std::hypot(x_m - camera.eye_m.x, z_m - camera.eye_m.z) < 8.0) continue;
        sum += std::pow(static_cast<double>(sheet.post_m(x, z)) - ground_m(x_m, z_m), 2);
        ++count;
      }
    }
    return std::sqrt(sum / count);
  };
  const double own_m = deviation_m({});
  const double flat_m = deviation_m({{.like = terrain::MaterialLike::sand, .roughness = 0.0}});
  const double rock_m = deviation_m({{.like = terrain::MaterialLike::rock}});
  const double low_rock_m = deviation_m({{.like = terrain::MaterialLike::rock, .roughness = 1.0 / 3.0}});
  const double sand_m = deviation_m({{.like = terrain::MaterialLike::sand}});
  std::printf("relief deviates by %.3f m, as sand %.3f m, rock %.3f m, a third of rock %.3f m, none %.2g m\n",
              own_m, sand_m, rock_m, low_rock_m, flat_m);
  EXPECT_LE(flat_m, 1e-4);
  EXPECT_GE(own_m, 0.02);
  EXPECT_NEAR(low_rock_m / rock_m, 1.0 / 3.0, 0.2 / 3.0);
  EXPECT_GE(rock_m, 2.0 * sand_m);
  EXPECT_NEAR(deviation_m({}), own_m, 1e-6);
}

// More discs than there is room for. Fails if those near the eye are left out for others.
TEST_F(ReliefSurfaceTest, NearestDiscsAreLevel) {
  Camera camera = camera_at(500.0, 430.0, 12.0);
  camera.pitch_rad = -0.5 * std::numbers::pi;
  camera.vertical_field_of_view_rad = 3.1;
  ReliefSettings many = settings;
  for (int i = 0; i < 100; ++i)
    many.discs.insert(many.discs.begin(), {.x_m = 505.0 + i, .z_m = 530.0, .radius_m = 1.0});
  const auto heights_m = [&](const ReliefSettings& how) {
    cast(camera, how);
    return relief_.heights_m().read();
  };
  ReliefSettings nearest = settings;
  for (int i = 0; i < 63; ++i) nearest.discs.push_back({.x_m = 505.0 + i, .z_m = 530.0, .radius_m = 1.0});
  EXPECT_EQ(heights_m(many), heights_m(nearest));
}

// Fails if posts that are too close for relief have a reach all the same, which eyes would look through.
TEST(ReliefLevelsTest, ReachNowhereWithoutAny) {
  EXPECT_EQ(terrain::relief_levels(4096, 4096, 0.05, 0.05).count, 0);
  EXPECT_EQ(terrain::relief_levels(4096, 4096, 0.05, 0.05).reach_m, 0.0);
  EXPECT_GT(terrain::relief_levels(4096, 4096, 30.0, 30.0).reach_m, 100.0);
}

// Fails if relief raises the bed of a lake, where stones stood out of the water before, or if walkers stand
// on another shore than the drawn one. Limit as above.
TEST_F(ReliefSurfaceTest, EndsAtLakes) {
  ReliefSettings dry = settings;
  dry.discs.clear();
  dry.shore_m = -1e4;
  const auto lake = std::make_shared<const terrain::Lake>(largest_lake(posts_));
  ReliefSettings wet = dry;
  wet.lakes = {lake};
  const terrain::LakeLayer layer(device_, wet.lakes);
  Camera camera = camera_at((lake->first_column + 2) * posts_.spacing_x_m,
                            (lake->first_row + 0.5 * lake->rows) * posts_.spacing_z_m, 12.0);
  camera.pitch_rad = -0.5 * std::numbers::pi;
  camera.vertical_field_of_view_rad = 3.1;
  relief_.at(field_, camera, 12.0, wet, &layer);
  double worst_m = 0.0, without_lake_m = 0.0;
  int in_bed = 0, on_shore = 0;
  for (const PostSheet& sheet : test::sheets_of(map_, relief_)) {
    if (sheet.columns != TERRAIN_RELIEF_POSTS) continue;  // the map
    for (int z = 3; z < sheet.cells_z; z += 7) {
      for (int x = 2; x < sheet.cells_x; x += 7) {
        const double x_m = sheet.left_m + x * sheet.step_x_m, z_m = sheet.top_m + z * sheet.step_z_m;
        const double ground = ground_m(x_m, z_m), below_m = camera.eye_m.y - ground;
        if (below_m < 0.05 * std::hypot(x_m - camera.eye_m.x, z_m - camera.eye_m.z)) continue;
        const double found_m = static_cast<double>(sheet.post_m(x, z)) - ground;
        const double without_m = terrain::relief_height_m(posts_, dry, x_m, z_m, camera.eye_m);
        if (terrain::depth_of_lake(*lake, posts_, x_m, z_m) > 0.0) {
          ++in_bed;
          EXPECT_NEAR(found_m, 0.0, 1e-4);
          without_lake_m = std::max(without_lake_m, without_m);
        }
        const double expected_m = terrain::relief_height_m(posts_, wet, x_m, z_m, camera.eye_m);
        if (expected_m != 0.0 && std::abs(expected_m - without_m) > 0.01) ++on_shore;
        worst_m = std::max(worst_m, std::abs(found_m - expected_m));
      }
    }
  }
  std::printf("posts differ by up to %.2g m, without the lake its bed is up to %.2f m higher, %d %d\n",
              worst_m, without_lake_m, in_bed, on_shore);
  EXPECT_LE(worst_m, 1e-3);
  EXPECT_GE(without_lake_m, 0.2);
  EXPECT_GE(in_bed, 100);
  EXPECT_GE(on_shore, 20);
}

// Fails if a ray passes through the drawn ground, hits it more than 1e-3 cells away from where it is, or
// hits nothing: within levels, where they meet, and where they end.
TEST_F(ReliefSurfaceTest, RaysHitTheDrawnGround) {
  for (const auto& [x_m, z_m, above_m] :
       {std::array{500.0, 430.0, 2.0}, {220.0, 610.0, 6.0}, {30.0, 20.0, 2.5}}) {
    const Camera camera = camera_at(x_m, z_m, above_m);
    const std::vector<TerrainHit> hits = cast(camera);
    const test::ReliefComparison comparison = test::compare(test::sheets_of(map_, relief_), camera, hits);
    std::printf("%zu rays, %zu hits, %zu touching, worst %.2g cells\n", comparison.rays, comparison.hits,
                comparison.touching, comparison.worst_cells);
    EXPECT_EQ(comparison.wrong, 0u);
    EXPECT_LE(comparison.touching, comparison.rays / 1000);
    EXPECT_GE(comparison.hits, comparison.rays / 4);
  }
}

// Fails if relief covers a camera that is above the map's own surface.
TEST_F(ReliefSurfaceTest, NoCameraAboveTheMapIsInside) {
  for (int i = 0; i < 40; ++i) {
    Camera camera = camera_at(100.0 + 21.0 * i, 900.0 - 17.0 * i, 0.05 * (1 + i % 8));
    camera.width_px = 16;
    camera.height_px = 9;
    for (const TerrainHit& hit : cast(camera)) ASSERT_NE(hit.kind, TERRAIN_INSIDE) << i;
  }
}

// A ridge that is a straight line in the map, from its side. Found 0.42 px with relief, 0 without; limits
// 0.2 px and 0.1 px. Fails if outlines of near hills follow the map's posts.
TEST_F(ReliefSurfaceTest, OutlinesAreRough) {
  test::HeightMap ridge{"ridge", {.columns = 41, .rows = 41, .spacing_x_m = 20.0, .spacing_z_m = 20.0}, {}};
  for (int i = 0; i < 41 * 41; ++i)
    ridge.heights_m.push_back(100.0f - 8.0f * static_cast<float>(std::abs(i / 41 - 20)));
  terrain::HeightField field(device_, ridge.grid, ridge.heights_m);
  // From 60 m south of it, looking along the slope.
  const Camera camera{.eye_m = {400.0, 78.0, 460.0},
                      .pitch_rad = 0.2,
                      .vertical_field_of_view_rad = 0.6,
                      .width_px = 160,
                      .height_px = 90};
  const auto roughness_px = [&](double strength) {
    relief_.at(field, camera, 2.0, {.strength = strength, .tree_line_m = 1000.0});
    ocl::Buffer<TerrainHit> buffer(device_, 160 * 90, "hits");
    field.cast(camera, relief_, buffer);
    const std::vector<TerrainHit> hits = buffer.read();
    double sum = 0.0;
    for (int column = 2; column < 160; ++column) {
      const auto top = [&](int x) {
        int row = 0;
        while (row < 90 && hits[static_cast<std::size_t>(160 * row + x)].kind == TERRAIN_MISS) ++row;
        return row;
      };
      // The line through three columns is straight, but for the rows of pixels.
      sum += std::pow(top(column) - 2.0 * top(column - 1) + top(column - 2), 2);
    }
    return std::sqrt(sum / 158.0);
  };
  const double rough_px = roughness_px(1.0), plain_px = roughness_px(0.0);
  std::printf("outline turns by %.2f px from column to column, without relief %.2f px\n", rough_px, plain_px);
  EXPECT_GE(rough_px, 0.2);
  EXPECT_LE(plain_px, 0.1);
}

// Level ground from 12 m above, lit from the side. By theory light differs twice as much where slopes are
// twice as high, less what turns away from the sun. Fails if relief of another strength is lit as if it were
// 1, as it was once.
TEST(ReliefLightTest, HigherReliefHasMoreLightAndShade) {
  const test::HeightMap level{"level",
                              {.columns = 21, .rows = 21, .spacing_x_m = 20.0, .spacing_z_m = 20.0},
                              std::vector<float>(441, 100.0f)};
  test::PaintedTerrain scene = test::PaintedTerrain::covered(level);
  scene.light.sea_level_m = scene.light.beach_line_m = 0.0f;
  scene.light.tree_line_m = 1000.0f;
  scene.light.snow_line_m = 2000.0f;
  test::TerrainPainter painter(level, scene);
  const Camera camera{
      .eye_m = {205.0, 112.0, 205.0}, .pitch_rad = -0.5 * std::numbers::pi, .width_px = 64, .height_px = 64};
  const auto deviation = [&](double strength) {
    painter.show_relief({.strength = strength, .tree_line_m = 1000.0});
    double sum = 0.0, squares = 0.0;
    for (const terrain::Texel& texel : painter.draw(camera, {.sampling = {.rays = 1}})) {
      sum += static_cast<double>(texel[1]);
      squares += static_cast<double>(texel[1]) * static_cast<double>(texel[1]);
    }
    const double mean = sum / 4096.0;
    return std::sqrt(squares / 4096.0 - mean * mean) / mean;
  };
  const double usual = deviation(1.0), high = deviation(2.0);
  std::printf("light deviates by %.3f of its mean, under relief twice as high by %.3f\n", usual, high);
  EXPECT_GE(high, 1.3 * usual);
}

// Fails if there is memory for more levels than any map has. Before: four levels, of which three were used.
TEST(ReliefLevelsTest, AreAllUsed) {
  EXPECT_EQ(terrain::relief_levels(1024, 1024, 90.0, 90.0).count, TERRAIN_RELIEF_LEVELS);
}

// Fails if relief stays when the eye is too far above the ground or off the map, or where it is switched off.
TEST_F(ReliefSurfaceTest, IsLaidOnlyWhereItIsSeen) {
  cast(camera_at(500.0, 430.0, 2.0));
  EXPECT_TRUE(relief_.is_laid());
  cast(camera_at(500.0, 430.0, 400.0));
  EXPECT_FALSE(relief_.is_laid());
  cast(camera_at(500.0, 430.0, 2.0), {.strength = 0.0});
  EXPECT_FALSE(relief_.is_laid());
  Camera camera = camera_at(500.0, 430.0, 2.0);
  camera.eye_m.x = -1.0;
  relief_.at(field_, camera, 2.0, settings);
  EXPECT_FALSE(relief_.is_laid());
}

}  // namespace
}  // namespace offing

// Ground in pictures: laid over sky and sea by its distance.
#include "present/passes/terrain/terrain_pass.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/world_scene.h"
#include "host/terrain/cast/step_colours.h"
#include "present/passes/camera_projection.h"
#include "present/passes/frame.h"
#include "tests/present/gl_test.h"

namespace offing::present {
namespace {

constexpr int width = 96, height = 64;
// Half precision: 2^-11 of a value.
constexpr double half_step = 1.0 / 2048.0;

class TerrainPassTest : public test::GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (!IsSkipped()) device_ = std::make_unique<ocl::Device>(ocl::Device::open());
  }
  void TearDown() override {
    frame_.reset();
    world_.reset();
    GlTest::TearDown();
  }

  void open(const std::string& text, int views_px = 256) {
    const scene::Scene scene = scene::parse_scene("version = 1\n" + text, "a.toml", "");
    world_ = std::make_unique<world::World>(*device_, scene::prepare_world(scene, scene::Warnings::left_out));
    frame_ = std::make_unique<Frame>(*context_, *device_,
                                     FrameSettings{.water = {{64, 64}, 1, views_px}, .transfer = {}});
  }

  static FrameRequest request(const Camera& camera) { return {.camera = camera, .exposure = 0.1}; }

  /// Light [height][width] of 4 floats, row 0 at the bottom.
  std::vector<float> light(const FrameRequest& asked) {
    world_->at(0.0, asked.camera.eye_m.y);
    frame_->draw(*world_, asked);
    return frame_->light().read();
  }

  std::vector<float> depth() const {
    std::vector<float> depth(static_cast<std::size_t>(width) * height);
    glBindTexture(GL_TEXTURE_2D, frame_->light().depth_texture());
    glGetTexImage(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT, GL_FLOAT, depth.data());
    return depth;
  }

  /// Of a pixel of the picture (row 0 at the bottom), where the ground's arrays have it.
  static std::size_t texel(int column, int row) {
    return static_cast<std::size_t>(height - 1 - row) * width + static_cast<std::size_t>(column);
  }
  static glm::dvec3 ray_of(const Camera& camera, int column, int row) {
    return glm::normalize(ray_direction(
        camera, {(2.0 * column + 1.0) / camera.width_px - 1.0, (2.0 * row + 1.0) / camera.height_px - 1.0}));
  }

  static constexpr const char* hills =
      "[terrain]\nposts = 129\nside_m = 4e3\nlongest_m = 2e3\nrelief_m = 700\n";
  static Camera camera() {
    return {.eye_m = {0.0, 1100.0, 1500.0},
            .yaw_rad = 0.3,
            .pitch_rad = -0.2,
            .roll_rad = 0.1,
            .width_px = width,
            .height_px = height};
  }

  std::unique_ptr<ocl::Device> device_;
  std::unique_ptr<world::World> world_;
  std::unique_ptr<Frame> frame_;
};

// Fails if a pixel is not the ground's texel over the sky of its ray: shifted, turned over, or not
// premultiplied. The framebuffer rounds to 2^-11, GLSL's sky is that of OpenCL within 4e-3 (frame_test.cpp).
// Gate 5e-3.
TEST_F(TerrainPassTest, LaysGroundOverTheSky) {
  open(hills);
  const std::vector<float> pixels = light(request(camera()));
  const auto image = world_->terrain()->image().image.read();
  std::vector<std::array<double, 3>> directions;
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column) {
      const glm::dvec3 ray = ray_of(camera(), column, row);
      directions.push_back({ray.x, ray.y, ray.z});
    }
  const auto sky = world_->sky().read_light(directions).sky_kcdpm2;
  std::size_t covered = 0, open_sky = 0;
  double worst = 0.0;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto i = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
      const terrain::Texel& terrain = image[texel(column, row)];
      if (terrain[3] < 1.0f && directions[i][1] < 0.01) continue;  // the sky ends at the horizon
      covered += terrain[3] == 1.0f;
      open_sky += terrain[3] == 0.0f;
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = terrain[c] + (1.0 - terrain[3]) * sky[i][c];
        worst = std::max(worst, std::abs(pixels[4 * i + c] - expected) / std::max(expected, 0.1));
      }
    }
  }
  EXPECT_GT(covered, pixels.size() / 16);
  EXPECT_GT(open_sky, pixels.size() / 40);
  RecordProperty("worst_1e6", static_cast<int>(worst * 1e6));
  EXPECT_LT(worst, 5e-3);
}

// Fails if depth is not that of the hits' distances along the line of sight, where ground covers pixels
// whole: floats, so 2^-23 and what the shader's length() and division add, a few 2^-23. Gate 1e-5 of itself.
TEST_F(TerrainPassTest, HasTheDepthOfItsHits) {
  open(hills);
  light(request(camera()));
  const auto found_hits = world_->terrain()->image().hits.read();
  const auto image = world_->terrain()->image().image.read();
  const std::vector<float> found = depth();
  const glm::dvec3 forward = basis(camera()).forward;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const float coverage = image[texel(column, row)][3];
      if (coverage > 0.0f && coverage < 1.0f) continue;
      const double distance_m = found_hits[texel(column, row)].distance_m;
      const double along = distance_m * glm::dot(ray_of(camera(), column, row), forward);
      const double expected = std::isinf(distance_m) ? 0.0 : near_m / along;
      ASSERT_NEAR(found[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)], expected,
                  1e-5 * expected)
          << column << ", " << row;
    }
  }
}

// Fails if sea and ground do not hide each other: where the ray's ground is above the highest crest the
// ground shows, where it is deeper than the lowest trough the water does.
TEST_F(TerrainPassTest, SharesTheWorldWithTheSea) {
  open(std::string(hills) + "mean_m = 0\n[wind]\nspeed_mps = 4\n[ocean]\nsize = 32\n");
  Camera coast = camera();
  coast.eye_m.y = 800.0;
  coast.pitch_rad = -0.5;
  const std::vector<float> pixels = light(request(coast));
  const auto image = world_->terrain()->image().image.read();
  const auto found_hits = world_->terrain()->image().hits.read();
  const double reach_m = world_->reach().vertical_m;
  std::size_t land = 0, water = 0;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto i = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
      const double distance_m = found_hits[texel(column, row)].distance_m;
      const terrain::Texel& terrain = image[texel(column, row)];
      // Edges are mixed with what is behind; the bed is not drawn, and covers nothing.
      if (std::isinf(distance_m) || (terrain[3] > 0.0f && terrain[3] < 1.0f)) continue;
      const double hit_m = coast.eye_m.y + distance_m * ray_of(coast, column, row).y;
      bool shows_terrain = true;
      for (std::size_t c = 0; c < 3; ++c) {
        shows_terrain =
            shows_terrain && std::abs(pixels[4 * i + c] - terrain[c]) <= 2.0 * half_step * terrain[c];
      }
      // The sea bends with the Earth: 0.4 m at 2 km.
      if (hit_m > reach_m) {
        ++land;
        EXPECT_TRUE(shows_terrain) << column << ", " << row;
      } else if (hit_m < -reach_m - 2.0) {
        ++water;
        EXPECT_FALSE(shows_terrain) << column << ", " << row;
      }
    }
  }
  EXPECT_GT(land, 500u);
  EXPECT_GT(water, 500u);
}

// Fails if the edges of hills are not blended with the water behind them where the middle of the pixel misses
// the hill, whether it sees the sea beyond the map there or the bed under it, or if light of the bed comes
// into them. The water is that of the same sea without ground, which neither mirrors it nor shows its bed;
// the framebuffer rounds to 2^-11, and the blend once more. Gate 5e-3 of the light, which half a hill's
// light, or a bed's, is far beyond.
TEST_F(TerrainPassTest, BlendsEdgesWithTheSea) {
  const std::string sea = "[wind]\nspeed_mps = 4\n[ocean]\nsize = 32\n";
  Camera coast = camera();
  coast.eye_m = {300.0, 320.0, 2600.0};
  coast.yaw_rad = -0.1;
  coast.pitch_rad = -0.15;
  coast.roll_rad = 0.0;
  open(sea, 0);
  const std::vector<float> water = light(request(coast));
  open(std::string(hills) + "mean_m = -60\n" + sea, 0);
  const std::vector<float> pixels = light(request(coast));
  const auto image = world_->terrain()->image().image.read();
  const auto found_hits = world_->terrain()->image().hits.read();
  const double reach_m = world_->reach().vertical_m;
  std::size_t over_bed = 0, over_open_sea = 0;
  for (int row = 1; row + 1 < height; ++row) {
    for (int column = 1; column + 1 < width; ++column) {
      const terrain::Texel& terrain = image[texel(column, row)];
      if (terrain[3] <= 0.0f || terrain[3] >= 1.0f) continue;
      const double rise = ray_of(coast, column, row).y, own_m = found_hits[texel(column, row)].distance_m;
      const bool is_bed = std::isfinite(own_m) && coast.eye_m.y + own_m * rise < -reach_m - 1.0;
      if (rise > -0.01 || (std::isfinite(own_m) && !is_bed)) continue;
      // A hill well before the water, not its shore.
      double hill_m = std::numeric_limits<double>::infinity();
      for (const auto& [right, up] : {std::pair(1, 0), {-1, 0}, {0, 1}, {0, -1}}) {
        const std::size_t beside = texel(column + right, row + up);
        if (image[beside][3] == 1.0f)
          hill_m = std::min(hill_m, static_cast<double>(found_hits[beside].distance_m));
      }
      if (!(hill_m < 0.8 * coast.eye_m.y / -rise)) continue;
      ++(is_bed ? over_bed : over_open_sea);
      const auto i = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
      for (std::size_t c = 0; c < 3; ++c) {
        const double expected = terrain[c] + (1.0 - terrain[3]) * water[4 * i + c];
        EXPECT_NEAR(pixels[4 * i + c], expected, 5e-3 * expected)
            << column << ", " << row << ": " << terrain[3];
      }
    }
  }
  RecordProperty("over_bed", static_cast<int>(over_bed));
  RecordProperty("over_open_sea", static_cast<int>(over_open_sea));
  EXPECT_GT(over_bed, 5u);
  EXPECT_GT(over_open_sea, 5u);
}

// Fails if a pixel of the heat map has another colour than its steps: rounding and dither are less than a
// step of a byte each.
TEST_F(TerrainPassTest, ShowsStepsInTheirColours) {
  open(hills);
  FrameRequest asked = request(camera());
  asked.terrain = TerrainShow::steps;
  light(asked);
  const std::vector<unsigned char> screen = frame_->screen().read_bytes();
  const auto hits = world_->terrain()->image().hits.read();
  const auto srgb = [](double linear) {
    return 255.0 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1.0 / 2.4) - 0.055);
  };
  int most = 0;
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto i = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
      const int steps = hits[texel(column, row)].steps;
      most = std::max(most, steps);
      const auto colour = terrain::step_colour(static_cast<float>(steps));
      for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(screen[3 * i + c], srgb(colour[c]), 2.0) << steps;
    }
  }
  EXPECT_GT(most, 3);
}

// Fails if fewer rays show another picture than a coarser one: shifted by half a texel, with near and far
// mixed, or with holes. Mean difference of covered pixels, as a share of the mean light: measured 0.06 for a
// quarter of the rays; a shift by a texel more than doubles it.
TEST_F(TerrainPassTest, EnlargesCoarserViews) {
  open(hills);
  const std::vector<float> fine = light(request(camera()));
  const auto found_hits = world_->terrain()->image().hits.read();
  FrameRequest asked = request(camera());
  for (const double scale : {0.5, 0.8660254}) {
    asked.quality.ray_share = scale * scale;
    const std::vector<float> coarse = light(asked);
    EXPECT_EQ(world_->terrain()->image().width_px, std::lround(width * scale));
    double difference = 0.0, mean = 0.0;
    for (int row = 0; row < height; ++row) {
      for (int column = 0; column < width; ++column) {
        const auto i = static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column);
        if (std::isinf(found_hits[texel(column, row)].distance_m)) continue;
        EXPECT_GT(coarse[4 * i + 1], 0.0f) << "a hole at " << column << ", " << row;
        difference += std::abs(coarse[4 * i + 1] - fine[4 * i + 1]);
        mean += fine[4 * i + 1];
      }
    }
    RecordProperty(scale == 0.5 ? "half_1e3" : "most_1e3", static_cast<int>(1e3 * difference / mean));
    EXPECT_LT(difference / mean, 0.12) << scale;
  }
}

// Fails if a picture with ground depends on those before it.
TEST_F(TerrainPassTest, RepeatsEveryByte) {
  open(hills);
  const std::vector<float> first = light(request(camera()));
  Camera other = camera();
  other.yaw_rad += 1.0;
  other.width_px = 33;
  light(request(other));
  EXPECT_EQ(light(request(camera())), first);
}

}  // namespace
}  // namespace offing::present

// Clouds in pictures: over sky, sea and meshes, behind what hides them, and flown through.
#include "present/passes/clouds/cloud_pass.h"

#include <array>
#include <cmath>
#include <string>

#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/world_scene.h"
#include "tests/present/passes/cloud_stage.h"

namespace offing::present {
namespace {

using test::CloudStage;

class CloudPassTest : public CloudStage {
 protected:
  static constexpr int width = 160, height = 90;

  static world::WorldParameters scene_of(const char* text) {
    const scene::Scene scene = scene::parse_scene(std::string("version = 1\n") + text, "a.toml", "");
    return scene::prepare_world(scene, scene::Warnings::left_out);
  }
  static world::WorldParameters sea() { return scene_of("[wind]\nspeed_mps = 7\n[ocean]\nsize = 32\n"); }
  static world::WorldParameters sky_alone() {
    world::WorldParameters parameters;
    parameters.has_sea = false;
    return parameters;
  }

  static Camera camera() {
    return {.eye_m = {0.0, 300.0, 0.0},
            .pitch_rad = 0.02,
            .vertical_field_of_view_rad = 0.8,
            .width_px = width,
            .height_px = height};
  }
};

// Fails if what is laid over the sky is not the picture of clouds in the light of the air before them: an
// opaque black wall of a particle 20 km away shows the air alone, which is less than the sky beside it and
// more than nothing; one of light close by shows its own.
TEST_F(CloudPassTest, LaysCloudsOverTheSky) {
  open(sky_alone());
  Camera view = camera();
  const auto wall = [&](double distance_m, float kcdpm2) {
    remove_clouds();
    add_ball(view.eye_m + distance_m * basis(view).forward, 0.8 * distance_m, glm::vec3(kcdpm2));
    const std::vector<float> pixels = light(view);
    const std::size_t i = 4 * (height / 2 * width + width / 2);
    return glm::dvec3(pixels[i], pixels[i + 1], pixels[i + 2]);
  };
  draw_scene(view);
  const std::vector<float> pixels = frame_->light().read();
  const std::size_t i = 4 * (height / 2 * width + width / 2);
  const glm::dvec3 sky(pixels[i], pixels[i + 1], pixels[i + 2]);
  const glm::dvec3 near = wall(50.0, 10.0f), far = wall(20'000.0, 0.0f), farther = wall(60'000.0, 0.0f);
  for (glm::dvec3::length_type c = 0; c < 3; ++c) {
    EXPECT_NEAR(near[c], 10.0, 0.6);
    EXPECT_GT(far[c], 0.1 * sky[c]);
    EXPECT_GT(farther[c], far[c]);
    EXPECT_LT(farther[c], 1.05 * sky[c]);
  }
}

// Fails if clouds show through the sea, or hide what is before them: below the surface they change nothing at
// all, above it they do.
TEST_F(CloudPassTest, EndsAtTheSea) {
  open(sea());
  Camera view = camera();
  view.pitch_rad = -0.9;
  draw_scene(view);
  const std::vector<float> before = frame_->light().read();
  add_heap({0.0, -600.0, -300.0}, 300.0, 60);
  EXPECT_EQ(light(view), before);
  add_heap({0.0, 60.0, -200.0}, 100.0, 60);
  const std::vector<float> after = light(view);
  int changed = 0;
  for (std::size_t i = 0; i < after.size(); i += 4) {
    ASSERT_TRUE(std::isfinite(after[i] + after[i + 1] + after[i + 2]));
    if (after[i] != before[i]) ++changed;
  }
  EXPECT_GT(changed, width * height / 20);
}

// An eye in a cloud above the sea: what lies between them fades the sea, and what lies below the surface does
// not. Straight down from the middle of a ball of radius R the optical depth to a distance z R is that of its
// diameter times z - 22/27 z^3 + 17/45 z^5 - 4/63 z^7, C1 of docs/sources.md summed up. Gates of what is
// left: 4 %: a wave of a metre changes it by 2 %.
TEST_F(CloudPassTest, FadesTheSeaAroundAnEyeInClouds) {
  open(sea());
  constexpr double height_m = 40.0, radius_m = 100.0;
  constexpr float depth = 3.0f;
  Camera view = camera();
  view.eye_m.y = height_m;
  view.pitch_rad = -1.5707;
  view.vertical_field_of_view_rad = 0.1;
  draw_scene(view);
  const std::vector<float> bare = frame_->light().read();
  add_ball(view.eye_m, radius_m, {10.0f, 0.0f, 0.0f}, depth);
  const std::vector<float> found = light(view);
  glm::dvec3 before(0.0), after(0.0);
  for (std::size_t i = 0; i < bare.size(); i += 4) {
    constexpr double pixels = width * height;
    before += glm::dvec3(bare[i], bare[i + 1], bare[i + 2]) / pixels;
    after += glm::dvec3(found[i], found[i + 1], found[i + 2]) / pixels;
  }
  const double z = height_m / radius_m, z3 = z * z * z;
  const double left =
      std::exp(-double{depth} * (z - 22.0 / 27.0 * z3 + 17.0 / 45.0 * z3 * z * z - 4.0 / 63.0 * z3 * z3 * z));
  EXPECT_NEAR(after.y / before.y, left, 0.04 * left);
  EXPECT_NEAR(after.z / before.z, left, 0.04 * left);
  EXPECT_NEAR(after.x, before.x * left + 10.0 * (1.0 - left), 0.4 * left);
}

// Fails if a picture with clouds depends on those before it.
TEST_F(CloudPassTest, RepeatsEveryByte) {
  open(sea());
  add_heap({0.0, 500.0, -1500.0}, 700.0, 300);
  const std::vector<float> first = light(camera());
  Camera other = camera();
  other.yaw_rad += 0.4;
  other.width_px = 33;
  light(other);
  EXPECT_EQ(light(camera()), first);
}

}  // namespace
}  // namespace offing::present

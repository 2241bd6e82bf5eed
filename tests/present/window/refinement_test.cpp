#include "present/window/refinement.h"

#include <gtest/gtest.h>

namespace offing::present {
namespace {

ShownView view_at(double time_s) {
  return {.time_s = time_s, .camera = {}, .scene_revision = 1};
}

// Fails if a view that moves is drawn otherwise than quickly.
TEST(Refinement, MovingViewsAreQuick) {
  Refinement refinement;
  for (double time_s = 0.0; time_s < 1.0; time_s += 0.05) {
    EXPECT_EQ(refinement.next(view_at(time_s), time_s, 0.0), Sharpness::quick);
    refinement.note(view_at(time_s), Sharpness::quick, time_s);
  }
}

// Fails if a view that stays does not go through all pictures, once each, or if it begins before it has
// stayed.
TEST(Refinement, StillViewsGetSharpAndRest) {
  constexpr double settled_s = Refinement::settled_s;
  const ShownView view = view_at(3.0);
  Refinement refinement;
  refinement.note(view, Sharpness::quick, 10.0);
  EXPECT_EQ(refinement.next(view, 10.0 + 0.9 * settled_s, 0.0), std::nullopt);
  EXPECT_EQ(refinement.next(view, 10.0 + 1.1 * settled_s, 0.0), Sharpness::fine);
  refinement.note(view, Sharpness::fine, 10.5);
  EXPECT_FALSE(refinement.is_complete(view));
  EXPECT_EQ(refinement.next(view, 10.5, 0.0), Sharpness::still);
  refinement.note(view, Sharpness::still, 12.0);
  EXPECT_TRUE(refinement.is_complete(view));
  EXPECT_EQ(refinement.next(view, 100.0, 0.0), std::nullopt);
}

// Fails if input, which panels must follow, waits for sharper pictures.
TEST(Refinement, InputComesFirst) {
  const ShownView view = view_at(3.0);
  Refinement refinement;
  refinement.note(view, Sharpness::quick, 10.0);
  EXPECT_EQ(refinement.next(view, 20.0, 20.0 - 0.5 * Refinement::settled_s), std::nullopt);
}

// Fails if anything that a picture depends on leaves the sharp picture of another view in the window.
TEST(Refinement, AnyOtherViewIsDrawn) {
  const ShownView view = view_at(3.0);
  Refinement refinement;
  refinement.note(view, Sharpness::still, 10.0);
  std::vector<ShownView> others(12, view);
  others[0].time_s = 3.1;
  others[1].camera.eye_m.x += 0.1;
  others[2].camera.yaw_rad = 0.1;
  others[3].camera.pitch_rad = 0.1;
  others[4].camera.roll_rad = 0.1;
  others[5].camera.vertical_field_of_view_rad = 0.9;
  others[6].camera.width_px = 100;
  others[7].scene_revision = 2;
  others[8].debug = WaterShow::height;
  others[9].fill = Fill::wireframe;
  others[10].meshes = MeshShow::ids;
  others[11].ray_share = 0.5;
  for (std::size_t i = 0; i < others.size(); ++i) {
    EXPECT_EQ(refinement.next(others[i], 20.0, 0.0), Sharpness::quick) << i;
    EXPECT_FALSE(refinement.is_complete(others[i])) << i;
  }
}

// Fails if a scene that stands is drawn again and again, or one that moves is not.
TEST(Refinement, KnowsScenesThatStand) {
  scene::Scene ground;
  ground.terrain.is_given = true;
  EXPECT_FALSE(moves_by_itself(ground));
  EXPECT_TRUE(moves_by_itself(scene::Scene()));  // the default sea
  scene::Scene mesh = ground;
  mesh.meshes.resize(1);
  EXPECT_FALSE(moves_by_itself(mesh));
  mesh.meshes.front().spin_radps = 0.1;
  EXPECT_TRUE(moves_by_itself(mesh));
  scene::Scene clouds = ground;
  clouds.clouds.resize(1);
  EXPECT_TRUE(moves_by_itself(clouds));
}

}  // namespace
}  // namespace offing::present

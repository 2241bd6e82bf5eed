// A window on ground: walking, flying, going to a point, map, steps and the picked ray.
#include <cmath>
#include <optional>

#include <imgui.h>
#include <imgui_internal.h>

#include "host/scene/schema/parameter_table.h"
#include "present/panels/parameter_widget.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

using scene::CameraMode;

class WindowTerrainTest : public WindowTest {
 protected:
  /// Hills without a sea, seen from above.
  static present::ViewOptions terrain_options() {
    present::ViewOptions options = quick_options();
    scene::Scene& scene = options.scene;
    scene.terrain.is_given = true;
    scene.terrain.fractal = {.posts = 65, .side_m = 2000.0, .relief_m = 300.0, .longest_m = 1500.0};
    scene.view.camera.eye_m = {0.0, 1200.0, 500.0};
    scene.view.camera.pitch_rad = -0.6;
    return options;
  }
  glm::dvec3 eye_m() const { return state().camera.camera().eye_m; }
  /// Under the eye.
  double terrain_m() const { return viewer_->sea().terrain()->terrain_at(eye_m().x, eye_m().z)->height_m; }
  double above_ground_m() const { return eye_m().y - terrain_m(); }
  /// Above the ground as it is drawn, on which walkers stand.
  double above_relief_m() const {
    return above_ground_m() - viewer_->sea().terrain()->relief_m(eye_m().x, eye_m().z);
  }
  void hold(const char* key, int turns) {
    hands_->key(key, Hands::Motion::down);
    turn(turns);
    hands_->key(key, Hands::Motion::up);
    turn();
  }
  void middle_click(Spot spot) {
    hands_->move_to(spot.x, spot.y);
    turn();
    hands_->button(Hands::Button::middle, Hands::Motion::down);
    turn();
    hands_->button(Hands::Button::middle, Hands::Motion::up);
    turn();
  }
  // Beside the panels, and in the lower half, where the ground is.
  static constexpr Spot on_ground{430, 800};
};

// Fails if F does not put the eye on the ground, W does not walk there, or Shift does not run.
TEST_F(WindowTerrainTest, WalksOnTheGround) {
  open(terrain_options());
  press("f");
  turn(2);
  EXPECT_EQ(state().scene.view.mode, CameraMode::walk);
  EXPECT_NEAR(above_relief_m(), 1.7, 1e-6);
  const glm::dvec3 start_m = eye_m();
  hold("w", 6);
  EXPECT_LT(eye_m().z, start_m.z) << "north";
  EXPECT_NEAR(eye_m().x, start_m.x, 1e-3);
  EXPECT_NEAR(above_relief_m(), 1.7, 1e-6);
  press("f");
  EXPECT_EQ(state().scene.view.mode, CameraMode::fly);
  hold("e", 4);
  EXPECT_GT(above_relief_m(), 1.8);
}

// Fails if flying dives into the ground.
TEST_F(WindowTerrainTest, FliesAboveTheGround) {
  open(terrain_options());
  hands_->key("Shift_L", Hands::Motion::down);
  for (int i = 0; i < 20; ++i) {
    hands_->button(Hands::Button::wheel_up, Hands::Motion::down);
    hands_->button(Hands::Button::wheel_up, Hands::Motion::up);
    turn();
  }
  hold("q", 60);
  hands_->key("Shift_L", Hands::Motion::up);
  turn();
  EXPECT_NEAR(above_ground_m(), 0.2, 1e-6) << "it has come down";
  hold("w", 5);
  EXPECT_GE(above_ground_m(), 0.2 - 1e-6);
}

// Fails if a click on the ground lands elsewhere than on what it shows; clicks into the sky do nothing.
TEST_F(WindowTerrainTest, GoesToAClickedPoint) {
  open(terrain_options());
  picture();  // a sharp one: that before it has other sides
  const Camera camera = state().camera.camera();
  int width = 0, height = 0;
  width = static_cast<int>(ImGui::GetIO().DisplaySize.x);
  height = static_cast<int>(ImGui::GetIO().DisplaySize.y);
  const glm::dvec2 clip(2.0 * (on_ground.x + 0.5) / width - 1.0, 1.0 - 2.0 * (on_ground.y + 0.5) / height);
  const auto expected = present::pick_terrain(*viewer_->sea().terrain(), camera, clip);
  ASSERT_TRUE(expected);
  middle_click(on_ground);
  EXPECT_NEAR(eye_m().x, expected->place_m.x, 1e-6);
  EXPECT_NEAR(eye_m().z, expected->place_m.z, 1e-6);
  EXPECT_NEAR(eye_m().y, expected->place_m.y + 1.7, 0.05) << "within 1e-3 cells of 31 m along the ray";
  EXPECT_NEAR(above_ground_m(), 1.7, 1e-9);
  const glm::dvec3 there_m = eye_m();
  drag({430, 850}, {430, 50});  // looks up
  drag({430, 850}, {430, 50});
  middle_click({430, 20});
  EXPECT_EQ(eye_m(), there_m);
}

// Fails if the map is not there, or a click on it does not go to its place: its middle is the ground's.
TEST_F(WindowTerrainTest, GoesToAPlaceOnTheMap) {
  open(terrain_options());
  press("m");
  turn(3);
  const ImGuiWindow* map = ImGui::FindWindowByName("Map");
  ASSERT_NE(map, nullptr);
  const ImVec2 middle = map->InnerRect.GetCenter();
  click({static_cast<int>(middle.x), static_cast<int>(middle.y)});
  const double pixel_m = 2000.0 / 256.0;
  EXPECT_NEAR(eye_m().x, 0.0, 8.0 * pixel_m);
  EXPECT_NEAR(eye_m().z, 0.0, 8.0 * pixel_m);
  EXPECT_NEAR(above_ground_m(), 1.7, 1e-9);
}

// Fails if a click on the map leads to the bed of the sea.
TEST_F(WindowTerrainTest, MapClicksStayAboveTheSea) {
  present::ViewOptions options = terrain_options();
  options.scene.ocean.is_given = true;
  options.scene.terrain.fractal.mean_m = -900.0;
  open(options);
  press("m");
  turn(2);
  const ImGuiWindow* map = ImGui::FindWindowByName("Map");
  ASSERT_NE(map, nullptr);
  const ImVec2 middle = map->InnerRect.GetCenter();
  click({static_cast<int>(middle.x), static_cast<int>(middle.y)});
  turn();
  EXPECT_NEAR(eye_m().x, 0.0, 50.0);
  EXPECT_LT(terrain_m(), -100.0);
  EXPECT_NEAR(eye_m().y, state().scene.view.walker.eye_height_m, 1.0);
}

// Fails if the heat map or the picked ray is not shown, or a ray into the sky is one.
TEST_F(WindowTerrainTest, ShowsStepsAndNodes) {
  open(terrain_options());
  turn();
  const std::vector<unsigned char> before = picture();
  press("t");
  turn();
  EXPECT_NE(picture(), before);
  EXPECT_NE(ImGui::FindWindowByName("Steps of a ray"), nullptr);
  press("t");
  turn();
  EXPECT_EQ(picture(), before);
  hands_->move_to(on_ground.x, on_ground.y);
  turn();
  press("p");
  ASSERT_TRUE(state().pick);
  EXPECT_FALSE(state().pick->nodes.empty());
}

// Fails if rays are not cast for the share of pixels that is chosen.
TEST_F(WindowTerrainTest, CastsAShareOfTheRays) {
  open(terrain_options());
  toggle_header("View");
  choose("rays", "1/4 of the pixels");
  turn();
  EXPECT_EQ(viewer_->sea().terrain()->image().width_px, std::lround(0.5 * width()));
  choose("rays", "each pixel");
  turn();
  EXPECT_EQ(viewer_->sea().terrain()->image().width_px, width());
}

// Fails if a ground that cannot be is taken, or ends the window.
TEST_F(WindowTerrainTest, RefusesFilesThatAreNotThere) {
  open(terrain_options());
  const std::vector<unsigned char> before = picture();
  toggle_header("Height map");
  enter(find(values(), present::parameter_label(*scene::find_parameter("terrain.file"))), "nowhere.tif");
  turn(2);
  EXPECT_NE(message().find("nowhere.tif"), std::string::npos) << message();
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_EQ(state().scene.terrain.file, "");
  EXPECT_EQ(picture(), before);
}

// Fails if an edited ground leaves the eye below it.
TEST_F(WindowTerrainTest, StaysAboveAnEditedGround) {
  open(terrain_options());
  toggle_header("Ground");
  const Spot spot = find(values(), present::parameter_label(*scene::find_parameter("terrain.mean_m")), 70);
  drag(spot, {spot.x + 100, spot.y});
  turn(2);
  EXPECT_GT(state().scene.terrain.fractal.mean_m, 600.0);
  EXPECT_GE(above_ground_m(), 0.0);
}

}  // namespace
}  // namespace offing::test

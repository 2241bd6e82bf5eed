// Highlights under the mouse: picking, handles, keyframes, undo, and what a saved scene shows.
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "host/scene/file/scene_file.h"
#include "present/editing/highlight_handles.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

using present::Handle;

constexpr const char* scene_text = R"(version = 1
[time]
fps = 4

[camera]
x_m = 0
y_m = 1
z_m = 4
yaw_deg = 0
pitch_deg = 0
fov_deg = 40

[sun]
azimuth_deg = 200
elevation_deg = 40

[[light]]
name = "key"
azimuth_deg = 160
elevation_deg = 30

[[mesh]]
name = "egg"
shape = "ellipsoid"
size_m = 1.2
detail = 4
y_m = 1
colour = [0.1, 0.2, 0.5]
)";

class WindowHighlightsTest : public WindowTest {
 protected:
  void open_egg() { open(options_of(scene::parse_scene(scene_text, "egg.toml", "."))); }
  /// Opens the window without its panels.
  void open(const present::ViewOptions& options) {
    WindowTest::open(options);
    press("Tab");
    resize({400, 300});
    turn(3);
  }
  /// Small windows are quick to draw.
  void resize(Spot size) {
    glfwSetWindowSize(viewer_->window(), size.x, size.y);
    turn(3);
  }
  static present::ViewOptions options_of(scene::Scene scene) {
    present::ViewOptions options = quick_options();
    options.scene = std::move(scene);
    return options;
  }

  present::Screen screen() const {
    int width = 0, height = 0;
    glfwGetWindowSize(viewer_->window(), &width, &height);
    return {state().camera.camera(), {width, height}};
  }
  const highlights::DrawnHighlight& shown(std::uint64_t id) const {
    const highlights::DrawnHighlight* found = present::find_highlight(viewer_->sea().meshes(), {0, id});
    if (found == nullptr) throw std::runtime_error("the highlight is gone");
    return *found;
  }
  glm::dvec2 place_px(std::uint64_t id) const { return *present::pixel_of(screen(), box(id).centre_m); }
  highlights::Projector box(std::uint64_t id) const {
    return present::in_world(shown(id).whole, viewer_->sea().meshes()[0].motion());
  }
  glm::dvec2 handle_px(std::uint64_t id, Handle handle) const {
    for (const present::HandlePlace& place : present::handle_places(screen(), box(id))) {
      if (place.handle == handle) return place.place_px;
    }
    throw std::runtime_error("the handle is gone");
  }

  /// Waits for the highlight before it lets go.
  void pull(glm::dvec2 from_px, glm::dvec2 to_px) { WindowTest::pull(from_px, to_px, 5); }
  /// The highlight of a light.
  std::uint64_t id_of(int light) const {
    for (const highlights::DrawnHighlight& highlight : viewer_->sea().meshes()[0].highlights()) {
      if (highlight.light == light) return highlight.id;
    }
    throw std::runtime_error("the light has no highlight");
  }
  void pick(std::uint64_t id) {
    // The first click selects the mesh, where it is not selected already.
    for (int i = 0; i < 2 && (!state().picked || state().picked->id != id); ++i) click(spot(place_px(id)));
    ASSERT_TRUE(state().picked);
    ASSERT_EQ(state().picked->id, id);
  }
  void hold_and_press(const std::vector<const char*>& held, const char* key) {
    for (const char* name : held) hands_->key(name, Hands::Motion::down);
    turn();
    press(key);
    for (const char* name : held) hands_->key(name, Hands::Motion::up);
    turn();
  }
  void undo() { hold_and_press({"Control_L"}, "z"); }
  void redo() { hold_and_press({"Control_L", "Shift_L"}, "z"); }
  std::vector<unsigned char> settled_image() {
    turn(3);
    return picture();
  }
};

// Fails if a click finds another highlight than the one under it, or a click beside the mesh keeps it.
TEST_F(WindowHighlightsTest, ClicksPick) {
  open_egg();
  const std::uint64_t id = id_of(0);
  pick(id);
  const std::uint64_t other = id_of(1);
  pick(other);
  click({10, 10});
  EXPECT_FALSE(state().picked);
}

// Fails if the button deletes the mesh of the highlight that is picked, where the key Delete does not.
TEST_F(WindowHighlightsTest, TheDeleteButtonLeavesTheMesh) {
  open_egg();
  pick(id_of(0));
  press("Tab");
  resize({1000, 500});
  click(find(main_panel(), "delete##objects", 150));
  EXPECT_EQ(state().scene.meshes.size(), 1u);
  EXPECT_EQ(message().substr(0, 30), "a highlight cannot be deleted\n");
  EXPECT_TRUE(state().picked);
}

// The mouse drags a highlight to where it is let go, within three pixels. Fails if it goes elsewhere, if
// others go along, or if the camera turns with it.
TEST_F(WindowHighlightsTest, DragsMoveOneHighlight) {
  open_egg();
  const std::uint64_t id = id_of(0), other = id_of(1);
  const double yaw_rad = state().camera.camera().yaw_rad;
  pick(id);
  const highlights::Projector others = shown(other).projector;
  const glm::dvec2 from_px = place_px(id), to_px = from_px + glm::dvec2(-25.0, 30.0);
  pull(from_px, to_px);
  EXPECT_LE(glm::distance(place_px(id), to_px), 3.0);
  // But for rounding: its axes are made anew in each frame.
  const highlights::Projector now = shown(other).projector;
  EXPECT_LE(glm::distance(now.centre_m, others.centre_m), 1e-12);
  EXPECT_LE(glm::distance(now.right, others.right), 1e-12);
  EXPECT_NEAR(now.width_m, others.width_m, 1e-12);
  EXPECT_NEAR(now.height_m, others.height_m, 1e-12);
  EXPECT_EQ(state().camera.camera().yaw_rad, yaw_rad);
  ASSERT_EQ(state().scene.meshes[0].highlights.size(), 1u);
}

// Handles turn and resize as far as the hand goes. Fails if a handle does what another one does.
TEST_F(WindowHighlightsTest, HandlesTurnAndResize) {
  open_egg();
  const std::uint64_t id = id_of(0);
  pick(id);
  const glm::dvec2 middle_px = place_px(id);
  const glm::dvec2 knob_px = handle_px(id, Handle::rotate) - middle_px;
  pull(middle_px + knob_px, middle_px + glm::dvec2(knob_px.y, -knob_px.x));
  const highlights::HighlightControls turned = shown(id).controls;
  // Anticlockwise as it is seen. Not a quarter turn sharp: the plane is seen askew.
  EXPECT_NEAR(turned.rotation_rad, 0.5 * std::numbers::pi, 0.6);
  EXPECT_EQ(turned.scale, 1.0);
  const double width_m = shown(id).whole.width_m, height_m = shown(id).whole.height_m;
  const glm::dvec2 corner_px = handle_px(id, Handle::scale);
  pull(corner_px, middle_px + 1.5 * (corner_px - middle_px));
  EXPECT_NEAR(shown(id).whole.width_m / width_m, 1.5, 0.15);
  EXPECT_NEAR(shown(id).whole.width_m / shown(id).whole.height_m, width_m / height_m, 1e-9);
  EXPECT_EQ(shown(id).controls.rotation_rad, turned.rotation_rad);
  const double wide_m = shown(id).whole.width_m, high_m = shown(id).whole.height_m;
  const glm::dvec2 side_px = handle_px(id, Handle::width);
  pull(side_px, middle_px + 0.7 * (side_px - middle_px));
  EXPECT_NEAR(shown(id).whole.width_m / wide_m, 0.7, 0.1);
  EXPECT_NEAR(shown(id).whole.height_m, high_m, 1e-9 * high_m);
}

// The whole way of an artist: what was keyed, undone, done again, saved and read back shows the same
// pictures.
TEST_F(WindowHighlightsTest, EditsKeysUndoAndSavedScenesShowTheSame) {
  open_egg();
  const std::uint64_t id = id_of(0);
  const std::vector<unsigned char> untouched = settled_image();
  pick(id);
  pull(place_px(id), place_px(id) + glm::dvec2(-20.0, 25.0));
  const glm::dvec2 knob_px = handle_px(id, Handle::rotate);
  pull(knob_px, knob_px + glm::dvec2(25.0, 15.0));
  const glm::dvec2 middle_px = place_px(id), corner_px = handle_px(id, Handle::scale);
  pull(corner_px, middle_px + 1.4 * (corner_px - middle_px));
  press("k");
  const std::vector<unsigned char> first = settled_image();
  EXPECT_FALSE(first == untouched);
  const scene::ValueKey offset("mesh.highlight.offset_up", {0, 0});
  ASSERT_TRUE(state().scene.tracks.contains(offset));
  const double first_s = state().clock.time_s();

  for (int i = 0; i < 2; ++i) press("period");
  EXPECT_GT(state().clock.time_s(), first_s + 0.4);
  EXPECT_TRUE(settled_image() == first) << "one key holds for all times";
  pull(place_px(id), place_px(id) + glm::dvec2(30.0, -20.0));
  ASSERT_EQ(state().scene.tracks.at(offset).keys.size(), 2u);
  const std::vector<unsigned char> second = settled_image();
  EXPECT_FALSE(second == first);
  undo();
  EXPECT_EQ(state().scene.tracks.at(offset).keys.size(), 1u);
  EXPECT_TRUE(settled_image() == first);
  redo();
  EXPECT_TRUE(settled_image() == second);
  for (int i = 0; i < 2; ++i) press("comma");
  EXPECT_NEAR(state().clock.time_s(), first_s, 1e-9);
  EXPECT_TRUE(settled_image() == first);

  resize({480, 1000});
  press("Tab");
  turn(3);
  save_as("mine.toml");
  EXPECT_FALSE(state().message.is_fault) << message();
  resize({400, 300});
  for (int i = 0; i < 5; ++i) undo();
  EXPECT_TRUE(state().scene.tracks.empty());
  EXPECT_TRUE(state().scene.meshes[0].highlights.empty());
  EXPECT_TRUE(settled_image() == untouched);

  open(options_of(scene::load_scene("mine.toml")));
  EXPECT_TRUE(settled_image() == first);
  for (int i = 0; i < 2; ++i) press("period");
  EXPECT_TRUE(settled_image() == second);
}

}  // namespace
}  // namespace offing::test

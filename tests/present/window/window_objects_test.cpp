// The list of objects, clicks that select them in the picture, handles of meshes, bodies and lights, and new
// objects, a boat among them.
#include <chrono>
#include <cmath>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <gmock/gmock.h>
#include <imgui.h>
// The rows of the list, which only ImGui knows.
#include <imgui_internal.h>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "host/bodies/body_pose.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/schema/parameter_table.h"
#include "present/editing/objects/object_editor.h"
#include "present/editing/objects/object_edits.h"
#include "present/editing/objects/selection.h"
#include "present/panels/outliner.h"
#include "present/panels/parameter_widget.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

using present::ObjectHandle;
using present::ObjectKind;
using present::SceneObject;
using present::Sphere;
using ::testing::HasSubstr;

// The picture of a window of 480 pixels shows nothing but its right end beside the panel: the spheres stand
// there.
constexpr const char* objects_text = R"(version = 1
[camera]
x_m = 0
y_m = 1
z_m = 6
yaw_deg = 0
pitch_deg = 0
fov_deg = 40

[[light]]
name = "lantern"
kind = "place"
x_m = 0.9
y_m = 1.1
z_m = 2

[[mesh]]
name = "ball"
shape = "sphere"
size_m = 0.5
y_m = 1
highlights = "off"

[[mesh]]
name = "box"
shape = "box"
size_m = 0.3
x_m = -1
y_m = 0.6
highlights = "off"
)";

constexpr const char* boat_text = R"(version = 1
[wind]
speed_mps = 0.2
[ocean]
size = 32
[camera]
y_m = 5
z_m = 0
pitch_deg = -15
)";

class WindowObjectsTest : public WindowTest {
 protected:
  static present::ViewOptions options_of(const char* text) {
    present::ViewOptions options = quick_options();
    options.scene = scene::parse_scene(text, "objects.toml", ".");
    return options;
  }
  /// Opens the window without its panels: small windows are quick to draw.
  void open_picture() {
    open(options_of(objects_text));
    press("Tab");
    glfwSetWindowSize(viewer_->window(), 400, 300);
    turn(4);
  }
  /// Shows the panels again, and the lights with them, which are right of the panel then.
  void show_lights() {
    glfwSetWindowSize(viewer_->window(), 1000, 500);
    press("Tab");
    turn(4);
  }

  present::Screen screen() const {
    int width = 0, height = 0;
    glfwGetWindowSize(viewer_->window(), &width, &height);
    return {state().camera.camera(), {width, height}};
  }
  Spot spot_of(const glm::dvec3& place_m) const { return spot(*present::pixel_of(screen(), place_m)); }
  Spot spot_of_mesh(std::size_t mesh) const { return spot_of(state().scene.meshes[mesh].position_m); }
  glm::dvec2 handle_px(ObjectHandle handle) const {
    const auto place = present::held_place(state(), viewer_->sea(), screen());
    if (!place) throw std::runtime_error("nothing has handles");
    for (const auto& each : present::object_handle_places(screen(), place->sphere, place->handles)) {
      if (each.handle == handle) return each.place_px;
    }
    throw std::runtime_error("the handle is not there");
  }
  std::optional<SceneObject> selected() const { return present::selected_object(state()); }

  Spot row(SceneObject object) { return find_in_row(object, "##object"); }
  Spot arrow(SceneObject object) { return find_in_row(object, "##open"); }
  Spot eye(SceneObject object) { return find_in_row(object, "##visible"); }
  static ImGuiWindow* list() {
    const unsigned list_id = main_panel()->GetID("objects");
    return ImGui::FindWindowByName(fmt::format("Offing/objects_{:08X}", list_id).c_str());
  }
  Spot find_in_row(SceneObject object, const std::string& item) {
    ImGuiWindow* list = WindowObjectsTest::list();
    if (list == nullptr) {
      ADD_FAILURE() << "there is no list";
      return {};
    }
    const int kind = static_cast<int>(object.kind), index = static_cast<int>(object.index);
    const unsigned of_kind = ImHashData(&kind, sizeof kind, list->ID);
    const unsigned of_row = ImHashData(&index, sizeof index, of_kind);
    const int end_px = static_cast<int>(list->ContentRegionRect.Max.x - list->Pos.x);
    return find_item(list, present::label_of(state().scene, object), ImHashStr(item.c_str(), 0, of_row),
                     item == "##object" ? 60
                     : item == "##open" ? 16
                                        : end_px - 8);
  }
  void choose_new(const char* label) {
    click(find(main_panel(), "add##objects", 20));
    click(find(open_menu(), label, 20));
  }
};

// Fails if a click in the list selects another object than its row's, or a button or key does not do to it
// what it says, in one step of undo.
TEST_F(WindowObjectsTest, TheListSelectsCopiesAndDeletes) {
  open(options_of(objects_text));
  const std::string before = edited_text();
  EXPECT_FALSE(selected());
  for (const SceneObject object :
       {SceneObject{ObjectKind::mesh, 1}, {ObjectKind::light, 0}, {ObjectKind::sky, 0}}) {
    click(row(object));
    EXPECT_EQ(selected(), object);
  }
  click(row({ObjectKind::mesh, 1}));
  click(find(main_panel(), "duplicate##objects", 70));
  ASSERT_EQ(state().scene.meshes.size(), 3u) << message();
  EXPECT_EQ(state().scene.meshes[2].name, "box 2");
  EXPECT_EQ(selected(), (SceneObject{ObjectKind::mesh, 2})) << "what is new is selected";
  EXPECT_GT(state().scene.meshes[2].position_m.x, state().scene.meshes[1].position_m.x + 0.5);
  press("Delete");
  EXPECT_EQ(edited_text(), before);
  EXPECT_FALSE(selected());
  click(row({ObjectKind::light, 0}));
  press_with_control("d");
  ASSERT_EQ(state().scene.lights.size(), 2u) << message();
  click(find(main_panel(), "delete##objects", 150));
  EXPECT_EQ(edited_text(), before) << message();
  undo(4);
  EXPECT_EQ(edited_text(), before);
  undo();
  EXPECT_EQ(message(), "there is nothing to undo");
}

// Fails if what is selected is not in the middle of what panels leave of the picture, or what has no place
// moves the camera.
TEST_F(WindowObjectsTest, TheCameraLooksAtWhatIsSelected) {
  open(options_of(objects_text));
  glfwSetWindowSize(viewer_->window(), 1000, 500);
  turn(4);
  click(row({ObjectKind::sky, 0}));
  const Camera before = state().camera.camera();
  press("x");
  EXPECT_EQ(message(), "nothing with a place is selected");
  EXPECT_EQ(state().camera.camera().eye_m, before.eye_m);
  click(row({ObjectKind::mesh, 1}));
  click(find(main_panel(), "look at##objects", 230));
  const Camera& now = state().camera.camera();
  const glm::dvec3 way_m = state().scene.meshes[1].position_m - now.eye_m;
  const present::FreeWidth free = state().layout.free_width();
  EXPECT_GT(free.left, -0.8) << "panels cover nothing";
  const CameraBasis axes = basis(now);
  const double ahead_m = glm::dot(way_m, axes.forward);
  EXPECT_NEAR(glm::dot(way_m, axes.right) / ahead_m, 0.5 * (free.left + free.right) * half_extent(now).x,
              0.02);
  EXPECT_NEAR(glm::dot(way_m, axes.up) / ahead_m, 0.0, 0.05);
  EXPECT_LT(glm::length(way_m), 5.0);
}

// Fails if a click on a slider changes its value, or one click or two do not let it be typed, or if keys are
// lost or change their order where they come and go within one frame.
TEST_F(WindowObjectsTest, ClicksTypeValues) {
  open(options_of(objects_text));
  ImGui::GetIO().MouseDoubleClickTime = 60.0f;
  click(row({ObjectKind::mesh, 1}));
  const unsigned block = values()->GetID("properties");
  const std::string size = present::parameter_label(*scene::find_parameter("mesh.size_m"));
  const Spot slider = find_item(values(), size, ImHashStr(size.c_str(), 0, block), 70);
  const double before_m = state().scene.meshes[1].size_m;
  click(slider);
  EXPECT_EQ(state().scene.meshes[1].size_m, before_m);
  press_with_control("a");
  hands_->type("0.79");
  // GLFW takes a key that goes down again within 20 ms for one that repeats.
  const auto erase = [&] {
    std::this_thread::sleep_for(std::chrono::milliseconds(40));
    hands_->press("BackSpace");
  };
  erase();
  hands_->type("58");
  erase();
  erase();
  hands_->type("2");
  hands_->press("Return");
  turn(12);
  EXPECT_EQ(state().scene.meshes[1].size_m, 0.72);
  click(slider);
  click(slider);
  EXPECT_EQ(state().scene.meshes[1].size_m, 0.72);
  press_with_control("a");
  type("0.81");
  press("Return");
  turn(2);
  EXPECT_EQ(state().scene.meshes[1].size_m, 0.81);
}

// Fails if the values below the list are not those of what is selected, or the others come with them.
TEST_F(WindowObjectsTest, ValuesAreOfTheSelection) {
  open(options_of(objects_text));
  click(row({ObjectKind::mesh, 1}));
  const unsigned block = values()->GetID("properties");
  const std::string size = present::parameter_label(*scene::find_parameter("mesh.size_m"));
  const Spot slider = find_item(values(), size, ImHashStr(size.c_str(), 0, block), 70);
  drag(slider, {slider.x + 30, slider.y});
  EXPECT_GT(state().scene.meshes[1].size_m, 0.3);
  EXPECT_EQ(state().scene.meshes[0].size_m, 0.5);
  find(values(), "Highlights");
  using scene::ParameterGroup;
  EXPECT_TRUE(present::is_shown_with_selection(state(), ParameterGroup::highlight));
  EXPECT_FALSE(present::is_shown_with_selection(state(), ParameterGroup::sky));
  press("Escape");
  EXPECT_FALSE(selected());
  EXPECT_TRUE(present::is_shown_with_selection(state(), ParameterGroup::sky));
}

// Fails if a double click does not take a new name, or what is typed is also taken for keys.
TEST_F(WindowObjectsTest, NamesAreTypedInTheList) {
  open(options_of(objects_text));
  ImGui::GetIO().MouseDoubleClickTime = 5.0f;  // where frames are slow
  const Spot ball = row({ObjectKind::mesh, 0});
  click(ball);
  click(ball);
  ASSERT_TRUE(state().renaming);
  type("Boje 7");
  press("Return");
  turn();
  EXPECT_EQ(state().scene.meshes[0].name, "Boje 7") << message();
  EXPECT_FALSE(state().renaming);
  undo();
  EXPECT_EQ(state().scene.meshes[0].name, "ball");
}

// Fails if the eye of a row does not hide its mesh, a hidden mesh can be selected in the picture, or undo
// does not show it again.
TEST_F(WindowObjectsTest, TheEyeHidesMeshes) {
  open(options_of(objects_text));
  turn(2);
  const std::vector<unsigned char> both = picture();
  click(eye({ObjectKind::mesh, 0}));
  EXPECT_EQ(state().scene.meshes[0].material.visible, world::MeshVisibility::off) << message();
  const std::vector<unsigned char> one = picture();
  EXPECT_FALSE(one == both);
  present::ViewOptions without = options_of(objects_text);
  without.scene.meshes.erase(without.scene.meshes.begin());
  undo();
  EXPECT_TRUE(picture() == both);
  redo();
  EXPECT_TRUE(picture() == one);
  press("Tab");
  glfwSetWindowSize(viewer_->window(), 400, 300);
  turn(4);
  click(spot_of_mesh(0));
  EXPECT_FALSE(selected());
  open(without);
  turn(2);
  EXPECT_TRUE(picture() == one) << "as if it were not there";
}

// Fails if a click finds another mesh than the one under it, or a light that is not drawn; or a click beside
// all keeps what was selected, also where clicks pick clouds.
TEST_F(WindowObjectsTest, ClicksSelectInThePicture) {
  open_picture();
  click(spot_of_mesh(0));
  EXPECT_EQ(selected(), (SceneObject{ObjectKind::mesh, 0}));
  click(spot_of_mesh(1));
  EXPECT_EQ(selected(), (SceneObject{ObjectKind::mesh, 1}));
  click(spot_of(state().scene.lights[0].place_m));
  EXPECT_FALSE(selected()) << "lights are drawn with the panels alone";
  click(spot_of_mesh(1));
  while (state().clouds.pick != present::CloudPick::clouds) press("o");
  EXPECT_EQ(selected(), (SceneObject{ObjectKind::mesh, 1}));
  click({395, 295});
  EXPECT_FALSE(selected());
}

// Two lights within a hand's width of a click. Fails if it selects another than the nearest one.
TEST_F(WindowObjectsTest, ClicksSelectTheNearestLight) {
  const std::string second = "[[light]]\nkind = \"place\"\nx_m = 0.96\ny_m = 1.1\nz_m = 2\n";
  open(options_of((objects_text + second).c_str()));
  press("Tab");
  show_lights();
  for (const std::size_t light : {0u, 1u}) {
    click(spot_of(state().scene.lights[light].place_m));
    EXPECT_EQ(selected(), (SceneObject{ObjectKind::light, light}));
  }
}

// Fails if an arrow does not bring a mesh where the hand goes, a ring does not turn it, the rim does not
// resize it, or a drag is not one step of undo.
TEST_F(WindowObjectsTest, HandlesMoveTurnAndResizeMeshes) {
  open_picture();
  const std::string before = edited_text();
  const double yaw_rad = state().camera.camera().yaw_rad;
  click(spot_of_mesh(1));
  ASSERT_EQ(selected(), (SceneObject{ObjectKind::mesh, 1}));
  const glm::dvec3 place_m = state().scene.meshes[1].position_m;
  const double metre_px = 1.0 / present::pixel_m(screen(), place_m);
  const glm::dvec2 arrow_px = handle_px(ObjectHandle::x);
  const auto has_help = [&](glm::dvec2 place_px) {
    hands_->move_to(spot(place_px).x, spot(place_px).y);
    turn(4);
    const ImGuiWindow* help = ImGui::FindWindowByName("##Tooltip_00");
    return help != nullptr && help->Active;
  };
  EXPECT_TRUE(has_help(arrow_px));
  EXPECT_FALSE(has_help(arrow_px + glm::dvec2(40.0, 0.0))) << "beside it";
  pull(arrow_px, arrow_px + glm::dvec2(metre_px, 0.0));
  const glm::dvec3 way_m = state().scene.meshes[1].position_m - place_m;
  EXPECT_NEAR(way_m.x, 1.0, 0.1);
  EXPECT_LE(std::hypot(way_m.y, way_m.z), 1e-9);
  EXPECT_EQ(viewer_->sea().scene().meshes[1].position_m, state().scene.meshes[1].position_m);
  EXPECT_EQ(state().camera.camera().yaw_rad, yaw_rad) << "the hand holds the mesh, not the camera";

  const glm::dvec2 ring_px = handle_px(ObjectHandle::turn_z);
  const auto held = present::held_place(state(), viewer_->sea(), screen());
  const glm::dvec2 middle_px = *present::pixel_of(screen(), held->sphere.centre_m),
                   arm_px = ring_px - middle_px;
  pull(ring_px, middle_px + glm::dvec2(arm_px.y, -arm_px.x));
  EXPECT_NEAR(std::abs(state().scene.meshes[1].roll_rad), 0.5 * std::numbers::pi, 0.1);
  EXPECT_NEAR(state().scene.meshes[1].yaw_rad, 0.0, 1e-6);

  const glm::dvec2 rim_px = handle_px(ObjectHandle::radius);
  pull(rim_px, middle_px + 1.5 * (rim_px - middle_px));
  EXPECT_NEAR(state().scene.meshes[1].scale, 1.5, 0.1);
  undo(3);
  EXPECT_EQ(edited_text(), before);
  undo();
  EXPECT_EQ(message(), "there is nothing to undo");
}

// Fails if handles do not grow with the scale of panels, or are held elsewhere than drawn.
TEST_F(WindowObjectsTest, HandlesGrowWithTheScale) {
  present::ViewOptions options = options_of(objects_text);
  options.ui_scale = 2.0;
  open(options);
  press("Tab");
  glfwSetWindowSize(viewer_->window(), 800, 600);
  turn(4);
  click(spot_of_mesh(1));
  ASSERT_EQ(selected(), (SceneObject{ObjectKind::mesh, 1}));
  const present::Screen usual{state().camera.camera(), {400.0, 300.0}};
  const auto place = present::held_place(state(), viewer_->sea(), usual);
  ASSERT_TRUE(place);
  const glm::dvec3 place_m = state().scene.meshes[1].position_m;
  const double metre_px = 1.0 / present::pixel_m(screen(), place_m);
  for (const auto& each : present::object_handle_places(usual, place->sphere, place->handles)) {
    if (each.handle == ObjectHandle::x)
      pull(2.0 * each.place_px, 2.0 * each.place_px + glm::dvec2(metre_px, 0.0));
  }
  EXPECT_NEAR(state().scene.meshes[1].position_m.x - place_m.x, 1.0, 0.1);
}

// Fails if a hand does not bring a light where it lets go, or the list does not scroll to what is selected in
// the picture.
TEST_F(WindowObjectsTest, HandlesMoveLights) {
  open_picture();
  show_lights();
  EXPECT_EQ(list()->Scroll.y, 0.0f);
  click(spot_of(state().scene.lights[0].place_m));
  EXPECT_GT(list()->Scroll.y, 0.0f);
  const glm::dvec3 place_m = state().scene.lights[0].place_m;
  const glm::dvec2 arrow_px = handle_px(ObjectHandle::y);
  pull(arrow_px, arrow_px + glm::dvec2(0.0, 40.0));
  const glm::dvec3 way_m = state().scene.lights[0].place_m - place_m;
  EXPECT_NEAR(way_m.y, -40.0 * present::pixel_m(screen(), place_m), 0.05);
  EXPECT_EQ(way_m.x, 0.0);
  undo();
  EXPECT_EQ(state().scene.lights[0].place_m, place_m);
}

// Fails if a hand does not bring a layer of clouds, a wake window or a bookmark where it lets go, the world
// has another one then, or a pull is not one step of undo.
TEST_F(WindowObjectsTest, HandlesMoveLayersWakesAndBookmarks) {
  // Clouds that cover nothing are quick to make.
  const std::string places =
      "[[cloud_layer]]\ncoverage = 0\nextent_m = 100\ny_m = 1\n[[ocean.wake]]\ncentre = \"place\"\nlength_m "
      "= 3\n"
      "cells = 16\nhistory_s = 0\n[[bookmark]]\ny_m = 1\nz_m = 1\n";
  open(options_of((std::string(objects_text) + "[ocean]\nsize = 32\n" + places).c_str()));
  const std::string before = edited_text();
  for (const SceneObject object :
       {SceneObject{ObjectKind::cloud_layer, 0}, {ObjectKind::wake, 0}, {ObjectKind::bookmark, 0}}) {
    click(row(object));
    ASSERT_EQ(selected(), object);
    press("Tab");
    glfwSetWindowSize(viewer_->window(), 400, 300);
    turn(4);
    const Sphere held = *present::place_of(state().scene, object, 0.0);
    const glm::dvec2 arrow_px = handle_px(ObjectHandle::x);
    pull(arrow_px, arrow_px + glm::dvec2(1.0 / present::pixel_m(screen(), held.centre_m), 0.0));
    const glm::dvec3 way_m = present::place_of(state().scene, object, 0.0)->centre_m - held.centre_m;
    EXPECT_NEAR(way_m.x, 1.0, 0.1);
    EXPECT_LE(std::hypot(way_m.y, way_m.z), 1e-9);
    EXPECT_EQ(present::place_of(viewer_->sea().wanted(), object, 0.0)->centre_m, held.centre_m + way_m);
    undo();
    EXPECT_EQ(edited_text(), before);
    press("Tab");
    glfwSetWindowSize(viewer_->window(), 1000, 700);
    turn(4);
  }
}

// Fails if a bookmark cannot be selected where it stands, its buttons do not go there and set it, or an icon
// is drawn without the panels.
TEST_F(WindowObjectsTest, BookmarksAreCameras) {
  open(options_of((std::string(objects_text) + "[[bookmark]]\nx_m = 1.4\ny_m = 1\nz_m = 1\n").c_str()));
  press("Tab");
  glfwSetWindowSize(viewer_->window(), 1000, 300);
  turn(4);
  const Spot place = spot_of(state().scene.bookmarks[0].camera.eye_m);
  click(place);
  EXPECT_FALSE(selected());
  press("Tab");
  turn(2);
  click(place);
  EXPECT_EQ(selected(), (SceneObject{ObjectKind::bookmark, 0}));
  glfwSetWindowSize(viewer_->window(), 480, 1000);
  turn(4);
  const unsigned block = values()->GetID("properties");
  const auto press_button = [&](const char* label, int x_px) {
    click(find_item(values(), label, ImHashStr(label, 0, block), x_px));
  };
  const glm::dvec3 eye_m = state().camera.camera().eye_m;
  press_button("look through", 40);
  EXPECT_EQ(state().camera.camera().eye_m, state().scene.bookmarks[0].camera.eye_m);
  press("0");
  EXPECT_EQ(state().camera.camera().eye_m, eye_m);
  press_button("place here", 150);
  EXPECT_EQ(state().scene.bookmarks[0].camera.eye_m, eye_m);
  undo();
  EXPECT_EQ(state().scene.bookmarks[0].camera.eye_m.x, 1.4);
}

// Fails if a new shape is not in the picture, cannot be selected where it is seen, or is not one step of
// undo.
TEST_F(WindowObjectsTest, NewMeshesAreSeen) {
  open(options_of(boat_text));
  const std::string before = edited_text();
  click(find(main_panel(), "add##objects", 20));
  find(open_menu(), "mesh", 20);  // which opens the list of shapes
  turn(10);
  click(find(open_menu(), "sphere", 20));
  ASSERT_EQ(state().scene.meshes.size(), 1u) << message();
  EXPECT_EQ(state().scene.meshes[0].name, "sphere");
  EXPECT_EQ(selected(), (SceneObject{ObjectKind::mesh, 0}));
  EXPECT_TRUE(viewer_->sea().scene().has_sea());
  const auto px = present::pixel_of(screen(), state().scene.meshes[0].position_m);
  ASSERT_TRUE(px);
  EXPECT_GT(px->x, 0.2 * screen().size_px.x);
  EXPECT_LT(px->x, 0.8 * screen().size_px.x);
  EXPECT_GT(px->y, 0.2 * screen().size_px.y);
  EXPECT_LT(px->y, 0.9 * screen().size_px.y);
  undo();
  EXPECT_EQ(edited_text(), before);
}

// From the opened window to a boat that sails and leaves a wake: a click on "add", one on "boat", and the
// space bar. Fails if it stands still, does not keep its speed, or leaves no waves behind it.
TEST_F(WindowObjectsTest, ABoatSailsInThreeSteps) {
  open(options_of(boat_text));
  choose_new("boat");
  ASSERT_EQ(state().scene.bodies.size(), 1u) << message();
  EXPECT_THAT(message(), HasSubstr("added boat"));
  const double start_s = state().clock.time_s();
  const auto pose_at = [&](double time_s) { return viewer_->sea().bodies()->pose(0, time_s); };
  press("space");
  EXPECT_LE(steps(), 3);
  constexpr double sails_s = 4.0, longest_s = 120.0;
  const double end_s = glfwGetTime() + longest_s;
  while (state().clock.time_s() < start_s + sails_s || viewer_->sea().is_behind()) {
    ASSERT_LT(glfwGetTime(), end_s);
    turn();
  }
  press("space");
  const bodies::BodyPose start = pose_at(start_s), now = pose_at(start_s + sails_s);
  const double wanted_mps = state().scene.bodies[0].speed_mps;
  const double way_m = glm::distance(now.mass_centre_m, start.mass_centre_m);
  EXPECT_NEAR(way_m / (sails_s * wanted_mps), 1.0, 0.15);
  EXPECT_NEAR(glm::length(now.velocity_mps) / wanted_mps, 1.0, 0.15) << "the engine keeps its speed";
  const double length_m = state().scene.meshes[0].size_m;
  const glm::dvec3 ahead = glm::normalize(now.mass_centre_m - start.mass_centre_m);
  const auto heights_m = [&](double first_lengths, double step_lengths) {
    std::vector<double> heights;
    for (int i = 0; i < 16; ++i) {
      const glm::dvec3 place_m = now.mass_centre_m + (first_lengths + step_lengths * i) * length_m * ahead;
      heights.push_back(viewer_->sea().surface_height_m(place_m.x, place_m.z));
    }
    return heights;
  };
  const auto largest_difference = [](const std::vector<double>& a, const std::vector<double>& b) {
    double largest = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) largest = std::max(largest, std::abs(a[i] - b[i]));
    return largest;
  };
  const std::vector<double> behind_m = heights_m(-0.7, -0.1), before_m = heights_m(1.2, 0.1);
  click(arrow({ObjectKind::body, 0}));
  click(row({ObjectKind::wake, 0}));
  press("Delete");
  ASSERT_TRUE(state().scene.ocean.wakes.empty()) << message();
  turn(2);
  const double wake_m = largest_difference(behind_m, heights_m(-0.7, -0.1));
  EXPECT_GT(wake_m, 0.005 * length_m) << "waves behind it";
  EXPECT_LT(largest_difference(before_m, heights_m(1.2, 0.1)), 0.1 * wake_m) << "and none before it";
}

// Fails if a boat is more than one row, if its engine, wake and hull are not among the values of that row, if
// the eye of the row does not hide the hull, or if a copy of the row has no wake.
TEST_F(WindowObjectsTest, ABoatIsOneRow) {
  open(options_of(boat_text));
  settle();
  const auto rows = [] {
    const ImGuiWindow* window = list();
    return std::lround((window->ContentSize.y + ImGui::GetStyle().ItemSpacing.y) /
                       ImGui::GetTextLineHeightWithSpacing());
  };
  const auto before = rows();
  choose_new("boat");
  settle();
  const SceneObject boat{ObjectKind::body, 0};
  EXPECT_EQ(selected(), boat) << message();
  EXPECT_EQ(rows(), before + 1);
  const auto find_value = [&](const char* key, unsigned block) {
    const std::string label = present::parameter_label(*scene::find_parameter(key));
    find_item(values(), label, ImHashStr(label.c_str(), 0, block), 70);
  };
  find_value("body.thrust_n", values()->GetID("properties"));
  const auto block_of = [](ObjectKind kind) {
    const int number = static_cast<int>(kind), first = 0;
    return ImHashData(&first, sizeof first, ImHashData(&number, sizeof number, values()->ID));
  };
  const auto open_part = [&](ObjectKind kind) {
    click(find_item(values(), "part", ImHashStr("###values", 0, block_of(kind)), 60));
  };
  open_part(ObjectKind::wake);
  find_value("ocean.wake.length_m", block_of(ObjectKind::wake));
  open_part(ObjectKind::wake);
  open_part(ObjectKind::mesh);
  find_value("mesh.shape", block_of(ObjectKind::mesh));
  open_part(ObjectKind::mesh);
  click(eye(boat));
  EXPECT_EQ(state().scene.meshes[0].material.visible, world::MeshVisibility::off);
  undo();
  click(arrow(boat));
  settle();
  EXPECT_EQ(rows(), before + 3) << "hull and wake";
  click(row({ObjectKind::mesh, 0}));
  EXPECT_EQ(selected(), (SceneObject{ObjectKind::mesh, 0}));
  click(row(boat));
  press_with_control("d");
  ASSERT_EQ(state().scene.bodies.size(), 2u) << message();
  EXPECT_EQ(state().scene.ocean.wakes.size(), 2u);
  press("Delete");
  EXPECT_EQ(state().scene.bodies.size(), 1u) << message();
  EXPECT_EQ(state().scene.meshes.size(), 1u);
  click(row(boat));
  const unsigned block = values()->GetID("properties");
  click(find_item(values(), "stop floating", ImHashStr("stop floating", 0, block), 40));
  EXPECT_TRUE(state().scene.bodies.empty()) << message();
  EXPECT_EQ(state().scene.meshes.size(), 1u);
  undo();
  EXPECT_EQ(state().scene.bodies.size(), 1u);
}

// Fails if a preset of the list does not set the body that is selected with its hull, in one step of undo.
TEST_F(WindowObjectsTest, PresetsSetTheSelectedBody) {
  open(options_of(boat_text));
  choose_new("boat");
  ASSERT_EQ(state().scene.bodies.size(), 1u) << message();
  const std::string before = edited_text();
  const unsigned block = values()->GetID("properties");
  const std::string dinghy = "dinghy##hull-dinghy";
  click(find_item(values(), dinghy, ImHashStr(dinghy.c_str(), 0, block), 120));
  EXPECT_EQ(state().scene.meshes[0].size_m, 6.0) << message();
  EXPECT_EQ(state().scene.bodies[0].draught_m, 0.32);
  EXPECT_EQ(state().scene.bodies[0].thrust_n, 0.0);
  undo();
  EXPECT_EQ(edited_text(), before);
}

// Fails if a new mesh, or one that is moved, sends a boat back to its start.
TEST_F(WindowObjectsTest, OtherMeshesLeaveBoatsAlone) {
  open(options_of(boat_text));
  choose_new("boat");
  ASSERT_EQ(state().scene.bodies.size(), 1u) << message();
  press("space");
  const double start_s = state().clock.time_s(), end_s = glfwGetTime() + 60.0;
  while (state().clock.time_s() < start_s + 1.0 && glfwGetTime() < end_s) turn();
  press("space");
  const auto x_m = [&] { return viewer_->sea().bodies()->pose(0, state().clock.time_s()).mass_centre_m.x; };
  const double there_m = x_m();
  ASSERT_GT(std::abs(there_m - state().scene.bodies[0].x_m), 0.5) << "it has sailed";
  click(find(main_panel(), "add##objects", 20));
  find(open_menu(), "mesh", 20);  // which opens the list of shapes
  turn(10);
  click(find(open_menu(), "sphere", 20));
  ASSERT_EQ(state().scene.meshes.size(), 2u) << message();
  press_with_control("d");
  ASSERT_EQ(state().scene.meshes.size(), 3u) << message();
  press("Delete");
  ASSERT_EQ(state().scene.meshes.size(), 2u) << message();
  EXPECT_EQ(x_m(), there_m);
  undo();
  EXPECT_EQ(x_m(), there_m);
}

// Fails if a boat does not go on from where the hand lets go, jumps back to where it once began, or moves
// before that; if its height or its trim is the hand's.
TEST_F(WindowObjectsTest, BoatsAreDraggedOverTheWater) {
  open(options_of(boat_text));
  choose_new("boat");
  ASSERT_EQ(state().scene.bodies.size(), 1u) << message();
  const std::string before = edited_text();
  press("space");
  const double start_s = state().clock.time_s();
  const double end_s = glfwGetTime() + 60.0;
  while (state().clock.time_s() < start_s + 1.0 && glfwGetTime() < end_s) turn();
  press("space");
  press("Tab");  // the panel would be in the way
  glfwSetWindowSize(viewer_->window(), 400, 300);
  turn(4);
  EXPECT_THROW(handle_px(ObjectHandle::y), std::runtime_error);
  const auto pose = [&] { return viewer_->sea().bodies()->pose(0, state().clock.time_s()); };
  const glm::dvec3 there_m = pose().mass_centre_m;
  ASSERT_GT(std::abs(there_m.x - state().scene.bodies[0].x_m), 0.5) << "it has sailed";
  const glm::dvec2 arrow_px = handle_px(ObjectHandle::z);
  const auto place = present::held_place(state(), viewer_->sea(), screen());
  const glm::dvec2 middle_px = *present::pixel_of(screen(), place->sphere.centre_m);
  pull(arrow_px, arrow_px + 0.5 * (arrow_px - middle_px));
  const scene::BodyScene& body = state().scene.bodies[0];
  EXPECT_NEAR(body.x_m, there_m.x, 1e-6) << "along the arrow alone";
  EXPECT_GT(std::abs(body.z_m - there_m.z), 0.5);
  turn(3);
  EXPECT_NEAR(pose().mass_centre_m.x, body.x_m, 0.5);
  EXPECT_NEAR(pose().mass_centre_m.z, body.z_m, 0.5);
  undo();
  EXPECT_EQ(edited_text(), before) << "one step";
}

}  // namespace
}  // namespace offing::test

// Choosing files in the window's own dialog, by mouse and by keyboard.
#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <imgui.h>
// The lists within the dialog, which only ImGui knows.
#include <imgui_internal.h>

#include "host/scene/file/scene_file.h"
#include "host/scene/schema/parameter_table.h"
#include "present/editing/objects/selection.h"
#include "present/panels/parameter_widget.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

class WindowDialogTest : public WindowTest {
 protected:
  /// A scene in a folder of its own, beside which the program was not started.
  present::ViewOptions scene_in_folder() const {
    std::filesystem::create_directories(folder_.path() / "work");
    const std::filesystem::path file = folder_.path() / "work" / "sea.toml";
    std::ofstream(file) << "version = 1\n# mine\n[ocean]\nsize = 32\n";
    present::ViewOptions options = quick_options();
    options.scene = scene::load_scene(file);
    options.scene.view.camera = quick_options().scene.view.camera;
    options.scene_file = file;
    options.scene_name = "sea";
    return options;
  }
  std::filesystem::path work(const std::string& name) const { return folder_.path() / "work" / name; }

  static ImGuiWindow* dialog() { return ImGui::FindWindowByName("###file dialog"); }
  static bool is_open() { return dialog() != nullptr && dialog()->Active; }
  /// A list within the dialog.
  static ImGuiWindow* part(std::string_view name) {
    for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      const std::string_view whole = window->Name;
      if (window->WasActive && whole.find("###file dialog/" + std::string(name) + "_") != whole.npos)
        return window;
    }
    return nullptr;
  }
  void click_twice(Spot spot) {
    hands_->move_to(spot.x, spot.y);
    turn();
    for (int i = 0; i < 2; ++i) {
      hands_->button(Hands::Button::left, Hands::Motion::down);
      turn();
      hands_->button(Hands::Button::left, Hands::Motion::up);
      turn();
    }
    turn(3);
  }
  void press_with_control_and_shift(const char* key) {
    hands_->key("Shift_L", Hands::Motion::down);
    turn();
    press_with_control(key);
    hands_->key("Shift_L", Hands::Motion::up);
    turn(2);
  }
  /// Into the name, which has the keyboard.
  void enter_name(const std::string& name) {
    press_with_control("a");
    type(name);
    press("Return");
    turn(4);
  }
  void pull_wind() {
    const scene::Parameter& speed = *scene::find_parameter("wind.speed_mps");
    const Spot slider = find(values(), present::parameter_label(speed), 70);
    drag(slider, {slider.x + 30, slider.y});
  }

  /// A GeoTIFF of 4 x 4 heights in steps of 100 m: baseline TIFF 6.0 with the pixel scale and tie point of
  /// GeoTIFF 1.0.
  std::filesystem::path geotiff(const std::string& name) const {
    std::string bytes("II*\0\x08\0\0\0", 8);
    const auto put = [&](const auto& value) {
      bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
    };
    constexpr std::uint16_t count = 12, is_short = 3, is_long = 4, is_double = 12;
    constexpr std::uint32_t end = 8 + 2 + 12 * count + 4, heights = end + 3 * 8 + 6 * 8;
    const auto tag = [&](std::uint16_t number, std::uint16_t type, std::uint32_t length,
                         std::uint32_t value) {
      put(number);
      put(type);
      put(length);
      put(value);
    };
    put(count);
    tag(256, is_short, 1, 4);
    tag(257, is_short, 1, 4);
    tag(258, is_short, 1, 32);
    tag(259, is_short, 1, 1);
    tag(262, is_short, 1, 1);
    tag(273, is_long, 1, heights);
    tag(277, is_short, 1, 1);
    tag(278, is_short, 1, 4);
    tag(279, is_long, 1, 64);
    tag(339, is_short, 1, 3);
    tag(33550, is_double, 3, end);
    tag(33922, is_double, 6, end + 24);
    put(std::uint32_t{0});
    for (const double value : {100.0, 100.0, 0.0, 0.0, 0.0, 0.0, 5e5, 4e6, 0.0}) put(value);
    for (int i = 0; i < 16; ++i) put(static_cast<float>(10 * i));
    std::ofstream(work(name), std::ios::binary) << bytes;
    return work(name);
  }
};

// Fails if wind and "save as" take more than four steps, the file lies elsewhere than beside the scene, or
// the title does not say whether there are unsaved edits.
TEST_F(WindowDialogTest, WindAndSaveAsInFourSteps) {
  open(scene_in_folder());
  EXPECT_EQ(viewer_->shown_title(), "Offing: sea");
  EXPECT_EQ(hands_->title(), "Offing: sea");
  toggle_header("Wind");
  pull_wind();
  EXPECT_EQ(viewer_->shown_title(), "Offing: sea *");
  EXPECT_EQ(hands_->title(), "Offing: sea *");
  press_with_control_and_shift("s");
  ASSERT_TRUE(is_open());
  press("Return");
  EXPECT_LE(steps(), 4);
  turn(3);
  EXPECT_FALSE(is_open());
  EXPECT_FALSE(state().message.is_fault) << message();
  EXPECT_EQ(scene::load_scene(work("sea_edited.toml")).wind.wind_speed_mps,
            state().scene.wind.wind_speed_mps);
  EXPECT_EQ(viewer_->shown_title(), "Offing: sea_edited");
  EXPECT_NE(scene::load_scene(work("sea.toml")).wind.wind_speed_mps, state().scene.wind.wind_speed_mps);
}

// Fails if a folder cannot be made where a scene is saved, the file lies elsewhere than in it, or Esc closes
// more than the field for its name.
TEST_F(WindowDialogTest, MakesAFolder) {
  open(scene_in_folder());
  press_with_control_and_shift("s");
  ASSERT_TRUE(is_open());
  click(find(dialog(), "new folder", 80));
  turn(4);
  press("Escape");
  turn(3);
  ASSERT_TRUE(is_open());
  click(find(dialog(), "new folder", 80));
  turn(4);
  type("mine");
  press("Return");
  turn(4);
  ASSERT_TRUE(is_open());
  EXPECT_TRUE(std::filesystem::is_directory(work("mine")));
  press("Return");
  turn(4);
  EXPECT_TRUE(std::filesystem::exists(work("mine/sea_edited.toml"))) << message();
}

// Fails if a file is replaced without a question, or the question is answered by the Enter that raised it.
TEST_F(WindowDialogTest, AsksBeforeItReplaces) {
  open(scene_in_folder());
  std::ofstream(work("other.toml")) << "version = 1\n";
  const auto size = [&] { return std::filesystem::file_size(work("other.toml")); };
  const auto before = size();
  press_with_control_and_shift("s");
  enter_name("other");
  ASSERT_TRUE(is_open());
  EXPECT_EQ(size(), before);
  press("Return");
  turn(3);
  ASSERT_TRUE(is_open()) << "the answer to begin with is another name";
  EXPECT_EQ(size(), before);
  press("Return");
  turn(3);
  press("Right");
  press("Return");
  turn(3);
  EXPECT_FALSE(is_open());
  EXPECT_GT(size(), before);
  EXPECT_EQ(viewer_->shown_title(), "Offing: other");
}

// Fails if a GeoTIFF takes more than four steps to become the ground.
TEST_F(WindowDialogTest, MapsBecomeTheGround) {
  open(scene_in_folder());
  geotiff("coast.tif");
  press_with_control("o");
  turn(2);
  ASSERT_TRUE(is_open());
  press("Down");  // ".."
  press("Down");
  press("Return");
  EXPECT_LE(steps(), 4);
  turn(6);
  EXPECT_FALSE(is_open());
  EXPECT_FALSE(state().message.is_fault) << message();
  ASSERT_NE(viewer_->sea().terrain(), nullptr);
  EXPECT_EQ(viewer_->sea().terrain()->parameters().extent().width_m, 300.0);
  EXPECT_EQ(present::selected_object(state()), (present::SceneObject{present::ObjectKind::terrain, 0}));
  undo();
  EXPECT_EQ(viewer_->sea().terrain(), nullptr);
}

// Fails if the mouse cannot go through folders and open a file, or a mesh is added where nobody sees it: not
// in the middle of the view.
TEST_F(WindowDialogTest, OpensWithTheMouse) {
  open(scene_in_folder());
  std::filesystem::create_directory(work("meshes"));
  std::ofstream(work("meshes/배 ü.obj"))
      << "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  click(find(main_panel(), "open ...", 60));
  turn(2);
  ASSERT_TRUE(is_open());
  click_twice(find(part("entries"), "##entry", 20, 1));
  click(find(part("entries"), "##entry", 20, 1));
  click(find(dialog(), "open", 20));
  turn(4);
  EXPECT_FALSE(is_open());
  ASSERT_EQ(state().scene.meshes.size(), 1u) << message();
  const glm::dvec3 eye_m = state().camera.camera().eye_m;
  EXPECT_NEAR(glm::distance(state().scene.meshes[0].position_m, glm::dvec3(eye_m.x, 0.0, eye_m.z)), 30.0,
              1.0);
}

// Fails if the button of a value that names a file lists other files, or what is chosen there is not the
// value and one step of undo.
TEST_F(WindowDialogTest, ValuesThatNameFilesAreChosen) {
  present::ViewOptions options = scene_in_folder();
  options.scene.meshes.resize(1);
  std::ofstream(work("notes.odt")) << "x";
  std::ofstream(work("wedge.obj"))
      << "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  open(options);
  toggle_header("Meshes");
  click(find(values(), "...##browse mesh.file", 20, 0));
  turn(2);
  ASSERT_TRUE(is_open());
  press("Down");  // ".."
  press("Down");
  press("Return");
  turn(4);
  EXPECT_FALSE(is_open());
  EXPECT_EQ(state().scene.meshes[0].file, work("wedge.obj").string()) << message();
  EXPECT_FALSE(state().message.is_fault) << message();
  undo();
  EXPECT_EQ(state().scene.meshes[0].file, "");
}

// Fails if keys that are typed fly the camera or open the help, Esc does not close the dialog, or its lists
// keep it open.
TEST_F(WindowDialogTest, HasTheKeyboard) {
  open(scene_in_folder());
  const Camera before = state().camera.camera();
  press_with_control("o");
  turn(2);
  type("wash_h");
  EXPECT_FALSE(state().shows_help);
  EXPECT_EQ(state().camera.camera().eye_m, before.eye_m);
  press("Return");
  turn(3);
  EXPECT_TRUE(is_open()) << "there is no such file";
  press("Escape");
  turn(2);
  EXPECT_FALSE(is_open());
  press("h");
  EXPECT_TRUE(state().shows_help);
  press_with_control("o");
  turn(2);
  hands_->close();
  turn(2);
  EXPECT_FALSE(is_open()) << "there is nothing to save, and the window may go";
}

// Fails if a file that was opened or saved is not among the recent ones of the next window.
TEST_F(WindowDialogTest, KnowsRecentFiles) {
  present::ViewOptions options = scene_in_folder();
  std::ofstream(folder_.path() / "second.toml") << "version = 1\n[ocean]\nsize = 32\n[wind]\nspeed_mps = 3\n";
  open(options);
  drop({folder_.path() / "second.toml"});
  open(options);
  press_with_control("o");
  turn(2);
  const Spot second = find(part("places"), "##recent", 20, 1);
  click_twice(second);
  turn(3);
  EXPECT_THAT(message(), HasSubstr("opened second"));
  EXPECT_EQ(state().scene.wind.wind_speed_mps, 3.0);
}

// Fails if Ctrl N does not begin a new scene that keeps the old one's edits for Ctrl Z, Ctrl S saves it
// without asking for a name, or Ctrl Y does not redo.
TEST_F(WindowDialogTest, NewScenesAskForAName) {
  open(scene_in_folder());
  toggle_header("Wind");
  pull_wind();
  const std::string edited = edited_text();
  press_with_control("n");
  turn(4);
  EXPECT_THAT(message(), HasSubstr("edits of sea are not saved"));
  EXPECT_EQ(viewer_->shown_title(), "Offing");
  press_with_control("1");
  EXPECT_EQ(viewer_->shown_title(), "Offing *");
  press_with_control("s");
  turn(2);
  ASSERT_TRUE(is_open());
  enter_name(work("mine").string());
  EXPECT_EQ(scene::load_scene(work("mine.toml")).bookmarks.size(), 1u) << message();
  EXPECT_EQ(viewer_->shown_title(), "Offing: mine");
  undo(2);
  EXPECT_EQ(edited_text(), edited);
  undo();
  EXPECT_NE(edited_text(), edited);
  press_with_control("y");
  EXPECT_EQ(edited_text(), edited);
}

}  // namespace
}  // namespace offing::test

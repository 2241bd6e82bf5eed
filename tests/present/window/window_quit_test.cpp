// Saving, quitting, and Esc, which must not lose edits.
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <imgui.h>
#include <imgui_internal.h>

#include "host/io/whole_file.h"
#include "host/scene/file/scene_file.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

class WindowQuitTest : public WindowTest {
 protected:
  /// A scene whose file has this below its version.
  present::ViewOptions scene_of(const std::string& name, const std::string& text) const {
    std::ofstream(name) << "version = 1\n" << text;
    present::ViewOptions options = quick_options();
    options.scene = scene::load_scene(name);
    options.scene.view.camera = quick_options().scene.view.camera;
    options.scene_file = name;
    options.scene_name = std::filesystem::path(name).stem().string();
    return options;
  }
  present::ViewOptions small_sea() const { return scene_of("sea.toml", "[ocean]\nsize = 32\n"); }
  /// By the keyboard: this view becomes a bookmark.
  void edit() {
    press_with_control("1");
    ASSERT_EQ(state().scene.bookmarks.size(), 1u) << message();
  }
  static bool asks() {
    const ImGuiWindow* dialog = ImGui::FindWindowByName("###quit");
    return dialog != nullptr && dialog->Active;
  }
  void click_in_dialog(const std::string& button) {
    ImGuiWindow* dialog = ImGui::FindWindowByName("###quit");
    const int x_px = button == "save" ? 15 : button == "discard" ? 70 : 135;
    find(dialog, button, x_px);
    hands_->button(Hands::Button::left, Hands::Motion::down);
    turn();
    hands_->button(Hands::Button::left, Hands::Motion::up);
    is_open_ = viewer_->turn() && viewer_->turn();
  }
  static std::size_t bookmarks_in(const std::string& file) {
    return scene::load_scene(file).bookmarks.size();
  }

  bool is_open_ = true;
};

// Fails if Esc ends the window, leaves a list open, or does not lay down the tool.
TEST_F(WindowQuitTest, EscapeClosesListsThenDeselects) {
  open(quick_options());
  edit();
  press("b");
  ASSERT_EQ(state().clouds.tool, present::CloudTool::place_ball);
  toggle_header("View");
  click(find(values(), "show"));
  ASSERT_NE(open_list(), nullptr);
  ASSERT_TRUE(open_list()->Active);
  press("Escape");
  EXPECT_FALSE(open_list()->Active);
  EXPECT_EQ(state().clouds.tool, present::CloudTool::place_ball) << "only the list is closed first";
  press("h");
  ASSERT_TRUE(state().shows_help);
  press("Escape");
  EXPECT_FALSE(state().shows_help);
  EXPECT_EQ(state().clouds.tool, present::CloudTool::place_ball) << "only the keys are closed then";
  press("Escape");
  EXPECT_EQ(state().clouds.tool, present::CloudTool::pick);
  press("Escape");
  EXPECT_THAT(message(), HasSubstr("Ctrl Q quits"));
  EXPECT_TRUE(viewer_->turn());
}

// Fails if the window's button or Ctrl Q discards edits without a question, or an answer does something else.
TEST_F(WindowQuitTest, AsksWhatBecomesOfEdits) {
  open(small_sea());
  edit();
  hands_->close();
  EXPECT_TRUE(viewer_->turn());
  turn();
  ASSERT_TRUE(asks());
  const Camera before = state().camera.camera();
  press("w");
  press("b");
  EXPECT_EQ(state().camera.camera().eye_m, before.eye_m) << "keys are the dialog's";
  EXPECT_EQ(state().clouds.tool, present::CloudTool::pick);
  press("Escape");
  EXPECT_FALSE(asks());
  hands_->key("Control_L", Hands::Motion::down);
  press("q");
  hands_->key("Control_L", Hands::Motion::up);
  ASSERT_TRUE(asks());
  click_in_dialog("cancel");
  EXPECT_TRUE(is_open_);
  turn();
  EXPECT_FALSE(asks());
  EXPECT_EQ(bookmarks_in("sea.toml"), 0u);
  press_with_control("q");
  click_in_dialog("save");
  EXPECT_FALSE(is_open_) << message();
  EXPECT_EQ(bookmarks_in("sea.toml"), 1u);

  open(small_sea());
  edit();
  press_with_control("q");
  click_in_dialog("discard");
  EXPECT_FALSE(is_open_);
  EXPECT_EQ(bookmarks_in("sea.toml"), 0u);

  open(small_sea());
  hands_->close();
  EXPECT_FALSE(viewer_->turn()) << "there is nothing to save";
}

// Fails if Ctrl S does not save the scene that is open, the window still asks after it, or a second one is
// refused.
TEST_F(WindowQuitTest, ControlSSavesTheScene) {
  open(small_sea());
  edit();
  press_with_control("s");
  EXPECT_FALSE(state().message.is_fault) << message();
  EXPECT_THAT(message(), HasSubstr("sea.toml"));
  EXPECT_EQ(bookmarks_in("sea.toml"), 1u);
  press_with_control("2");
  press_with_control("s");
  EXPECT_FALSE(state().message.is_fault) << message();
  EXPECT_EQ(bookmarks_in("sea.toml"), 2u);
  hands_->close();
  EXPECT_FALSE(viewer_->turn());
}

// Fails if Ctrl S loses comments, what another program wrote meanwhile, or the file that a link names.
TEST_F(WindowQuitTest, SavingLosesNothing) {
  present::ViewOptions options = scene_of("sea.toml", "# mine\n[ocean]\nsize = 32\n");
  open(options);
  edit();
  press_with_control("s");
  EXPECT_THAT(message(), HasSubstr("sea.toml"));
  EXPECT_EQ(bookmarks_in("sea.toml"), 1u);
  // The camera that the test was opened with and the bookmark are new; the rest of the text stays.
  const std::string text = read_whole_file("sea.toml", {.kind = "a scene file", .most_bytes = 1 << 20});
  EXPECT_THAT(text, HasSubstr("# mine\n[ocean]\nsize = 32\n\n[camera]\npitch_deg = "));
  press_with_control("2");
  press_with_control("s");
  EXPECT_EQ(bookmarks_in("sea.toml"), 2u) << message();
  std::ofstream("sea.toml") << "version = 1\n";
  press_with_control("3");
  press_with_control("s");
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_THAT(message(), HasSubstr("another program has changed it"));
  EXPECT_EQ(bookmarks_in("sea.toml"), 0u);

  options = small_sea();
  std::filesystem::create_symlink("sea.toml", "link.toml");
  options.scene_file = "link.toml";
  options.scene_name = "link";
  open(options);
  edit();
  press_with_control("s");
  turn(2);
  press("Return");
  turn(2);
  EXPECT_THAT(message(), HasSubstr("link_edited.toml"));
  EXPECT_TRUE(std::filesystem::is_symlink("link.toml"));
}

// Fails if edits of a scene that was left for another one are lost without a question, or not saved with it;
// if a fault in saving ends the window all the same.
TEST_F(WindowQuitTest, ScenesThatWereLeftAreSavedToo) {
  open(small_sea());
  edit();
  std::ofstream("other.toml") << "version = 1\n# mine\n[ocean]\nsize = 32\n";
  drop({"other.toml"});
  ASSERT_THAT(message(), HasSubstr("opened other"));
  edit();
  std::ofstream("other.toml") << "version = 1\n";
  press_with_control("q");
  press_with_control("s");
  EXPECT_TRUE(viewer_->turn());
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_THAT(message(), HasSubstr("other.toml: another program has changed it"));
  std::ofstream("other.toml") << "version = 1\n# mine\n[ocean]\nsize = 32\n";
  press_with_control("q");
  press_with_control("s");
  EXPECT_FALSE(viewer_->turn()) << message();
  EXPECT_EQ(bookmarks_in("other.toml"), 1u);
  EXPECT_EQ(bookmarks_in("sea.toml"), 1u);
}

}  // namespace
}  // namespace offing::test

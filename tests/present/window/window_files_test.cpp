// Files that are dropped on the window, and scenes that are opened in it.
#include <algorithm>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <imgui.h>
// The lists within the panel, which only ImGui knows.
#include <imgui_internal.h>

#include "host/io/frame_name.h"
#include "host/scene/file/scene_file.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

class WindowFilesTest : public WindowTest {
 protected:
  std::filesystem::path file(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_.path() / name;
    std::ofstream(path) << text;
    return path;
  }
  std::filesystem::path tetrahedron(const std::string& name) const {
    return file(name, "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n");
  }
  std::filesystem::path heights(const std::string& name) const {
    return file(name, "ncols 3\nnrows 3\nxllcorner 0\nyllcorner 0\ncellsize 100\n1 2 3\n4 9 6\n7 8 9\n");
  }
};

// Fails if a file of any kind that scenes have files of is not shown, is not one edit, or stays when that is
// undone; if a name of another language is not found.
TEST_F(WindowFilesTest, AreEditsOfTheScene) {
  open(quick_options());
  const std::string before = edited_text();
  drop({tetrahedron("배 ü.obj")});
  EXPECT_FALSE(state().message.is_fault) << message();
  EXPECT_THAT(message(), HasSubstr("added the mesh 배 ü"));
  ASSERT_EQ(viewer_->sea().meshes().size(), 1u);
  EXPECT_TRUE(viewer_->sea().scene().has_sea());
  drop({heights("año.asc")});
  EXPECT_FALSE(state().message.is_fault) << message();
  ASSERT_NE(viewer_->sea().terrain(), nullptr);
  EXPECT_EQ(viewer_->sea().terrain()->parameters().extent().width_m, 200.0);
  drop({OFFING_SOURCES "/scenes/example_sea.data_spec"});
  EXPECT_FALSE(state().message.is_fault) << message();
  EXPECT_THAT(viewer_->sea().scene().ocean.spectrum_file, HasSubstr("example_sea.data_spec"));
  drop({file("one.ply",
             "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
             "property float radius\nproperty float optical_mass\nend_header\n0 900 0 200 40000\n")});
  EXPECT_FALSE(state().message.is_fault) << message();
  wait_for_clouds();
  ASSERT_NE(viewer_->sea().clouds(), nullptr);
  EXPECT_EQ(viewer_->sea().clouds()->count(), 1u);

  undo(4);
  EXPECT_EQ(edited_text(), before);
  undo();
  EXPECT_EQ(message(), "there is nothing to undo");
  EXPECT_TRUE(viewer_->sea().meshes().empty());
  EXPECT_EQ(viewer_->sea().terrain(), nullptr);
}

// Fails if a file that cannot be read leaves a part of it in the scene or in the picture, takes an undo, or
// is not told of.
TEST_F(WindowFilesTest, ThatCannotBeReadChangeNothing) {
  open(quick_options());
  drop({tetrahedron("a.obj")});
  const std::string before = edited_text();
  turn();
  const std::vector<unsigned char> shown = picture();
  const std::vector<std::filesystem::path> files{file("no.obj", "nothing"),  file("no.tif", "nothing"),
                                                 file("no.vdb", "nothing"),  file("no.spec", "nothing"),
                                                 file("no.toml", "nothing"), file("no.mp3", "nothing"),
                                                 folder_.path() / "gone.obj"};
  for (const std::filesystem::path& each : files) {
    drop({each});
    wait_for_clouds();
    EXPECT_TRUE(state().message.is_fault) << each << message();
    EXPECT_THAT(message(), HasSubstr(each.filename().string()));
    EXPECT_EQ(edited_text(), before) << each;
    EXPECT_TRUE(picture() == shown) << each;
  }
  undo();
  EXPECT_TRUE(state().scene.meshes.empty()) << "the refused ones stand before it";
}

// Fails if files that come together do not all become edits, or the fault of one hides the others.
TEST_F(WindowFilesTest, ComeTogether) {
  open(quick_options());
  drop({tetrahedron("a.obj"), file("no.obj", "nothing"), tetrahedron("a.off.obj")});
  EXPECT_EQ(state().scene.meshes.size(), 2u) << message();
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_THAT(message(), HasSubstr("no.obj"));
  EXPECT_THAT(message(), HasSubstr("added the mesh a.off"));
}

// Fails if a scene that is opened shows another picture than a start with it, by one byte, or another window
// is made for it; if edits before are lost, or Ctrl Z does not bring them back.
TEST_F(WindowFilesTest, ScenesAreOpened) {
  const std::filesystem::path calm =
      file("calm 바다.toml",
           "version = 1\n[wind]\nspeed_mps = 4\n[ocean]\nsize = 64\n[camera]\nx_m = 30\ny_m = "
           "9\npitch_deg = -20\n[time]\nstart_s = 5\n");
  open(quick_options());
  const auto* window = viewer_->window();
  drop({tetrahedron("a.obj")});
  const std::string edited = edited_text();
  drop({calm});
  EXPECT_FALSE(state().message.is_fault) << message();
  EXPECT_THAT(message(), HasSubstr("opened calm 바다"));
  EXPECT_THAT(message(), HasSubstr("not saved"));
  EXPECT_EQ(viewer_->window(), window);
  EXPECT_EQ(viewer_->shown_title(), "Offing: calm 바다");
  EXPECT_EQ(state().clock.time_s(), 5.0);
  EXPECT_TRUE(state().clock.is_paused()) << "as it was";
  EXPECT_TRUE(viewer_->sea().meshes().empty());
  turn(2);
  const std::vector<unsigned char> live = picture();

  undo();
  EXPECT_EQ(edited_text(), edited);
  EXPECT_EQ(state().clock.time_s(), quick_options().time_s);
  EXPECT_EQ(viewer_->sea().meshes().size(), 1u);
  undo();
  EXPECT_TRUE(state().scene.meshes.empty()) << "edits of a scene that was left are undone one by one";

  present::ViewOptions fresh = quick_options();
  fresh.scene = scene::load_scene(calm);
  fresh.time_s = 5.0;
  open(fresh);
  turn(2);
  EXPECT_TRUE(picture() == live) << "a fresh start shows another picture";
}

// Fails if Ctrl Z at the first edit of a scene, which goes back to the scene before, loses what had been
// undone in either of them, or that scene itself; if yet another scene hides those that Ctrl Z had left.
TEST_F(WindowFilesTest, ScenesKeepWhatWasUndoneInThem) {
  open(quick_options());
  const std::string first = edited_text();
  drop({tetrahedron("a.obj")});
  const std::string first_edited = edited_text();
  drop({file("second.toml", "version = 1\n[ocean]\nsize = 32\n[wind]\nspeed_mps = 3\n")});
  const std::string second = edited_text();
  drop({tetrahedron("b.obj")});
  const std::string second_edited = edited_text();
  undo();
  EXPECT_EQ(edited_text(), second);
  undo();
  EXPECT_EQ(edited_text(), first_edited);
  EXPECT_THAT(message(), HasSubstr("Ctrl Shift Z goes forward to second"));
  undo();
  EXPECT_EQ(edited_text(), first);
  redo();
  EXPECT_EQ(edited_text(), first_edited);
  redo();
  EXPECT_EQ(edited_text(), second);
  EXPECT_THAT(message(), HasSubstr("forward to second"));
  redo();
  EXPECT_EQ(edited_text(), second_edited);
  EXPECT_EQ(viewer_->sea().meshes().size(), 1u);
  redo();
  EXPECT_EQ(message(), "there is nothing to redo");

  undo(2);
  ASSERT_EQ(edited_text(), first_edited);
  drop({file("third.toml", "version = 1\n[ocean]\nsize = 32\n")});
  undo();
  EXPECT_EQ(edited_text(), first_edited);
  undo(2);
  EXPECT_EQ(edited_text(), second);
}

// Fails if a click on the list of scenes opens none, another one, or leaves the mark where it was.
TEST_F(WindowFilesTest, ScenesAreOpenedFromTheList) {
  present::ViewOptions options = quick_options();
  options.scene_file = file("first.toml", "version = 1\n");
  options.scene_name = "first";
  file("second.toml", "version = 1\n[ocean]\nsize = 32\n[wind]\nspeed_mps = 3\n");
  open(options);
  toggle_header("Scenes");
  // The lists are at the panel's end.
  hands_->move_to(200, static_cast<int>(values()->Pos.y) + 40);
  turn();
  for (int i = 0; i < 40; ++i) {
    hands_->button(Hands::Button::wheel_down, Hands::Motion::down);
    hands_->button(Hands::Button::wheel_down, Hands::Motion::up);
  }
  turn(3);
  const auto choose_row = [&](const char* part, int number) {
    const unsigned id = values()->GetID(part);
    click(find(ImGui::FindWindowByName(fmt::format("Values/{}_{:08X}", part, id).c_str()), "##scene", 20,
               number));
    turn(3);
  };
  choose_row("beside", 1);
  EXPECT_THAT(message(), HasSubstr("opened second"));
  EXPECT_EQ(state().scene.wind.wind_speed_mps, 3.0);
  choose_row("beside", 0);
  EXPECT_THAT(message(), HasSubstr("opened first"));
  const present::SceneList list;
  const auto sky = std::ranges::find(list.shipped(), "sphere.toml", &present::ListedScene::name);
  choose_row("shipped", static_cast<int>(sky - list.shipped().begin()));
  EXPECT_THAT(message(), HasSubstr("opened sphere"));
  EXPECT_EQ(state().scene.meshes.size(), 1u);
}

// Fails if a scene whose files are missing takes the one before away.
TEST_F(WindowFilesTest, ScenesThatCannotBeMadeAreNotOpened) {
  open(quick_options());
  turn();
  const std::string before = edited_text();
  const std::vector<unsigned char> shown = picture();
  drop({file("broken.toml", "version = 1\n[[mesh]]\nfile = \"gone.obj\"\n")});
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_THAT(message(), HasSubstr("broken.toml:3"));
  EXPECT_EQ(edited_text(), before);
  EXPECT_TRUE(picture() == shown);
}

// Fails if a drop changes what is being recorded.
TEST_F(WindowFilesTest, LeaveRecordingsAlone) {
  present::ViewOptions options = quick_options();
  options.recording = {
      .name = FrameName("--record", "a_%d.png", "a_%d.png"), .frames = {0, 99}, .frames_per_second = 1.0};
  viewer_ = std::make_unique<present::Viewer>(options, cancel_);
  turn();
  drop({tetrahedron("a.obj")});
  EXPECT_THAT(message(), HasSubstr("a.obj: cannot be opened while the window records"));
  EXPECT_TRUE(state().scene.meshes.empty());
}

}  // namespace
}  // namespace offing::test

// Recording from the window.
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>
#include <fmt/format.h>
#include <gmock/gmock.h>
#include <imgui.h>
// Windows of the panels, which only ImGui knows.
#include <imgui_internal.h>

#include "host/io/png_image.h"
#include "present/output/headless.h"
#include "tests/present/no_threads.h"
#include "tests/present/output/stand_in_ffmpeg.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

class WindowRecordTest : public WindowTest {
 protected:
  static present::ViewOptions two_frames_a_second() {
    present::ViewOptions options = quick_options();
    options.scene.time.frames_per_second = 2.0;
    options.size = present::ImageSize{64, 36};
    return options;
  }
  static ImGuiWindow* dialog() {
    for (ImGuiWindow* window : ImGui::GetCurrentContext()->Windows) {
      if (window->WasActive && std::string(window->Name).ends_with("###record dialog")) return window;
    }
    return nullptr;
  }
  static bool asks_to_quit() {
    const ImGuiWindow* question = ImGui::FindWindowByName("###quit");
    return question != nullptr && question->Active;
  }
  void choose_format(const char* name) {
    click(find(dialog(), "format", 60));
    click(find(open_menu(), name, 20));
  }
  void record_for_hours() {
    press_with_control("r");
    turn(2);
    type("100000");
    press("Return");
    turn(2);
    ASSERT_TRUE(viewer_->is_recording());
  }
  void wait_for_end() {
    constexpr double longest_s = 60.0;
    const double end_s = glfwGetTime() + longest_s;
    while (viewer_->is_recording()) {
      ASSERT_LT(glfwGetTime(), end_s) << "the recording never ends";
      turn();
    }
    turn(2);
  }
  /// Files in the current folder, or in one there, but for what windows remember.
  static std::vector<std::string> files(const char* folder = ".") {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
      if (entry.is_regular_file()) names.push_back(entry.path().filename().string());
    return names;
  }
  static std::vector<std::uint8_t> bytes_of(const std::string& name) {
    std::ifstream file(name, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
  }
};

// Fails if a video of five seconds takes more than four steps, has another number of frames or another size,
// or one of its frames is not the picture that the command line makes.
TEST_F(WindowRecordTest, FiveSecondsInThreeSteps) {
  const StandInFfmpeg ffmpeg;
  open(two_frames_a_second());
  look_at_sea();
  const int steps_before = steps();
  press_with_control("r");
  ASSERT_TRUE(viewer_->is_recording());
  turn(2);
  type("5");
  press("Return");
  EXPECT_LE(steps() - steps_before, 3);
  wait_for_end();
  EXPECT_THAT(message(), HasSubstr("offing_001.mp4"));
  EXPECT_FALSE(state().message.is_fault) << message();
  EXPECT_THAT(ffmpeg.arguments(), HasSubstr("-video_size\n64x36\n-framerate\n2\n"));
  const std::vector<std::uint8_t> video = bytes_of("offing_001.mp4");
  ASSERT_EQ(video.size(), 10u * 64u * 36u * 3u);
  EXPECT_THAT(files(), testing::ElementsAre("offing_001.mp4"));

  present::ViewOptions options = two_frames_a_second();
  options.scene = state().scene;
  viewer_.reset();
  options.opens_window = false;
  options.recording = {
      .name = FrameName("--record", "a_%d.png", "a_%d.png"), .frames = {0, 9}, .frames_per_second = 2.0};
  present::make_images(options, cancel_);
  std::vector<std::uint8_t> pictures;
  for (int frame = 0; frame < 10; ++frame) {
    const RgbImage image = read_png("a_" + std::to_string(frame) + ".png");
    pictures.insert(pictures.end(), image.rgb.begin(), image.rgb.end());
  }
  EXPECT_TRUE(video == pictures);
}

// Fails if a recording cannot begin at the time that is shown, or a size that the device does not draw is
// taken.
TEST_F(WindowRecordTest, FromTheTimeThatIsShown) {
  open(two_frames_a_second());
  for (int i = 0; i < 3; ++i) press("period");
  const auto first = static_cast<int>(std::lround(2.0 * state().clock.time_s()));
  ASSERT_GT(first, 0);
  press_with_control("r");
  turn(2);
  click(find(dialog(), "now", 392));
  click(find_triple(dialog(), "width, height"));
  press_with_control("a");
  type("999999");
  press("Return");
  turn(2);
  ASSERT_TRUE(viewer_->is_recording()) << "the dialog is open";
  EXPECT_TRUE(files().empty());
  press("Escape");
  turn(2);
  EXPECT_FALSE(viewer_->is_recording());
  press_with_control("r");
  turn(2);
  click(find(dialog(), "now", 392));
  choose_format("pictures (.png)");
  click(find(dialog(), "record", 20));
  wait_for_end();
  const auto name = [](int frame) { return fmt::format("offing_001_{:04}.png", frame); };
  EXPECT_THAT(files(), testing::IsEmpty());
  EXPECT_THAT(files("offing_001"), testing::Contains(name(first))) << message();
  EXPECT_THAT(files("offing_001"), testing::Not(testing::Contains(name(first - 1))));
}

// Fails if a format, a size or a range that the mouse chooses is not the one of the files, or files of an
// earlier recording are replaced.
TEST_F(WindowRecordTest, PicturesOfAnyRange) {
  open(two_frames_a_second());
  click(find(timeline(), "record ...", 40));
  turn(2);
  ASSERT_NE(dialog(), nullptr);
  click(find(dialog(), "start, s", 60));
  press_with_control("a");
  type("3");
  choose_format("scene-linear pictures (.exr)");
  click(find(dialog(), "record", 20));
  wait_for_end();
  EXPECT_THAT(files("offing_001"),
              testing::UnorderedElementsAre("offing_001_0006.exr", "offing_001_0007.exr",
                                            "offing_001_0008.exr", "offing_001_0009.exr"));
  press_with_control("r");
  turn(2);
  press("Return");
  wait_for_end();
  EXPECT_THAT(files("offing_002"), testing::Contains("offing_002_0000.exr")) << message();
  EXPECT_EQ(files("offing_002").size(), 4u);
  EXPECT_THAT(files(), testing::IsEmpty());
}

// Fails if pictures cannot be written beside other files or elsewhere, the folder of a recording that was
// cancelled at once stays, or pictures that are there are replaced.
TEST_F(WindowRecordTest, TheUserChoosesTheFolder) {
  std::filesystem::create_directory("films");
  open(two_frames_a_second());
  press_with_control("r");
  turn(2);
  type("1");
  choose_format("pictures (.png)");
  click(find(dialog(), "folder ...", 30));
  turn(4);
  type("films");
  press("Return");
  turn(4);
  press("Return");
  turn(4);
  ASSERT_NE(dialog(), nullptr) << "only the list of folders closes";
  click(find(dialog(), "in a folder of this name", 20));
  click(find(dialog(), "record", 20));
  wait_for_end();
  EXPECT_THAT(files("films"), testing::UnorderedElementsAre("offing_001_0000.png", "offing_001_0001.png"))
      << message();
  press_with_control("r");
  turn(2);
  click(find(dialog(), "name", 60));
  press_with_control("a");
  type("films/offing_001");
  press("Return");
  turn(2);
  EXPECT_FALSE(viewer_->is_recording() && dialog() == nullptr) << "the files are there";
  EXPECT_EQ(files("films").size(), 2u);
  click(find(dialog(), "name", 60));
  press_with_control("a");
  type("nowhere/offing_001");
  press("Return");
  turn(2);
  EXPECT_NE(dialog(), nullptr);
  press("Escape");
  turn(2);
}

// Fails if a recording of ground is seen from elsewhere than the window's picture: without a camera in its
// file the scene has one that the ground places.
TEST_F(WindowRecordTest, IsSeenFromWhereTheUserIs) {
  present::ViewOptions options = two_frames_a_second();
  options.scene.terrain.is_given = true;
  open(options);
  hands_->key("d", Hands::Motion::down);
  turn(10);
  hands_->key("d", Hands::Motion::up);
  turn();
  const glm::dvec3 eye_m = state().camera.camera().eye_m;
  press_with_control("r");
  turn(2);
  type("0.5");
  choose_format("pictures (.png)");
  click(find(dialog(), "record", 20));
  wait_for_end();
  const RgbImage recorded = read_png("offing_001/offing_001_0000.png");
  present::ViewOptions placed = two_frames_a_second();
  placed.scene = state().scene;
  placed.scene.set_at = {{"camera.x_m", "the test"}};
  EXPECT_EQ(placed.scene.view.camera.eye_m, eye_m);
  viewer_.reset();
  placed.opens_window = false;
  placed.recording = {
      .name = FrameName("--record", "a_%d.png", "a_%d.png"), .frames = {0, 0}, .frames_per_second = 2.0};
  present::make_images(placed, cancel_);
  EXPECT_TRUE(recorded.rgb == read_png("a_0.png").rgb);
}

// Fails if a recording holds up the window, quitting ends it without a question, or a cancelled one leaves a
// part of a video.
TEST_F(WindowRecordTest, RunsInTheBackgroundAndIsCancelled) {
  const StandInFfmpeg ffmpeg;
  open(two_frames_a_second());
  record_for_hours();
  press("h");
  EXPECT_TRUE(state().shows_help);
  press("h");
  press("Escape");
  press_with_control("q");
  EXPECT_TRUE(asks_to_quit());
  press("Escape");
  EXPECT_FALSE(asks_to_quit());
  EXPECT_TRUE(viewer_->is_recording());
  press_with_control("r");
  EXPECT_THAT(message(), HasSubstr("a recording is running"));
  click(find(timeline(), "cancel##recording", 440));
  wait_for_end();
  EXPECT_EQ(message(), "cancelled: wrote no video");
  EXPECT_THAT(files(), testing::IsEmpty());
  EXPECT_TRUE(viewer_->turn());
}

// Fails if quitting does not end a recording, leaves a part of its video, or forgets to ask after edits.
TEST_F(WindowRecordTest, QuittingEndsIt) {
  const StandInFfmpeg ffmpeg;
  for (const bool has_edits : {false, true}) {
    open(two_frames_a_second());
    if (has_edits) press_with_control("1");
    record_for_hours();
    press_with_control("q");
    ASSERT_TRUE(asks_to_quit());
    find(ImGui::FindWindowByName("###quit"), has_edits ? "discard" : "quit", has_edits ? 70 : 15);
    hands_->button(Hands::Button::left, Hands::Motion::down);
    turn();
    hands_->button(Hands::Button::left, Hands::Motion::up);
    EXPECT_FALSE(viewer_->turn() && viewer_->turn());
    viewer_.reset();
    EXPECT_THAT(files(), testing::IsEmpty());
  }
}

// Fails if the empty folder of pictures stays where the window closes before the first one.
TEST_F(WindowRecordTest, QuittingLeavesNoEmptyFolder) {
  open(two_frames_a_second());
  press_with_control("r");
  turn(2);
  choose_format("pictures (.png)");
  click(find(dialog(), "record", 20));
  ASSERT_TRUE(viewer_->is_recording());
  const bool was_there = std::filesystem::exists("offing_001");
  viewer_.reset();
  EXPECT_TRUE(was_there);
  EXPECT_TRUE(!std::filesystem::exists("offing_001") || !files("offing_001").empty());
}

// Fails if a recording for which there is no thread ends the window, or leaves a folder.
TEST_F(WindowRecordTest, NeedsAThread) {
  open(two_frames_a_second());
  press_with_control("r");
  turn(2);
  choose_format("pictures (.png)");
  {
    const NoThreads none;
    click(find(dialog(), "record", 20));
    EXPECT_FALSE(std::filesystem::exists("offing_001"));
  }
  ASSERT_NE(dialog(), nullptr) << "it does not say what is wrong";
  click(find(dialog(), "record", 20));
  wait_for_end();
  EXPECT_FALSE(files("offing_001").empty()) << message();
}

// Fails if a recording that ends early, here as its folder is gone, ends the window or does not say so.
TEST_F(WindowRecordTest, SaysThatItsThreadFailed) {
  open(two_frames_a_second());
  press_with_control("r");
  turn(2);
  choose_format("pictures (.png)");
  click(find(dialog(), "record", 20));
  ASSERT_TRUE(viewer_->is_recording());
  std::filesystem::remove_all("offing_001");
  wait_for_end();
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_THAT(message(), HasSubstr("offing_001"));
  EXPECT_TRUE(viewer_->turn());
}

// Fails if a machine without ffmpeg closes the dialog or begins to record, or Esc does not close the dialog.
TEST_F(WindowRecordTest, NeedsFfmpegForVideos) {
  const StandInFfmpeg ffmpeg;
  ffmpeg.take_away();
  open(two_frames_a_second());
  press_with_control("r");
  turn(2);
  const float height_px = dialog()->Size.y;
  choose_format("video (.mp4)");  // not what the dialog proposes
  turn(2);
  EXPECT_GT(dialog()->Size.y, height_px) << "the dialog does not say at once that there is no ffmpeg";
  press("Return");
  turn(2);
  EXPECT_NE(dialog(), nullptr);
  EXPECT_THAT(files(), testing::IsEmpty());
  press("Escape");
  turn(2);
  EXPECT_EQ(dialog(), nullptr);
  EXPECT_FALSE(viewer_->is_recording());
}

// Fails if an ffmpeg that gives up, as where the disk is full, leaves a part of a video, says more than one
// fault, or ends the window.
TEST_F(WindowRecordTest, FaultsAreToldOnce) {
  const StandInFfmpeg ffmpeg("head -c 1000 > \"${last#file:}\"; echo 'No space left on device' >&2; exit 1");
  open(two_frames_a_second());
  press_with_control("r");
  turn(2);
  press("Return");
  wait_for_end();
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_THAT(message(), HasSubstr("ffmpeg failed: No space left on device\ncheck that"));
  EXPECT_THAT(files(), testing::IsEmpty());
  EXPECT_TRUE(viewer_->turn());
}

}  // namespace
}  // namespace offing::test

// What panels hold besides the parameters of the scene: views, scene file, times.
#include <filesystem>
#include <fstream>

#define GLFW_INCLUDE_NONE
#include <GLFW/glfw3.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/schema/parameter_table.h"
#include "present/panels/parameter_widget.h"
#include "tests/present/output/stand_in_ffmpeg.h"
#include "tests/present/window/window_test.h"

namespace offing::test {
namespace {

using WindowPanelsTest = WindowTest;

// Fails if a view shows what another one shows, cannot be chosen, or the way back is lost.
TEST_F(WindowPanelsTest, Views) {
  present::ViewOptions options = quick_options();
  options.scene.ocean.patch_lengths_m = {730.0, 170.0, 31.0, 5.3};
  open(options);
  toggle_header("View");
  choose("show", "jacobian");
  EXPECT_EQ(state().debug, present::WaterShow::jacobian);
  choose("show", "none");
  EXPECT_EQ(state().debug, present::WaterShow::none);
  look_at_sea();
  std::vector<std::vector<unsigned char>> pictures;
  for (const present::WaterShow view : present::all_water_shows) {
    ASSERT_EQ(state().debug, view);
    turn();
    for (const auto& other : pictures) EXPECT_FALSE(picture() == other) << to_string(view);
    pictures.push_back(picture());
    press("v");
  }
  turn();
  EXPECT_TRUE(picture() == pictures.front());
  click(find(values(), "wireframe", 16));
  turn();
  EXPECT_EQ(state().fill, present::Fill::wireframe);
  EXPECT_FALSE(picture() == pictures.front());
}

// Fails if a smaller picture is not drawn, or frames come faster than the limit.
TEST_F(WindowPanelsTest, ImageAndPace) {
  present::ViewOptions options = quick_options();
  options.render_scale = 1.0;
  open(options);
  toggle_header("View");
  picture();  // a sharp one, whose size is exact
  const int usual = width();
  const Spot scale = find(values(), "render scale", 100);
  drag(scale, {scale.x - 50, scale.y});
  picture();
  EXPECT_LT(width(), usual);
  EXPECT_NEAR(width(), static_cast<double>(state().render_scale) * usual, 1.0);
  const Spot limit = find(values(), "most frames/s", 100);
  drag(limit, {limit.x - 75, limit.y});
  const auto limit_hz = static_cast<double>(state().frame_limit_hz);
  ASSERT_GT(limit_hz, 0.0);
  ASSERT_LT(limit_hz, 30.0);
  const double start_s = glfwGetTime();
  constexpr int frames = 5;
  turn(frames);
  EXPECT_GE(glfwGetTime() - start_s, (frames - 1) / limit_hz);
}

// Fails if the saved scene shows another sea than the window does, a file is lost, or edits cannot be undone.
TEST_F(WindowPanelsTest, SceneFile) {
  open(quick_options());
  toggle_header("Wind");
  const scene::Parameter& speed = *scene::find_parameter("wind.speed_mps");
  const Spot slider = find(values(), present::parameter_label(speed), 70);
  drag(slider, {slider.x + 30, slider.y});
  const double edited_mps = state().scene.wind.wind_speed_mps;
  EXPECT_NE(edited_mps, quick_options().scene.wind.wind_speed_mps);
  toggle_header("Wind");
  save_as("mine.toml");
  EXPECT_NE(message().find("mine.toml"), std::string::npos) << message();
  EXPECT_FALSE(state().message.is_fault) << message();
  look_at_sea();
  click(find(main_panel(), "save", 145));
  EXPECT_FALSE(state().message.is_fault) << message();
  turn(2);
  const std::vector<unsigned char> live = picture();

  click(find(values(), "undo all edits", 160));
  EXPECT_EQ(state().scene.wind.wind_speed_mps, quick_options().scene.wind.wind_speed_mps);
  EXPECT_EQ(state().camera.camera().pitch_rad, quick_options().scene.view.camera.pitch_rad);

  present::ViewOptions again = quick_options();
  again.scene = scene::load_scene("mine.toml");
  open(again);
  turn(2);
  EXPECT_EQ(state().scene.wind.wind_speed_mps, edited_mps);
  EXPECT_TRUE(picture() == live);
}

// Fails if a button does something where its key has nothing to do, or nothing where it has.
TEST_F(WindowPanelsTest, ButtonsWithoutAnEditAreGrey) {
  present::ViewOptions options = quick_options();
  scene::save_scene(options.scene, "calm.toml", Existing::keep);
  options.scene_file = "calm.toml";
  options.scene_name = "calm";
  open(options);
  const std::string before = edited_text();
  const auto click_all = [&] {
    for (const char* label : {"undo", "redo", "save"}) click(find(main_panel(), label, 290));
  };
  click_all();
  EXPECT_EQ(message(), "");
  toggle_header("Spectrum");
  click(find(values(), "7##beaufort-7", 242));
  const std::string edited = edited_text();
  ASSERT_NE(edited, before);
  click(find(main_panel(), "undo", 290));
  EXPECT_EQ(edited_text(), before);
  EXPECT_EQ(message(), "undone: Spectrum: wind speed, wave height");
  click(find(main_panel(), "redo", 340));
  EXPECT_EQ(edited_text(), edited);
  EXPECT_EQ(message(), "redone: Spectrum: wind speed, wave height");
  click(find(main_panel(), "save", 145));
  EXPECT_NE(message().find("wrote"), std::string::npos) << message();
  EXPECT_EQ(message().find("camera"), std::string::npos) << message();
  look_at_sea();
  click(find(main_panel(), "save", 145));
  EXPECT_NE(message().find("its camera is where you are now"), std::string::npos) << message();
  press("Escape");
  const std::string other = message();
  click(find(main_panel(), "save", 145));
  EXPECT_EQ(message(), other) << "all is saved";
}

// Fails if a name that no file can have ends the window.
TEST_F(WindowPanelsTest, NamesThatNoFileCanHave) {
  present::ViewOptions options = quick_options();
  options.scene_name = std::string(300, 'x');
  open(options);
  press_with_control("s");
  turn(2);
  press("Return");
  EXPECT_TRUE(viewer_->turn());
  press("Escape");
  turn(2);
  EXPECT_EQ(viewer_->shown_title(), "Offing: " + options.scene_name) << "it is not saved";
  press("F12");
  EXPECT_NE(message().find("xxx_001.png"), std::string::npos) << message();
  EXPECT_TRUE(state().message.is_fault);
}

// Fails if a recording goes on with old pictures where the scene has none: its sun leaves the calendar after
// the third frame.
TEST_F(WindowPanelsTest, RecordingsEndWithTheirScene) {
  present::ViewOptions options = quick_options();
  options.starts_paused = false;
  options.time_s = 0.0;
  options.scene.view.sun_time_utc = UtcTime{2100, 12, 31, 23, 59, 57};
  options.scene.view.sun_time_scale = 1.0;
  options.recording = {
      .name = FrameName("--record", "a_%d.png", "a_%d.png"), .frames = {0, 9}, .frames_per_second = 1.0};
  EXPECT_THROW(present::show_window(options, CancelToken()), Error);
  EXPECT_TRUE(std::filesystem::exists("a_0.png"));
  EXPECT_TRUE(std::filesystem::exists("a_1.png"));
  EXPECT_FALSE(std::filesystem::exists("a_4.png"));
}

// Fails if a window of odd sides, which --size asks for or a display makes of other ones, cannot be recorded
// as the video that takes even ones alone.
TEST_F(WindowPanelsTest, RecordingsFitTheirVideo) {
  const StandInFfmpeg ffmpeg;
  present::ViewOptions options = quick_options();
  options.render_scale = 1.0;
  options.size = present::ImageSize{161, 91};
  options.starts_paused = false;
  options.recording = {.video = "a.mp4", .frames = {0, 1}, .frames_per_second = 10.0};
  present::show_window(options, CancelToken());
  EXPECT_NE(ffmpeg.arguments().find("-video_size\n160x90\n"), std::string::npos) << ffmpeg.arguments();
  EXPECT_EQ(std::filesystem::file_size("a.mp4"), 2u * 160u * 90u * 3u);
}

// Fails if a stage is not timed, by the CPU's clock or the device's.
TEST_F(WindowPanelsTest, Times) {
  open(quick_options());
  toggle_header("Frame times");
  click(find(values(), "device's clock", 135));
  EXPECT_EQ(state().shown_times, present::TimeSource::device);
  click(find(values(), "CPU's clock", 20));
  EXPECT_EQ(state().shown_times, present::TimeSource::cpu);
  look_at_sea();
  press("space");
  turn(5);
  const present::StageTimes& times = viewer_->sea().frame().times();
  for (std::size_t i = 0; i < present::stage_count; ++i) {
    const auto stage = static_cast<present::Stage>(i);
    // The scene has neither ground, meshes nor clouds.
    if (stage == present::Stage::terrain || stage == present::Stage::meshes ||
        stage == present::Stage::clouds)
      continue;
    for (const present::TimeSource source : {present::TimeSource::cpu, present::TimeSource::device}) {
      EXPECT_GT(times.mean_ms(stage, source), 0.0) << to_string(stage);
    }
  }
  EXPECT_GT(times.frames_per_second(), 0.0);
}

}  // namespace
}  // namespace offing::test

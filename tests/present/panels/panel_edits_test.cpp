// Every slider and field of the parameter table in the window, with a mouse and a keyboard: what is shown
// live is what a fresh start with the edited scene shows.
#include "tests/present/panels/panel_edits.h"

#include <algorithm>

#include "host/scene/file/scene_file.h"
#include "present/panels/parameter_widget.h"

namespace offing::test {
namespace {

using present::parameter_label;
using scene::Parameter;

class PanelEditsTest : public PanelEdits, public testing::WithParamInterface<present::GroupPanel> {};

// Fails as PanelEdits::expect_what_a_fresh_start_shows() says.
TEST_P(PanelEditsTest, ShowWhatAFreshStartShows) {
  expect_what_a_fresh_start_shows({GetParam()});
}

/// All but that of height maps, whose values are as a file has them: window_terrain_test.cpp; those of what a
/// world has beside its sea: world_panels_test.cpp, cloud_panels_test.cpp; and those of bookmarks:
/// window_bookmarks_test.cpp. Places of lakes are only in basins: scene_objects_test.cpp.
std::vector<present::GroupPanel> panels_of_free_values() {
  std::vector<present::GroupPanel> panels(present::group_panels().begin(), present::group_panels().end());
  std::erase_if(panels, [](const auto& panel) {
    return panel.group == scene::ParameterGroup::height_map || is_of_world(panel.group) ||
           panel.group == scene::ParameterGroup::bookmark || panel.group == scene::ParameterGroup::lake ||
           is_of_clouds(panel.group);
  });
  return panels;
}

INSTANTIATE_TEST_SUITE_P(Panels, PanelEditsTest, testing::ValuesIn(panels_of_free_values()), panel_name);

// Fails if a row of the table belongs to no panel.
TEST(GroupPanelsTest, HoldEveryRow) {
  const auto panels = present::group_panels();
  for (const Parameter& row : scene::parameter_table()) {
    const auto count = std::count_if(panels.begin(), panels.end(),
                                     [&](const auto& panel) { return panel.group == row.group; });
    EXPECT_EQ(count, 1) << row.key;
  }
}

class RefusedEditsTest : public WindowTest {
 protected:
  /// The sea, seen by a camera that then looks at the sky again, where frames are quick to draw.
  std::vector<unsigned char> sea() {
    look_at_sea();
    turn(2);
    const std::vector<unsigned char> pixels = picture();
    press("0");
    return pixels;
  }
};

using PanelFieldsTest = WindowTest;

// Fails if a number that the table refuses is taken or ignored: its message is shown, the sea stays.
TEST_F(RefusedEditsTest, NumbersOutOfRange) {
  open(quick_options());
  const std::vector<unsigned char> before = sea();
  toggle_header("Wind");
  enter_into_slider(find(values(), parameter_label(*scene::find_parameter("wind.speed_mps")), 70), "999");
  EXPECT_NE(message().find("wind.speed_mps: expected a number in m/s within [0.1, 60], got 999"),
            std::string::npos)
      << message();
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_EQ(state().scene.wind.wind_speed_mps, quick_options().scene.wind.wind_speed_mps);
  EXPECT_TRUE(sea() == before);
}

// Fails if a number that the world refuses while its slider is held is no more told of once it is let go.
TEST_F(RefusedEditsTest, NumbersThatTheRestOfTheSceneForbids) {
  open(panel_options({{scene::ParameterGroup::wake, "Wakes"}}, quick_options()));
  const std::string before = edited_text();
  toggle_header("Wakes");
  const Parameter& rain = *scene::find_parameter("ocean.wake.rain_per_m2s");
  const Spot slider = find(values(), parameter_label(rain), 70, 0);
  drag(slider, {slider.x + 35, slider.y});
  EXPECT_NE(message().find("wake.rain.drops_per_m2s"), std::string::npos) << message();
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_EQ(edited_text(), before);
}

// Fails if a spectrum file that is not there ends the window, or takes the sea away.
TEST_F(RefusedEditsTest, SpectrumFilesThatAreNotThere) {
  open(quick_options());
  const std::vector<unsigned char> before = sea();
  toggle_header("Spectrum");
  enter(find(values(), parameter_label(*scene::find_parameter("ocean.spectrum_file"))), "nowhere.data_spec");
  turn(2);
  EXPECT_NE(message().find("nowhere.data_spec"), std::string::npos) << message();
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_EQ(state().scene.ocean.spectrum_file, "");
  EXPECT_TRUE(sea() == before);
}

// Fails if an edit that is refused gives the camera's keyframes back to a scene whose camera is the user's.
TEST_F(RefusedEditsTest, LeaveTheCameraToTheUser) {
  present::ViewOptions options = quick_options();
  options.scene.tracks = scene::parse_scene(
                             "version = 1\n[camera]\nx_m = { keys = [{ t = 0, value = 0 }, { t = 100, "
                             "value = 1000 }] }\n",
                             "path.toml", "")
                             .tracks;
  open(options);
  look_at_sea();
  ASSERT_TRUE(state().scene.tracks.empty());
  toggle_header("Spectrum");
  enter(find(values(), parameter_label(*scene::find_parameter("ocean.spectrum_file"))), "nowhere.data_spec");
  turn(2);
  ASSERT_TRUE(state().message.is_fault);
  EXPECT_TRUE(state().scene.tracks.empty());
}

// Fails if a number beyond the ends of its slider, but within its range, cannot be typed.
TEST_F(PanelFieldsTest, NumbersBeyondTheSlider) {
  open(panel_options({{scene::ParameterGroup::wake, "Wakes"}}, quick_options()));
  toggle_header("Wakes");
  const Parameter& step = *scene::find_parameter("ocean.wake.step_s");
  ASSERT_TRUE(step.slider);
  ASSERT_GT(step.slider->low, 0.005);
  enter_into_slider(find(values(), parameter_label(step), 70, 0), "0.005");
  EXPECT_EQ(state().scene.ocean.wakes.front().parameters.step_s, 0.005);
  EXPECT_FALSE(state().message.is_fault) << message();
}

// Fails if Enter in a field that nobody changed takes what it shows for the value: twelve digits.
TEST_F(PanelFieldsTest, EnterWithoutAChange) {
  present::ViewOptions options = quick_options();
  options.scene.ocean.patch_lengths_m = {1000.0 / 3.0};
  open(options);
  toggle_header("Cascades and Gerstner waves");
  click(find(values(), parameter_label(*scene::find_parameter("ocean.cascade.patch_m"))));
  press("Return");
  turn(2);
  EXPECT_EQ(state().scene.ocean.patch_lengths_m, options.scene.ocean.patch_lengths_m);
}

}  // namespace
}  // namespace offing::test

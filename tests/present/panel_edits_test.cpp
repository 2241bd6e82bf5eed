// Every slider and field of the parameter table in the window, with a mouse and a keyboard: what is shown
// live is what a fresh start with the edited scene shows.
#include <algorithm>
#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "host/scene/parameter_table.h"
#include "host/scene/scene_elements.h"
#include "host/scene/scene_file.h"
#include "present/parameter_widget.h"
#include "tests/present/window_test.h"

namespace offing::test {
namespace {

using present::parameter_label;
using scene::OceanScene;
using scene::Parameter;

class PanelEditsTest : public WindowTest, public testing::WithParamInterface<present::GroupPanel> {
 protected:
  std::string value_of(const Parameter& row) const {
    return scene::value_text(state().scene, row, scene::Digits::exact);
  }

  void edit(const Parameter& row) {
    if (row.elements) add_elements(row);
    const std::string before = value_of(row);
    std::visit([&](auto storage) { change(row, storage); }, row.storage);
    EXPECT_NE(value_of(row), before) << row.key << ": " << message();
    EXPECT_FALSE(state().message.is_fault) << row.key << ": " << message();
  }

  /// Two: the second one is edited.
  void add_elements(const Parameter& row) {
    const auto count = [&] { return scene::elements_of(state().scene, row.elements).size(); };
    while (count() < 2) {
      const std::size_t before = count();
      click(find(main_panel(), fmt::format("add##{}", GetParam().title), 20));
      ASSERT_EQ(count(), before + 1);
    }
  }

  static std::optional<int> shown_element(const Parameter& row) {
    return row.elements ? std::optional(1) : std::nullopt;
  }

  /// By its slider or field: to the right.
  void pull(const Parameter& row, int x_px) {
    const Spot spot = find(main_panel(), parameter_label(row), x_px, shown_element(row));
    drag(spot, {spot.x + 35, spot.y});
  }

  void change(const Parameter& row, scene::ValueAt<double>) { pull(row, 70); }
  void change(const Parameter& row, scene::ValueAt<std::optional<double>>) {
    click(find(main_panel(), "##set " + std::string(row.key), 16, shown_element(row)));
    pull(row, 97);
  }
  void change(const Parameter& row, scene::ValueAt<int> at) {
    if (row.rule == scene::ParameterRule::power_of_two) {
      choose(parameter_label(row), "64");
      return;
    }
    OceanScene copy = state().scene;
    // From the upper end of its range only to the left.
    const Spot spot = find(main_panel(), parameter_label(row), 70);
    const int way = at(copy, {}) >= row.high ? -25 : 25;
    drag(spot, {spot.x + way, spot.y});
  }
  void change(const Parameter& row, scene::ValueAt<std::uint64_t>) {
    enter(find(main_panel(), parameter_label(row)), "12345");
  }
  /// Ground beside the sea, if it is the ground's panel.
  static present::ViewOptions options_of(scene::ParameterGroup group) {
    present::ViewOptions options = quick_options();
    if (group == scene::ParameterGroup::terrain || group == scene::ParameterGroup::walk) {
      options.scene.terrain.is_given = options.scene.names_sea = true;
      options.scene.terrain.fractal.posts = 33;
      // A scene that says where its eye is: nothing else places it.
      options.scene.view.camera.eye_m.y = 2500.0;
      options.scene.set_at.emplace("camera.y_m", "the test");
    }
    return options;
  }
  void change(const Parameter& row, scene::ValueAt<std::string>) {
    const char* const file = row.group == scene::ParameterGroup::terrain
                                 ? OFFING_SOURCES "/docs/gallery/calm.jpg"
                                 : OFFING_SOURCES "/scenes/example_sea.data_spec";
    enter(find(main_panel(), parameter_label(row)), file);
  }
  void change(const Parameter& row, scene::ValueAt<std::optional<UtcTime>>) {
    enter(find(main_panel(), parameter_label(row)), "2020-06-08T15:50Z");
  }
  void change(const Parameter&, scene::ValueAt<glm::dvec3>) { FAIL() << "of meshes only"; }
  void change(const Parameter&, scene::ValueAt<std::optional<glm::dvec3>>) { FAIL() << "of meshes only"; }
  void change(const Parameter& row, scene::ValueAt<std::vector<double>>) {
    enter(find(main_panel(), parameter_label(row)), "250, 41");
  }
  void change(const Parameter& row, const scene::ChoiceStorage& choice) {
    OceanScene copy = state().scene;
    const std::size_t other = (choice.get(copy, {}) + 1) % choice.names.size();
    choose(parameter_label(row), std::string(choice.names[other]));
  }
};

// Fails if a row has no widget, the mouse does not reach it, or it does not change its value; if an edit
// shows another sea, sun or eye than a window that is opened with the edited scene, by one byte.
TEST_P(PanelEditsTest, ShowWhatAFreshStartShows) {
  open(options_of(GetParam().group));
  toggle_header(GetParam().title);
  int rows = 0;
  for (const Parameter& row : scene::parameter_table()) {
    if (row.group != GetParam().group) continue;
    edit(row);
    if (HasFatalFailure()) return;
    ++rows;
  }
  EXPECT_GT(rows, 0);
  look_at_sea();
  turn(2);
  const std::vector<unsigned char> live = picture();

  present::ViewOptions fresh = quick_options();
  fresh.scene = state().scene;
  fresh.time_s = state().clock.time_s();
  open(fresh);
  turn(2);
  EXPECT_TRUE(picture() == live) << "the window shows another picture than a fresh start";
}

bool is_of_meshes(const present::GroupPanel& panel) {
  return panel.group == scene::ParameterGroup::mesh || panel.group == scene::ParameterGroup::highlight ||
         panel.group == scene::ParameterGroup::light;
}

bool is_of_clouds(const present::GroupPanel& panel) {
  return panel.group >= scene::ParameterGroup::clouds;
}

/// All but that of height maps, whose values are as a file has them: window_ground_test.cpp; those of meshes,
/// whose highlights go by degrees: panels_test.cpp; and those of clouds, which take a second an edit: what an
/// edit of theirs makes is in clouds_view_test.cpp.
std::vector<present::GroupPanel> panels_of_free_values() {
  std::vector<present::GroupPanel> panels(present::group_panels().begin(), present::group_panels().end());
  std::erase_if(panels, [](const auto& panel) {
    return panel.group == scene::ParameterGroup::height_map || is_of_meshes(panel) || is_of_clouds(panel);
  });
  return panels;
}

INSTANTIATE_TEST_SUITE_P(Panels, PanelEditsTest, testing::ValuesIn(panels_of_free_values()),
                         [](const auto& panel) {
                           std::string name = panel.param.title;
                           std::erase(name, ' ');
                           return name;
                         });

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
    press("Home");
    return pixels;
  }
};

using PanelFieldsTest = WindowTest;

// Fails if a number that the table refuses is taken or ignored: its message is shown, the sea stays.
TEST_F(RefusedEditsTest, NumbersOutOfRange) {
  open(quick_options());
  const std::vector<unsigned char> before = sea();
  toggle_header("Wind");
  const Spot slider = find(main_panel(), parameter_label(*scene::find_parameter("wind.speed_mps")), 70);
  hands_->key("Control_L", Hands::Motion::down);
  turn();
  click(slider);
  hands_->key("Control_L", Hands::Motion::up);
  turn();
  for (const char* digit : {"9", "9", "9"}) press(digit);
  press("Return");
  turn(2);
  EXPECT_NE(message().find("wind.speed_mps: expected a number in m/s within [0.1, 60], got 999"),
            std::string::npos)
      << message();
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_EQ(state().scene.wind_speed_mps, quick_options().scene.wind_speed_mps);
  EXPECT_TRUE(sea() == before);
}

// Fails if a spectrum file that is not there ends the window, or takes the sea away.
TEST_F(RefusedEditsTest, SpectrumFilesThatAreNotThere) {
  open(quick_options());
  const std::vector<unsigned char> before = sea();
  toggle_header("Spectrum");
  enter(find(main_panel(), parameter_label(*scene::find_parameter("ocean.spectrum_file"))),
        "nowhere.data_spec");
  turn(2);
  EXPECT_NE(message().find("nowhere.data_spec"), std::string::npos) << message();
  EXPECT_TRUE(state().message.is_fault);
  EXPECT_EQ(state().scene.spectrum_file, "");
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
  enter(find(main_panel(), parameter_label(*scene::find_parameter("ocean.spectrum_file"))),
        "nowhere.data_spec");
  turn(2);
  ASSERT_TRUE(state().message.is_fault);
  EXPECT_TRUE(state().scene.tracks.empty());
}

// Fails if Enter in a field that nobody changed takes what it shows for the value: twelve digits.
TEST_F(PanelFieldsTest, EnterWithoutAChange) {
  present::ViewOptions options = quick_options();
  options.scene.patch_lengths_m = {1000.0 / 3.0};
  open(options);
  toggle_header("Cascades and Gerstner waves");
  click(find(main_panel(), parameter_label(*scene::find_parameter("ocean.cascade.patch_m"))));
  press("Return");
  turn(2);
  EXPECT_EQ(state().scene.patch_lengths_m, options.scene.patch_lengths_m);
}

}  // namespace
}  // namespace offing::test

#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include <fmt/format.h>

#include "host/io/png_image.h"
#include "host/scene/parameter_table.h"
#include "host/scene/scene_elements.h"
#include "host/scene/scene_file.h"
#include "host/scene/scene_writer.h"
#include "present/parameter_widget.h"
#include "tests/present/window_test.h"

namespace offing::test {

/// Two of each, small enough to be made in a moment.
inline constexpr const char* small_layers = R"(version = 1
[clouds]
quality = 0.05
[camera]
y_m = 8000
pitch_deg = 10
[[cloud_layer]]
genus = "cirrus"
coverage = 0.02
extent_m = 300
[[cloud_layer]]
genus = "cirrus"
coverage = 0.02
extent_m = 300
)";
inline constexpr const char* small_clouds = R"(version = 1
[camera]
y_m = 600
z_m = 2500
pitch_deg = 10
[[cloud]]
y_m = 1000
[[cloud.ball]]
radius_m = 150
[[cloud.level]]
[[cloud.particle_edit]]
[[cloud]]
y_m = 900
x_m = 300
[[cloud.ball]]
radius_m = 150
[[cloud.level]]
[[cloud.particle_edit]]
)";

/// Edits of every row of a panel with a mouse and a keyboard.
class PanelEdits : public WindowTest {
 protected:
  std::string value_of(const scene::Parameter& row) const {
    return scene::value_text(state().scene, row, scene::Digits::exact);
  }

  void edit(const scene::Parameter& row) {
    if (row.elements) add_elements(row);
    const std::string before = value_of(row);
    std::visit([&](auto storage) { change(row, storage); }, row.storage);
    wait_for_clouds();
    EXPECT_NE(value_of(row), before) << row.key << ": " << message();
    EXPECT_FALSE(state().message.is_fault) << row.key << ": " << message();
  }

  /// Two: the second one is edited.
  void add_elements(const scene::Parameter& row) {
    const auto count = [&] { return scene::elements_of(state().scene, row.elements).size(); };
    while (count() < 2) {
      const std::size_t before = count();
      click(find(main_panel(), fmt::format("add##{}", panel_.title), 20));
      ASSERT_EQ(count(), before + 1);
    }
  }

  static std::optional<int> shown_element(const scene::Parameter& row) {
    return row.elements ? std::optional(1) : std::nullopt;
  }

  /// By its slider or field: to the right.
  void pull(const scene::Parameter& row, int x_px) {
    const Spot spot = find(main_panel(), present::parameter_label(row), x_px, shown_element(row));
    drag(spot, {spot.x + 35, spot.y});
  }

  void change(const scene::Parameter& row, scene::ValueAt<double>) { pull(row, 70); }
  void change(const scene::Parameter& row, scene::ValueAt<std::optional<double>>) {
    click(find(main_panel(), "##set " + std::string(row.key), 16, shown_element(row)));
    pull(row, 97);
  }
  void change(const scene::Parameter& row, scene::ValueAt<int> at) {
    if (row.rule == scene::ParameterRule::power_of_two) {
      choose(present::parameter_label(row), "64");
      return;
    }
    scene::OceanScene copy = state().scene;
    // From the upper end of its range only to the left.
    const Spot spot = find(main_panel(), present::parameter_label(row), 70, shown_element(row));
    const int way = at(copy, {}) >= row.high ? -25 : 25;
    drag(spot, {spot.x + way, spot.y});
  }
  void change(const scene::Parameter& row, scene::ValueAt<std::uint64_t>) {
    enter(find(main_panel(), present::parameter_label(row), 60, shown_element(row)), "12345");
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
    if (group >= scene::ParameterGroup::clouds) {
      const bool has_layers = group == scene::ParameterGroup::cloud_layer;
      options.scene = scene::parse_scene(has_layers ? small_layers : small_clouds, "clouds.toml", "");
      options.scene.ocean.size = 32;
    }
    return options;
  }
  void change(const scene::Parameter& row, scene::ValueAt<std::string>) {
    enter(find(main_panel(), present::parameter_label(row), 60, shown_element(row)), text_for(row));
  }
  std::string text_for(const scene::Parameter& row) const {
    if (row.key == "cloud.file") return particle_file();
    if (row.key == "cloud.mesh") return "no.obj";  // which the file comes before
    if (row.key == "clouds.crisp_puffs" || row.key == "clouds.soft_puffs") return puff_folder();
    if (row.group == scene::ParameterGroup::cloud) return "K";
    return row.group == scene::ParameterGroup::terrain ? OFFING_SOURCES "/docs/gallery/calm.jpg"
                                                       : OFFING_SOURCES "/scenes/example_sea.data_spec";
  }
  std::string particle_file() const {
    const std::filesystem::path path = folder_.path() / "one.ply";
    std::ofstream(path)
        << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
           "property float z\nproperty float radius\nproperty float optical_mass\nend_header\n"
           "0 900 0 200 40000\n";
    return path.string();
  }
  std::string puff_folder() const {
    const std::filesystem::path path = folder_.path() / "puffs";
    std::filesystem::create_directories(path);
    const std::vector<unsigned char> grey(3 * 8 * 8, 128);
    for (int i = 0; i < CLOUD_TEXTURES; ++i) {
      write_png(path / fmt::format("{:02}.png", i), {.width = 8, .height = 8, .rgb = grey});
    }
    return path.string();
  }
  void change(const scene::Parameter& row, scene::ValueAt<std::optional<UtcTime>>) {
    enter(find(main_panel(), present::parameter_label(row)), "2020-06-08T15:50Z");
  }
  void change(const scene::Parameter& row, scene::ValueAt<glm::dvec3>) {
    const Spot spot = find_triple(main_panel(), present::parameter_label(row), shown_element(row));
    drag(spot, {spot.x + 35, spot.y});
  }
  /// What its box sets is another value already.
  void change(const scene::Parameter& row, scene::ValueAt<std::optional<glm::dvec3>>) {
    click(find(main_panel(), "##set " + std::string(row.key), 16, shown_element(row)));
  }
  void change(const scene::Parameter& row, scene::ValueAt<std::vector<double>>) {
    enter(find(main_panel(), present::parameter_label(row)), "250, 41");
  }
  void change(const scene::Parameter& row, const scene::ChoiceStorage& choice) {
    scene::OceanScene copy = state().scene;
    const scene::ElementIndex element =
        row.elements ? scene::elements_of(copy, row.elements)[1] : scene::ElementIndex{};
    const std::size_t other = (choice.get(copy, element) + 1) % choice.names.size();
    choose(present::parameter_label(row), std::string(choice.names[other]), shown_element(row));
  }

  /// Fails if a row has no widget, the mouse does not reach it, or it does not change its value; if an edit
  /// shows another sea, cloud, sun or eye than a window that is opened with the edited scene, by one byte.
  void expect_what_a_fresh_start_shows(const present::GroupPanel& panel) {
    panel_ = panel;
    open(options_of(panel_.group));
    const std::string start = edited_text();
    toggle_header(panel_.title);
    int rows = 0;
    for (const scene::Parameter& row : scene::parameter_table()) {
      if (row.group != panel_.group) continue;
      // Its range ends at another value, which a pull to the right passes.
      if (row.key == "cloud.heat_damping_per_s") continue;
      edit(row);
      if (HasFatalFailure()) return;
      ++rows;
    }
    EXPECT_GT(rows, 0);
    if (state().scene.has_sea()) look_at_sea();
    turn(2);
    const std::vector<unsigned char> live = picture();

    present::ViewOptions fresh = quick_options();
    fresh.scene = state().scene;
    fresh.time_s = state().clock.time_s();
    expect_undone_and_redone(start);
    expect_saved_and_loaded();
    open(fresh);
    turn(2);
    EXPECT_TRUE(picture() == live) << "the window shows another picture than a fresh start";
  }

  /// Fails if Ctrl Z does not go back to the scene at the start, or Ctrl Shift Z to that of the last edit.
  void expect_undone_and_redone(const std::string& start) {
    const std::string end = edited_text();
    int steps = 0;
    for (undo(); message() != "there is nothing to undo"; undo()) {
      wait_for_clouds();
      ASSERT_LT(++steps, 100) << message();
    }
    EXPECT_EQ(edited_text(), start);
    for (int i = 0; i < steps; ++i) {
      redo();
      wait_for_clouds();
    }
    EXPECT_EQ(edited_text(), end);
  }

  /// Fails if the scene that is saved and opened again is another one. The panel that saves it has a test of
  /// its own.
  void expect_saved_and_loaded() {
    const std::string edited = edited_text();
    scene::save_scene(state().scene, "edited.toml", scene::Existing::replace);
    drop({"edited.toml"});
    EXPECT_FALSE(state().message.is_fault) << message();
    EXPECT_EQ(edited_text(), edited);
  }

 private:
  present::GroupPanel panel_{};
};

}  // namespace offing::test

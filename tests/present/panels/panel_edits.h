#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/schema/parameter_table.h"
#include "tests/present/window/window_test.h"

namespace offing::test {

/// Rows of a panel from one to another in the order of the parameter table; without keys all of them.
struct PanelRows {
  present::GroupPanel panel;
  std::string_view first = {}, last = {};
};

/// Edits of rows of a panel with a mouse and a keyboard. Of repeated sections the last element is edited, the
/// second of two, but for wakes, whose windows have to be of one size, and clouds, whose rows fill the
/// window.
class PanelEdits : public WindowTest {
 protected:
  /// Fails if a row has no widget, the mouse does not reach it, it does not change its value, its edits
  /// cannot be undone and redone, or the scene cannot be saved and opened again; if the edits show another
  /// sea, cloud, hull, body, mesh, sun or eye than a window that is opened with the edited scene, at once or
  /// after a few frames, by one byte. What goes by degrees, such as highlights, has arrived by then: the
  /// mouse takes many frames.
  void expect_what_a_fresh_start_shows(const PanelRows& rows);

 private:
  void edit_rows();
  void edit(const scene::Parameter& row);
  void add_elements(const scene::Parameter& row);
  std::optional<int> shown_element(const scene::Parameter& row) const;
  std::string value_of(const scene::Parameter& row) const;
  /// The struct of the row's section, of its last element.
  const void* shown_struct(const scene::Parameter& row) const;

  void pull(const scene::Parameter& row, int x_px);
  void edit_slider(const scene::Parameter& row, int x_px);
  void change(const scene::Parameter& row, scene::ValueAt<double> at);
  void change(const scene::Parameter& row, scene::ValueAt<std::optional<double>> at);
  void change(const scene::Parameter& row, scene::ValueAt<int> at);
  void change(const scene::Parameter& row, scene::ValueAt<std::uint64_t> at);
  void change(const scene::Parameter& row, scene::ValueAt<std::string> at);
  void change(const scene::Parameter& row, scene::ValueAt<std::optional<UtcTime>> at);
  void change(const scene::Parameter& row, scene::ValueAt<glm::dvec3> at);
  void change(const scene::Parameter& row, scene::ValueAt<std::optional<glm::dvec3>> at);
  void change(const scene::Parameter& row, scene::ValueAt<std::vector<double>> at);
  void change(const scene::Parameter& row, const scene::ChoiceStorage& choice);

  std::string text_for(const scene::Parameter& row) const;
  std::string particle_file() const;
  std::string mesh_file() const;
  std::string grey_image(const std::string& name) const;
  std::string billboard_folder() const;

  void expect_undone_and_redone(const std::string& start);
  void expect_saved_and_loaded();
  void step_frames();

  PanelRows rows_{};
};

/// What a window is opened with to edit rows: small enough to be made in a moment.
present::ViewOptions panel_options(const PanelRows& rows, present::ViewOptions usual);

/// Wakes, meshes and what belongs to them, lights, floating bodies.
bool is_of_world(scene::ParameterGroup group);
bool is_of_clouds(scene::ParameterGroup group);

/// The name of a case: the panel's title.
std::string panel_name(const testing::TestParamInfo<present::GroupPanel>& panel);

}  // namespace offing::test

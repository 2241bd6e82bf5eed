#include "tests/present/panels/panel_edits.h"

#include <algorithm>
#include <cstddef>
#include <fstream>
#include <variant>

#include <fmt/format.h>

#include "host/io/png_image.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/schema/scene_elements.h"
#include "present/panels/parameter_widget.h"

namespace offing::test {
namespace {

using scene::Parameter;
using scene::ValueAt;

/// Fields of widgets from the left edge of the panel.
constexpr int value_px = 70, box_px = 16, beside_box_px = 97;
constexpr int pull_px = 35;

std::size_t wanted_elements(const Parameter& row) {
  const bool is_alone = row.group == scene::ParameterGroup::wake || row.group == scene::ParameterGroup::cloud;
  return is_alone ? 1 : 2;
}

/// What is typed where a pull would end at a value that the rest of the scene forbids, or makes too much of.
std::string_view typed_for(const Parameter& row) {
  if (row.key == "ocean.wake.rain_per_m2s") return "1e-4";  // a pixel is more than the cells can take
  if (row.key == "ocean.wake.history_s") return "1";        // a pixel is half a second of simulation
  if (row.key == "mesh.scale") return "0.5";                // a pull ends where it is out of sight
  if (row.key == "body.draught_m") return "1.5";            // of hulls of four metres
  if (row.key == "body.propeller_m" || row.key == "body.rudder_m2") return "0.3";
  if (row.key == "cloud.scale") return "0.9";
  if (row.key == "cloud.fluff_m") return "20";                // a pixel is more than the cells can take
  if (row.key == "cloud.heat_damping_per_s") return "0.003";  // below the stability
  // More would be clouds that take minutes to be made.
  if (row.key == "cloud_layer.coverage") return "0.03";
  if (row.key == "cloud_layer.extent_m") return "400";
  return {};
}

/// What the small scene of meshes does not take, and says so: it has no body that carries them.
bool is_refused(const Parameter& row) {
  return row.key == "mesh.aboard" || row.key == "ocean.modes_file" || row.key == "body.hydrodynamics";
}

}  // namespace

std::string panel_name(const testing::TestParamInfo<present::GroupPanel>& panel) {
  std::string name = panel.param.title;
  std::erase(name, ' ');
  return name;
}

std::string PanelEdits::value_of(const Parameter& row) const {
  return scene::value_text(state().scene, row, scene::Digits::exact);
}

void PanelEdits::edit(const Parameter& row) {
  if (row.section->is_repeated()) add_elements(row);
  const std::string before = value_of(row);
  std::visit([&](auto storage) { change(row, storage); }, row.storage);
  wait_for_clouds();
  EXPECT_EQ(value_of(row) == before, is_refused(row)) << row.key << ": " << message();
  EXPECT_EQ(state().message.is_fault, is_refused(row)) << row.key << ": " << message();
}

void PanelEdits::add_elements(const Parameter& row) {
  const auto count = [&] { return scene::elements_of(state().scene, *row.section).size(); };
  while (count() < wanted_elements(row)) {
    const std::size_t before = count();
    click(find(values(), fmt::format("add##{}", rows_.panel.title), 20));
    ASSERT_EQ(count(), before + 1);
  }
}

std::optional<int> PanelEdits::shown_element(const Parameter& row) const {
  if (!row.section->is_repeated()) return {};
  return static_cast<int>(scene::elements_of(state().scene, *row.section).size()) - 1;
}

const void* PanelEdits::shown_struct(const Parameter& row) const {
  return scene::struct_at(&state().scene, *row.section, scene::last_element(state().scene, *row.section));
}

/// By its slider or field: to the right.
void PanelEdits::pull(const Parameter& row, int x_px) {
  const Spot spot = find(values(), present::parameter_label(row), x_px, shown_element(row));
  drag(spot, {spot.x + pull_px, spot.y});
}

void PanelEdits::edit_slider(const Parameter& row, int x_px) {
  const std::string_view typed = typed_for(row);
  if (typed.empty()) return pull(row, x_px);
  enter_into_slider(find(values(), present::parameter_label(row), x_px, shown_element(row)),
                    std::string(typed));
}

void PanelEdits::change(const Parameter& row, ValueAt<double>) {
  edit_slider(row, value_px);
}

void PanelEdits::change(const Parameter& row, ValueAt<std::optional<double>>) {
  click(find(values(), "##set " + std::string(row.key), box_px, shown_element(row)));
  edit_slider(row, beside_box_px);
}

void PanelEdits::change(const Parameter& row, ValueAt<int> at) {
  if (row.rule == scene::ParameterRule::power_of_two) {
    choose(present::parameter_label(row), "64", shown_element(row));
    return;
  }
  // From the upper end of its range only to the left.
  const Spot spot = find(values(), present::parameter_label(row), value_px, shown_element(row));
  const int way = at.in(shown_struct(row)) >= row.high ? -25 : 25;
  drag(spot, {spot.x + way, spot.y});
}

void PanelEdits::change(const Parameter& row, ValueAt<std::uint64_t>) {
  enter(find(values(), present::parameter_label(row), value_px, shown_element(row)), "12345");
}

void PanelEdits::change(const Parameter& row, ValueAt<std::string>) {
  enter(find(values(), present::parameter_label(row), value_px, shown_element(row)), text_for(row));
}

void PanelEdits::change(const Parameter& row, ValueAt<std::optional<UtcTime>>) {
  enter(find(values(), present::parameter_label(row)), "2020-06-08T15:50Z");
}

void PanelEdits::change(const Parameter& row, ValueAt<glm::dvec3> at) {
  const Spot spot = find_triple(values(), present::parameter_label(row), shown_element(row));
  // Colours begin at the end of their range.
  const double first = at.in(shown_struct(row)).x;
  const int way = first >= row.high * row.scale ? -pull_px : pull_px;
  drag(spot, {spot.x + way, spot.y});
}

/// What its box sets is another value already.
void PanelEdits::change(const Parameter& row, ValueAt<std::optional<glm::dvec3>>) {
  click(find(values(), "##set " + std::string(row.key), box_px, shown_element(row)));
}

void PanelEdits::change(const Parameter& row, ValueAt<std::vector<double>>) {
  enter(find(values(), present::parameter_label(row)), "250, 41");
}

void PanelEdits::change(const Parameter& row, const scene::ChoiceStorage& choice) {
  const std::size_t chosen = choice.in(shown_struct(row));
  choose(present::parameter_label(row), std::string(choice.names[(chosen + 1) % choice.names.size()]),
         shown_element(row));
}

std::string PanelEdits::text_for(const Parameter& row) const {
  if (row.key == "cloud.file") return particle_file();
  if (row.key == "cloud.mesh") return mesh_file();
  if (row.key == "clouds.crisp_billboards" || row.key == "clouds.soft_billboards") return billboard_folder();
  if (row.key == "mesh.file") return mesh_file();
  if (row.key == "mesh.cartoon_ramp" || row.key == "mesh.highlight.picture") return grey_image("grey.png");
  if (row.key == "mesh.highlight.light") return "right";
  if (row.key == "mesh.aboard") return "first";
  if (row.rule == scene::ParameterRule::name || row.group == scene::ParameterGroup::cloud) return "K";
  using scene::ParameterGroup;
  const bool is_picture = row.group == ParameterGroup::terrain || row.group == ParameterGroup::canopy;
  return OFFING_SOURCES +
         std::string(is_picture ? "/docs/gallery/calm.jpg" : "/scenes/example_sea.data_spec");
}

std::string PanelEdits::particle_file() const {
  const std::filesystem::path path = folder_.path() / "one.ply";
  std::ofstream(path) << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n"
                         "property float z\nproperty float radius\nproperty float optical_mass\nend_header\n"
                         "0 900 0 200 40000\n";
  return path.string();
}

std::string PanelEdits::mesh_file() const {
  const std::filesystem::path path = folder_.path() / "tetrahedron.obj";
  std::ofstream(path) << "v 0 0 0\nv 2 0 0\nv 0 2 0\nv 0 0 2\nf 1 3 2\nf 1 2 4\nf 1 4 3\nf 2 3 4\n";
  return path.string();
}

std::string PanelEdits::grey_image(const std::string& name) const {
  constexpr int side_px = 8;
  const std::filesystem::path path = folder_.path() / name;
  const std::vector<unsigned char> grey(3 * side_px * side_px, 128);
  write_png(path, {.width = side_px, .height = side_px, .rgb = grey});
  return path.string();
}

std::string PanelEdits::billboard_folder() const {
  const std::filesystem::path path = folder_.path() / "puffs";
  std::filesystem::create_directories(path);
  for (int i = 0; i < CLOUD_TEXTURES; ++i) grey_image(fmt::format("puffs/{:02}.png", i));
  return path.string();
}

void PanelEdits::edit_rows() {
  toggle_header(rows_.panel.title);
  bool is_among = rows_.first.empty();
  int rows = 0;
  for (const Parameter& row : scene::parameter_table()) {
    if (row.group != rows_.panel.group) continue;
    is_among = is_among || row.key == rows_.first;
    if (!is_among) continue;
    edit(row);
    if (HasFatalFailure()) return;
    ++rows;
    if (row.key == rows_.last) break;
  }
  EXPECT_GT(rows, 0);
}

void PanelEdits::step_frames() {
  for (int i = 0; i < 3; ++i) press("period");
}

void PanelEdits::expect_what_a_fresh_start_shows(const PanelRows& rows) {
  rows_ = rows;
  open(panel_options(rows, quick_options()));
  const std::string start = edited_text();
  edit_rows();
  if (HasFatalFailure()) return;
  if (state().scene.has_sea()) look_at_sea();
  turn(2);
  const std::vector<unsigned char> live = picture();
  present::ViewOptions fresh = quick_options();
  fresh.scene = state().scene;
  // A refused edit has forgotten which values were written: nothing else is to place the eye.
  fresh.scene.set_at.emplace("camera.y_m", "the test");
  fresh.time_s = state().clock.time_s();
  step_frames();
  const std::vector<unsigned char> live_later = picture();
  expect_undone_and_redone(start);
  expect_saved_and_loaded();
  open(fresh);
  turn(2);
  EXPECT_TRUE(picture() == live) << "the window shows another picture than a fresh start";
  step_frames();
  EXPECT_TRUE(picture() == live_later) << "a few frames later";
}

/// Fails if Ctrl Z does not go back to the scene at the start, or Ctrl Shift Z to that of the last edit.
void PanelEdits::expect_undone_and_redone(const std::string& start) {
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
void PanelEdits::expect_saved_and_loaded() {
  const std::string edited = edited_text();
  scene::save_scene(state().scene, "edited.toml", Existing::replace);
  drop({"edited.toml"});
  EXPECT_FALSE(state().message.is_fault) << message();
  EXPECT_EQ(edited_text(), edited);
}

}  // namespace offing::test

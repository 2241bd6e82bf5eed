#include "host/scene/file/scene_file.h"
#include "tests/present/panels/panel_edits.h"

namespace offing::test {
namespace {

constexpr const char* small_layers = R"(version = 1
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
constexpr const char* small_clouds = R"(version = 1
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
constexpr const char* small_cloud = R"(version = 1
[camera]
y_m = 1000
z_m = 2500
[[cloud]]
[[cloud.ball]]
radius_m = 150
)";
constexpr const char* small_letter = R"(version = 1
[camera]
y_m = 1000
z_m = 2500
[[cloud]]
text = "L"
target_particles = 200
)";
constexpr const char* small_wake = R"(version = 1
[ocean]
size = 32
[camera]
y_m = 30
pitch_deg = 70
[[ocean.wake]]
length_m = 64
cells = 32
history_s = 0.5
[[ocean.wake.hull]]
speed_mps = 4
[[ocean.wake.hull]]
z_m = 8
speed_mps = 4
)";
// That the pulls bring before the eye: 17.5 m along each axis. An edit shows the second one.
constexpr const char* small_meshes = R"(version = 1
[camera]
z_m = 12
[[light]]
name = "left"
azimuth_deg = 200
[[light]]
name = "right"
azimuth_deg = 160
[[mesh]]
name = "a"
shape = "sphere"
x_m = -1.2
y_m = 5
[[mesh]]
name = "b"
shape = "sphere"
x_m = -16.3
y_m = -12.5
z_m = -17.5
highlights = "off"
visible = "off"
)";
constexpr const char* small_highlights = R"(version = 1
[camera]
z_m = 12
[[light]]
name = "left"
azimuth_deg = 200
[[light]]
name = "right"
azimuth_deg = 160
[[mesh]]
name = "a"
shape = "sphere"
x_m = -1.2
y_m = 5
[[mesh]]
name = "b"
shape = "ellipsoid"
x_m = 1.2
y_m = 5
[[mesh.highlight]]
[[mesh.highlight]]
)";
// The second is led along a path until its edit, and pulled before the eye; "K" is the mesh that it is given.
constexpr const char* small_bodies = R"(version = 1
[ocean]
size = 32
[camera]
y_m = 12
z_m = 24
pitch_deg = 69
[[ocean.wake]]
length_m = 64
cells = 32
history_s = 0.5
centre = "body"
[[mesh]]
name = "a"
shape = "sphere"
size_m = 2
highlights = "off"
[[mesh]]
name = "b"
shape = "sphere"
size_m = 2
highlights = "off"
[[mesh]]
name = "K"
shape = "sphere"
size_m = 2
highlights = "off"
[[body]]
mesh = "a"
x_m = -2
[[body]]
mesh = "b"
motion = "path"
x_m = -16.5
z_m = -17.5
)";
constexpr const char* small_moorings = R"(version = 1
[ocean]
size = 32
[camera]
y_m = 12
z_m = 24
pitch_deg = 69
[[mesh]]
name = "a"
shape = "sphere"
size_m = 2
highlights = "off"
[[body]]
mesh = "a"
[[body.mooring]]
[[body.mooring]]
)";
const char* text_of(const PanelRows& rows) {
  const scene::ParameterGroup group = rows.panel.group;
  switch (group) {
    case scene::ParameterGroup::wake:
    case scene::ParameterGroup::wake_hull:
      return small_wake;
    case scene::ParameterGroup::mesh:
      return small_meshes;
    case scene::ParameterGroup::highlight:
    case scene::ParameterGroup::light:
      return small_highlights;
    case scene::ParameterGroup::body:
      return small_bodies;
    case scene::ParameterGroup::mooring:
      return small_moorings;
    case scene::ParameterGroup::cloud_layer:
      return small_layers;
    case scene::ParameterGroup::cloud:
      return rows.first == "cloud.yaw_deg" ? small_letter : small_cloud;
    default:
      return is_of_clouds(group) ? small_clouds : nullptr;
  }
}

}  // namespace

bool is_of_world(scene::ParameterGroup group) {
  switch (group) {
    case scene::ParameterGroup::wake:
    case scene::ParameterGroup::wake_hull:
    case scene::ParameterGroup::mesh:
    case scene::ParameterGroup::highlight:
    case scene::ParameterGroup::light:
    case scene::ParameterGroup::body:
    case scene::ParameterGroup::mooring:
      return true;
    default:
      return false;
  }
}

bool is_of_clouds(scene::ParameterGroup group) {
  return group >= scene::ParameterGroup::clouds;
}

present::ViewOptions panel_options(const PanelRows& rows, present::ViewOptions usual) {
  const scene::ParameterGroup group = rows.panel.group;
  if (const char* text = text_of(rows)) {
    const int size = usual.scene.ocean.parameters.size;
    usual.scene = scene::parse_scene(text, "small.toml", "");
    usual.scene.ocean.parameters.size = size;
  }
  if (group == scene::ParameterGroup::terrain || group == scene::ParameterGroup::material ||
      group == scene::ParameterGroup::canopy || group == scene::ParameterGroup::walk) {
    usual.scene.terrain.is_given = usual.scene.ocean.is_given = true;
    usual.scene.terrain.fractal.posts = 33;
    usual.scene.terrain.canopy.wood.share = group == scene::ParameterGroup::canopy ? 0.5 : 0.0;
    // A scene that says where its eye is: nothing else places it.
    usual.scene.view.camera.eye_m.y = 2500.0;
    usual.scene.set_at.emplace("camera.y_m", "the test");
  }
  // Bodies begin anew at the time of an edit.
  const bool has_bodies = group == scene::ParameterGroup::body || group == scene::ParameterGroup::mooring;
  if (has_bodies) usual.time_s = 0.0;
  return usual;
}

}  // namespace offing::test

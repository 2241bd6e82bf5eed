#include "host/scene/scene_file.h"
#include "tests/present/panel_edits.h"

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
constexpr const char* small_meshes = R"(version = 1
[camera]
z_m = 5
[[light]]
name = "left"
[[light]]
name = "right"
[[mesh]]
name = "a"
shape = "sphere"
[[mesh]]
name = "b"
shape = "sphere"
x_m = 2
[[mesh.highlight]]
[[mesh.highlight]]
)";
const char* text_of(scene::ParameterGroup group) {
  switch (group) {
    case scene::ParameterGroup::wake:
    case scene::ParameterGroup::wake_hull:
      return small_wake;
    case scene::ParameterGroup::mesh:
    case scene::ParameterGroup::highlight:
    case scene::ParameterGroup::light:
      return small_meshes;
    case scene::ParameterGroup::cloud_layer:
      return small_layers;
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
      return true;
    default:
      return false;
  }
}

bool is_of_clouds(scene::ParameterGroup group) {
  return group >= scene::ParameterGroup::clouds;
}

present::ViewOptions panel_options(scene::ParameterGroup group, present::ViewOptions usual) {
  if (const char* text = text_of(group)) {
    const int size = usual.scene.ocean.size;
    usual.scene = scene::parse_scene(text, "small.toml", "");
    usual.scene.ocean.size = size;
  }
  if (group == scene::ParameterGroup::terrain || group == scene::ParameterGroup::walk) {
    usual.scene.terrain.is_given = usual.scene.names_sea = true;
    usual.scene.terrain.fractal.posts = 33;
    // A scene that says where its eye is: nothing else places it.
    usual.scene.view.camera.eye_m.y = 2500.0;
    usual.scene.set_at.emplace("camera.y_m", "the test");
  }
  return usual;
}

}  // namespace offing::test

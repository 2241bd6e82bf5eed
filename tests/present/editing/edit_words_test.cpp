// The words by which undo and redo name edits.
#include "present/editing/edit_words.h"

#include <functional>
#include <string>

#include <gtest/gtest.h>

#include "host/scene/file/scene_file.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "present/editing/objects/scene_objects.h"

namespace offing::present {
namespace {

constexpr const char* scene_text = R"(version = 1
[ocean]
[[ocean.swell]]
amplitude_m = 1
[[ocean.wake]]
centre = "body"
body = "boat"
[[mesh]]
name = "hull"
shape = "ship"
[[mesh.highlight]]
[[mesh]]
name = "buoy"
shape = "sphere"
[[body]]
name = "boat"
mesh = "hull"
[[cloud]]
y_m = 900
[[cloud]]
y_m = 1000
)";

std::string words_of_edit(const std::function<void(scene::Scene&)>& change) {
  const scene::Scene before = scene::parse_scene(scene_text, "a.toml", "");
  scene::Scene after = before;
  change(after);
  return edit_words(before, after);
}

void set(scene::Scene& scene, const char* key, const char* text, scene::ElementIndex element = {}) {
  const scene::Parameter& row = *scene::find_parameter(key);
  scene::store(scene, row, scene::read_flag_value(row, text), {.subject = key}, element);
}

// Fails if values are not named as panels and the list of objects name them, or the wrong object is named.
TEST(EditWordsTest, NameValues) {
  EXPECT_EQ(words_of_edit([](scene::Scene&) {}), "no change");
  EXPECT_EQ(words_of_edit([](scene::Scene& scene) { set(scene, "wind.speed_mps", "3"); }), "Wind: speed");
  EXPECT_EQ(words_of_edit([](scene::Scene& scene) {
              set(scene, "cloud.y_m", "3", {1, 0});
            }),
            "cloud 2: y (up)");
  EXPECT_EQ(words_of_edit([](scene::Scene& scene) { set(scene, "mesh.highlight.rotation_deg", "3"); }),
            "hull, highlight 1: rotation");
  EXPECT_EQ(words_of_edit([](scene::Scene& scene) { set(scene, "ocean.swell.direction_deg", "3"); }),
            "swell 1: direction");
  EXPECT_EQ(words_of_edit([](scene::Scene& scene) {
              set(scene, "mesh.x_m", "3", {1, 0});
              set(scene, "mesh.z_m", "3", {1, 0});
            }),
            "buoy: x (east), z (south)");
  EXPECT_EQ(words_of_edit([](scene::Scene& scene) {
              set(scene, "wind.speed_mps", "3");
              set(scene, "sun.elevation_deg", "3");
              set(scene, "sky.ozone_du", "250");
            }),
            "Wind: speed and 2 more");
  EXPECT_EQ(words_of_edit([](scene::Scene& scene) {
              scene.tracks[{"mesh.yaw_deg", {1, 0}}].keys = {{0.0, 0.0}, {1.0, 1.0}};
            }),
            "buoy: yaw (keyframes)");
}

// Fails if an edit is named after what comes with an object, or after the object behind a deleted one.
TEST(EditWordsTest, NameObjects) {
  const auto removed = [](const SceneObject& object) {
    return words_of_edit([&](scene::Scene& scene) { remove_object(scene, object); });
  };
  EXPECT_EQ(removed({ObjectKind::cloud, 0}), "delete cloud 1");
  EXPECT_EQ(removed({ObjectKind::mesh, 1}), "delete buoy");
  EXPECT_EQ(removed({ObjectKind::body, 0}), "delete boat");
  EXPECT_EQ(words_of_edit([](scene::Scene& scene) { stop_floating(scene, 0); }), "stop floating boat");
  EXPECT_EQ(words_of_edit([](scene::Scene& scene) {
              duplicate_object(scene, {ObjectKind::body, 0}, {20.0, 0.0, 0.0});
            }),
            "add boat 2");
  EXPECT_EQ(words_of_edit([](scene::Scene& scene) {
              rename_object(scene, {ObjectKind::mesh, 1}, "mark");
            }),
            "mark: name");
  const scene::Parameter& swell = *scene::find_parameter("ocean.swell.direction_deg");
  EXPECT_EQ(words_of_edit([&](scene::Scene& scene) { scene::append_element(scene, swell, {}); }),
            "add swell");
}

// Fails if clouds with other balls, but as many in all, are compared as if they had the same: beyond the end
// of a list, once.
TEST(EditWordsTest, NamePartsThatAreElsewhere) {
  const std::string ball = "[[cloud.ball]]\nradius_m = 150\n", cloud = "[[cloud]]\ny_m = 900\n";
  const auto scene = [&](const std::string& first, const std::string& second) {
    return scene::parse_scene("version = 1\n" + cloud + first + cloud + second, "a.toml", "");
  };
  EXPECT_EQ(edit_words(scene(ball + ball, ball), scene(ball, ball + ball)), "change ball");
}

// Fails if an edit is named after a move of the eye, or edits of the eye's path are not named.
TEST(EditWordsTest, LeaveOutTheEye) {
  EXPECT_EQ(words_of_edit([](scene::Scene& scene) {
              scene.view.camera.eye_m.x += 4.0;
              set(scene, "wind.speed_mps", "3");
            }),
            "Wind: speed");
  scene::Scene before, after;
  before.tracks[{"camera.x_m"}].keys = {{0.0, 0.0}, {1.0, 1.0}};
  EXPECT_EQ(edit_words(before, after), "no change");
  after.tracks[{"camera.x_m"}].keys = {{0.0, 0.0}, {2.0, 1.0}};
  EXPECT_EQ(edit_words(before, after), "Camera: x (east) (keyframes)");
}

}  // namespace
}  // namespace offing::present

// What pulls of handles make of meshes, bodies and lights.
#include "present/editing/objects/object_edits.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <gtest/gtest.h>

#include "host/base/camera.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/mesh_motion.h"
#include "host/scene/prepare/scene_meshes.h"

namespace offing::present {
namespace {

using highlights::RigidMotion;

scene::Scene objects_scene(const std::string& text) {
  return scene::parse_scene("version = 1\n" + text, "objects.toml", "");
}

glm::dvec3 moved_by(const RigidMotion& motion, const glm::dvec3& place_m) {
  return motion.rotation * place_m + motion.translation_m;
}

double largest_difference(const glm::dmat3& a, const glm::dmat3& b) {
  double largest = 0.0;
  for (int i = 0; i < 3; ++i) largest = std::max(largest, glm::length(a[i] - b[i]));
  return largest;
}

// Fails if angles that are read from a rotation do not make it again, upright or at the poles.
TEST(ObjectEditsTest, TurnsMakeTheirRotation) {
  constexpr double quarter = 0.5 * std::numbers::pi;
  for (const glm::dvec3 turns : {glm::dvec3(0.3, -0.4, 1.2),
                                 {-2.9, 1.4, -3.0},
                                 {1.0, quarter, 0.0},
                                 {0.7, -quarter, 0.0},
                                 {0.2, quarter, 0.5},
                                 {0.0, 0.0, 0.0}}) {
    const auto rotation_of_turns = [](const glm::dvec3& t) {
      const CameraBasis axes = basis({.yaw_rad = t.x, .pitch_rad = t.y, .roll_rad = t.z});
      return glm::dmat3(axes.right, axes.up, -axes.forward);
    };
    const glm::dmat3 rotation = rotation_of_turns(turns);
    EXPECT_LE(largest_difference(rotation_of_turns(turns_of(rotation)), rotation), 1e-6) << turns.x;
  }
}

// The middle of a mesh goes as far as the hand and stays where it is when the mesh is turned or resized,
// with keyframes too, and on a body that has its own axes.
TEST(ObjectEditsTest, MeshesGoAboutTheirMiddle) {
  scene::Scene scene = objects_scene(R"(
[ocean]
[[mesh]]
shape = "box"
x_m = { keys = [{ t = 0, value = 1 }, { t = 10, value = 5 }] }
y_m = 4
yaw_deg = 30
pitch_deg = 20
roll_deg = -10
scale = 2
)");
  constexpr double time_s = 4.0;
  const glm::dvec3 middle_m(0.5, 0.2, -0.3);
  const ObjectPull pull{.way_m = {3.0, -1.0, 2.0}, .ratio = 1.5, .turn_rad = {0.0, 0.6, 0.0}};
  const CameraBasis hull = basis({.yaw_rad = 0.8, .pitch_rad = 0.1, .roll_rad = 0.2});
  const RigidMotion nothing, body{{hull.right, hull.up, -hull.forward}, {100.0, 1.0, -50.0}};
  for (const RigidMotion& parent : {nothing, body}) {
    scene::Scene edited = scene;
    const RigidMotion local = scene::motion_of(scene, 0)(time_s);
    pull_mesh(edited, {.mesh = 0, .local = local, .parent = parent, .middle_m = middle_m}, pull);
    const RigidMotion after = scene::motion_of(edited, 0)(time_s);
    EXPECT_EQ(edited.meshes[0].scale, 3.0);
    const glm::dvec3 was_m = moved_by(parent, moved_by(local, middle_m)),
                     is_m = moved_by(parent, moved_by(after, 1.5 * middle_m));
    EXPECT_LE(glm::distance(is_m, was_m + pull.way_m), 1e-9);
    EXPECT_LE(largest_difference(parent.rotation * after.rotation,
                                 rotation_of(pull) * parent.rotation * local.rotation),
              1e-9);
  }
}

// A body goes on from where it has got to, turns the way of the hand, and stays as deep for its size.
TEST(ObjectEditsTest, BodiesGoOverTheWater) {
  scene::Scene scene = objects_scene(R"(
[ocean]
[[mesh]]
name = "hull"
shape = "ship"
size_m = 10
[[body]]
mesh = "hull"
draught_m = 0.6
x_m = 1
)");
  const HeldBody held{.body = 0, .hull = 0, .pose = HeldBody::Pose{40.0, 7.0, 0.25}};
  pull_body(scene, held, {.way_m = {2.0, 9.0, -3.0}, .ratio = 2.0, .turn_rad = {0.0, 0.5, 0.0}});
  const scene::BodyScene& body = scene.bodies[0];
  EXPECT_EQ(body.x_m, 42.0);
  EXPECT_EQ(body.z_m, 4.0);
  EXPECT_NEAR(body.heading_rad, -0.25, 1e-12) << "headings grow clockwise, seen from above";
  EXPECT_EQ(scene.meshes[0].scale, 2.0);
  EXPECT_EQ(*body.draught_m, 1.2);
}

// Fails if a layer, a wake window or a bookmark goes elsewhere than the hand, a layer at the height of its
// genus begins at another one, or one that moves sideways gets a height of its own.
TEST(ObjectEditsTest, PlacesGoWithTheHand) {
  scene::Scene scene = objects_scene(R"(
[[cloud_layer]]
genus = "cumulus"
x_m = 10
extent_m = 4000
[[ocean.wake]]
centre = "place"
x_m = { keys = [{ t = 0, value = 0 }, { t = 10, value = 20 }] }
length_m = 100
[[ocean.wake]]
centre = "camera"
[[bookmark]]
x_m = 1
y_m = 2
yaw_deg = 30
)");
  const SceneObject layer{ObjectKind::cloud_layer, 0}, wake{ObjectKind::wake, 0},
      view{ObjectKind::bookmark, 0};
  const ObjectPull sideways{.way_m = {100.0, 0.0, -50.0}, .ratio = 1.5},
      all{.way_m = {1.0, 300.0, 0.0}, .turn_rad = {0.0, 0.25, 0.0}};
  for (const ObjectPull& pull : {sideways, all}) {
    for (const SceneObject& object : {layer, wake, view}) {
      const Sphere before = *place_of(scene, object, 5.0);
      pull_place(scene, object, before, pull);
      glm::dvec3 way_m = pull.way_m;
      if (object == wake) way_m.y = 0.0;
      const Sphere after = *place_of(scene, object, 5.0);
      EXPECT_LE(glm::distance(after.centre_m, before.centre_m + way_m), 1e-9);
      EXPECT_NEAR(after.radius_m, pull.ratio * before.radius_m, 1e-9);
      if (object != layer) continue;
      EXPECT_EQ(scene.cloud_layers[0].altitude_m.has_value(), pull.way_m.y != 0.0);
    }
  }
  EXPECT_NEAR(scene.bookmarks[0].camera.yaw_rad, std::numbers::pi / 6.0 - 0.25, 1e-12);
  EXPECT_FALSE(place_of(scene, {ObjectKind::wake, 1}, 5.0)) << "it is about the camera";
  pull_place(scene, layer, *place_of(scene, layer, 0.0), {.way_m = {0.0, 1e9, 0.0}});
  EXPECT_EQ(scene.cloud_layers[0].altitude_m, 50e3) << "the end of its range";
}

// Fails if a light of a direction does not stand where it was aimed, or one of a place where it was brought.
TEST(ObjectEditsTest, LightsAreAimedAndMoved) {
  scene::Scene scene = objects_scene(
      "[[light]]\nazimuth_deg = 350\nelevation_deg = 20\n[[light]]\nkind = \"place\"\ny_m = 3\n");
  const glm::dvec3 before = scene::lights_at(scene, 0.0)[0].source.vector;
  const glm::dvec3 wanted = glm::normalize(glm::dvec3(0.3, -0.2, 0.9));
  aim_light(scene, 0, before, wanted);
  EXPECT_LE(glm::distance(scene::lights_at(scene, 0.0)[0].source.vector, wanted), 1e-9);
  pull_place(scene, {ObjectKind::light, 1}, {}, {.way_m = {1.0, 2.0, -4.0}});
  EXPECT_LE(glm::distance(scene::lights_at(scene, 0.0)[1].source.vector, glm::dvec3(1.0, 5.0, -4.0)), 1e-12);
}

}  // namespace
}  // namespace offing::present

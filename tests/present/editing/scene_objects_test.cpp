// Objects of a scene: what is listed, and what goes along when one is deleted, copied or renamed.
#include "present/editing/objects/scene_objects.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/prepare/mesh_motion.h"
#include "host/scene/prepare/scene_bodies.h"
#include "present/editing/objects/new_objects.h"

namespace offing::present {
namespace {

constexpr const char* harbour = R"(version = 1
[ocean]
[[ocean.wake]]
centre = "body"
body = "ship"
[[light]]
name = "lantern"
kind = "place"
[[mesh]]
name = "buoy"
shape = "sphere"
x_m = { keys = [{ t = 0, value = 1 }, { t = 10, value = 5 }] }
[[mesh]]
name = "hull"
shape = "ship"
size_m = 20
[[mesh.highlight]]
light = "lantern"
[[mesh]]
name = "mast"
shape = "box"
aboard = "ship"
x_m = 2
y_m = 3
[[body]]
name = "ship"
mesh = "hull"
draught_m = 1.2
x_m = 10
z_m = -5
heading_deg = 90
[[bookmark]]
name = "quay"
)";

scene::Scene harbour_scene() {
  return scene::parse_scene(harbour, "harbour.toml", "");
}

std::vector<std::string> labels_of(const scene::Scene& scene) {
  std::vector<std::string> labels;
  for (const SceneObject& object : objects_of(scene)) labels.push_back(label_of(scene, object));
  return labels;
}

std::string text_of(const scene::Scene& scene) {
  return scene::scene_text(scene, "");
}

// Fails if something of the scene is not listed, or listed twice.
TEST(SceneObjectsTest, AllAreListed) {
  EXPECT_EQ(labels_of(harbour_scene()),
            (std::vector<std::string>{"camera", "quay", "sun and sky", "sea", "buoy", "ship", "hull", "mast",
                                      "wake of ship", "lantern"}));
}

// Fails if a part of a boat is not known as one, so that the list does not show it below the boat.
TEST(SceneObjectsTest, PartsBelongToTheirBody) {
  scene::Scene scene = harbour_scene();
  EXPECT_EQ(parts_of_body(scene, 0),
            (std::vector<SceneObject>{{ObjectKind::mesh, 1}, {ObjectKind::mesh, 2}, {ObjectKind::wake, 0}}));
  EXPECT_FALSE(body_of_part(scene, {ObjectKind::mesh, 0}));
  scene.ocean.wakes[0].body.clear();
  EXPECT_EQ(body_of_part(scene, {ObjectKind::wake, 0}), 0u) << "it follows the first";
  scene.ocean.wakes[0].centre = scene::WakeCentre::place;
  EXPECT_FALSE(body_of_part(scene, {ObjectKind::wake, 0}));
}

// Fails if what cannot be without a hull stays, or anything else goes.
TEST(SceneObjectsTest, AHullTakesItsBodyAlong) {
  for (const SceneObject object : {SceneObject{ObjectKind::mesh, 1}, {ObjectKind::body, 0}}) {
    scene::Scene scene = harbour_scene();
    remove_object(scene, object);
    EXPECT_EQ(labels_of(scene),
              (std::vector<std::string>{"camera", "quay", "sun and sky", "sea", "buoy", "lantern"}));
    EXPECT_EQ(scene.tracks.size(), 1u);
    EXPECT_NO_THROW(scene::parse_scene(text_of(scene), "rest.toml", ""));
  }
}

// A box of 2 m that floats 0.5 m deep, with its centre of mass beside its middle; it heads south, so that its
// x axis is the world's z. Something aboard moves along x and turns.
constexpr const char* raft = R"(version = 1
[ocean]
[[ocean.wake]]
centre = "body"
body = "raft"
[[mesh]]
name = "hull"
shape = "box"
size_m = 1
yaw_deg = 300
[[mesh]]
name = "mast"
shape = "box"
aboard = "raft"
x_m = { keys = [{ t = 0, value = 2 }, { t = 10, value = 6 }], interpolation = "linear" }
y_m = 3
yaw_deg = { keys = [{ t = 0, value = 290 }, { t = 10, value = 350 }], interpolation = "linear" }
[[body]]
name = "raft"
mesh = "hull"
draught_m = 0.5
mass_centre_m = [1, -0.2, 0.5]
x_m = 10
z_m = -5
heading_deg = 90
)";

// A body that stops floating leaves its meshes where it floated at its start. Fails if they jump, though its
// place is that of its centre of mass; if they move or turn otherwise from there; or the wake still follows
// it.
TEST(SceneObjectsTest, ABodyLeavesItsMeshes) {
  scene::Scene scene = scene::parse_scene(raft, "raft.toml", "");
  stop_floating(scene, 0);
  EXPECT_TRUE(scene.bodies.empty());
  EXPECT_TRUE(scene.ocean.wakes.empty());
  EXPECT_TRUE(scene.meshes[1].aboard.empty());
  const auto hull = scene::motion_of(scene, 0)(0.0);
  EXPECT_LE(glm::distance(hull.translation_m, glm::dvec3(10.5, 0.5, -6.0)), 1e-6);
  EXPECT_LE(glm::distance(hull.rotation * glm::dvec3(0.0, 0.0, -1.0), glm::dvec3(0.5, 0.0, -std::sqrt(0.75))),
            1e-9)
      << "300 and 90 degrees are 30";
  const auto mast = scene::motion_of(scene, 1);
  EXPECT_LE(glm::distance(mast(0.0).translation_m, glm::dvec3(10.5, 3.5, -4.0)), 1e-6);
  EXPECT_LE(glm::distance(mast(5.0).translation_m, glm::dvec3(10.5, 3.5, -2.0)), 1e-6);
  EXPECT_LE(glm::distance(mast(10.0).translation_m, glm::dvec3(10.5, 3.5, 0.0)), 1e-6);
  const auto angle_rad = [&](double time_s) {
    const glm::dvec3 forward = mast(time_s).rotation * glm::dvec3(0.0, 0.0, -1.0);
    return std::atan2(forward.x, -forward.z);
  };
  constexpr double degree = 0.017453292519943295;
  EXPECT_NEAR(angle_rad(0.0), 20.0 * degree, 1e-9);
  EXPECT_NEAR(angle_rad(5.0), 50.0 * degree, 1e-9);
  EXPECT_NEAR(angle_rad(10.0), 80.0 * degree, 1e-9);
  EXPECT_NO_THROW(scene::parse_scene(text_of(scene), "rest.toml", ""));
}

// Fails if a copy is the original, shares its name, keyframes or body, or lies on it.
TEST(SceneObjectsTest, CopiesAreOnTheirOwn) {
  scene::Scene scene = harbour_scene();
  const SceneObject buoy = duplicate_object(scene, {ObjectKind::mesh, 0}, {4.0, 0.0, 0.0});
  EXPECT_EQ(label_of(scene, buoy), "buoy 2");
  EXPECT_EQ(scene::motion_of(scene, buoy.index)(10.0).translation_m.x, 9.0);
  EXPECT_EQ(scene::motion_of(scene, 0)(10.0).translation_m.x, 5.0);

  const SceneObject hull = duplicate_object(scene, {ObjectKind::mesh, 1}, {0.0, 0.0, 8.0});
  EXPECT_EQ(label_of(scene, hull), "hull 2");
  ASSERT_EQ(scene.bodies.size(), 2u);
  EXPECT_EQ(scene.bodies[1].name, "ship 2");
  EXPECT_EQ(scene.bodies[1].mesh, "hull 2");
  EXPECT_EQ(scene.bodies[1].z_m, 3.0);
  EXPECT_EQ(scene.meshes.back().name, "mast 2");
  EXPECT_EQ(scene.meshes.back().aboard, "ship 2");
  ASSERT_EQ(scene.ocean.wakes.size(), 2u);
  EXPECT_EQ(scene.ocean.wakes[1].body, "ship 2");
  EXPECT_NO_THROW(scene::parse_scene(text_of(scene), "copies.toml", ""));

  const SceneObject light = duplicate_object(scene, {ObjectKind::light, 0}, {1.0, 0.0, 0.0});
  EXPECT_EQ(label_of(scene, light), "lantern 2");
  EXPECT_EQ(scene.lights[1].place_m.x, scene.lights[0].place_m.x + 1.0);
  EXPECT_THROW(duplicate_object(scene, {ObjectKind::sea, 0}, {}), Error);
}

// Fails if a copy is refused where there is no room for its wake, or a scene gets more wakes than it takes.
TEST(SceneObjectsTest, CopiesBeyondTheLastWakeHaveNone) {
  scene::Scene scene = harbour_scene();
  std::size_t wakes = 1;
  for (int i = 0; i < 5; ++i) {
    wakes += has_room_for_wake(scene) ? 1 : 0;
    const SceneObject copy = duplicate_object(scene, {ObjectKind::body, 0}, {10.0 * i, 0.0, 0.0});
    EXPECT_EQ(copy.kind, ObjectKind::body);
    EXPECT_EQ(scene.ocean.wakes.size(), wakes);
  }
  EXPECT_EQ(wakes, 4u) << "as docs/scenes.md has it";
  EXPECT_EQ(scene.bodies.size(), 6u);
  EXPECT_NO_THROW(scene::parse_scene(text_of(scene), "fleet.toml", ""));
}

// Fails if something still refers to the name before.
TEST(SceneObjectsTest, NamesAreFollowed) {
  scene::Scene scene = harbour_scene();
  rename_object(scene, {ObjectKind::mesh, 1}, "Rumpf");
  rename_object(scene, {ObjectKind::body, 0}, "Schiff");
  rename_object(scene, {ObjectKind::light, 0}, "Laterne");
  EXPECT_EQ(scene.bodies[0].mesh, "Rumpf");
  EXPECT_EQ(scene.meshes[2].aboard, "Schiff");
  EXPECT_EQ(scene.ocean.wakes[0].body, "Schiff");
  EXPECT_EQ(scene.meshes[1].highlights[0].light, "Laterne");
  EXPECT_THROW(rename_object(scene, {ObjectKind::mesh, 1}, ""), Error) << "its body needs it";
  EXPECT_EQ(scene.meshes[1].name, "Rumpf");
  rename_object(scene, {ObjectKind::mesh, 0}, "");
  EXPECT_EQ(label_of(scene, {ObjectKind::mesh, 0}), "mesh 1");
}

// Names are how other sections refer to objects. Fails if two get one name, or an object cannot keep its own.
TEST(SceneObjectsTest, NoTwoGetOneName) {
  scene::Scene scene = harbour_scene();
  const std::string before = text_of(scene);
  EXPECT_THROW(rename_object(scene, {ObjectKind::mesh, 0}, "mast"), Error);
  EXPECT_EQ(text_of(scene), before);
  rename_object(scene, {ObjectKind::mesh, 0}, "buoy");
  rename_object(scene, {ObjectKind::mesh, 0}, "ship");  // which is a body's
  EXPECT_EQ(scene.meshes[0].name, "ship");
  rename_object(scene, {ObjectKind::mesh, 0}, "");
  rename_object(scene, {ObjectKind::mesh, 2}, "");
  EXPECT_EQ(scene.meshes[2].name, "");
}

// Fails if a body whose hull is not there is copied as if it were a mesh.
TEST(SceneObjectsTest, ABodyWithoutAHullIsNotCopied) {
  scene::Scene scene = harbour_scene();
  scene.bodies[0].mesh = "elsewhere";
  EXPECT_THROW(duplicate_object(scene, {ObjectKind::body, 0}, {1.0, 0.0, 0.0}), Error);
  EXPECT_EQ(scene.meshes.size(), 3u);
}

// Fails if a scene loses a sea that carries something, or gets one with its last mesh.
TEST(SceneObjectsTest, TheSeaComesAndGoesAlone) {
  scene::Scene scene = harbour_scene();
  EXPECT_THROW(remove_object(scene, {ObjectKind::sea, 0}), Error) << "it carries the ship";
  stop_floating(scene, 0);
  remove_object(scene, {ObjectKind::sea, 0});
  EXPECT_FALSE(scene.has_sea());
  EXPECT_FALSE(has_object(scene, {ObjectKind::sea, 0}));
  scene::Scene sea;
  EXPECT_THROW(remove_object(sea, {ObjectKind::sea, 0}), Error) << "nothing would be left";
}

// Fails if a new object does not stand where it was asked for, is too small or too large to be seen, or takes
// the sea away.
TEST(NewObjectsTest, ShowWellFromWhereTheyAreSeen) {
  for (const double distance_m : {5.0, 50.0, 800.0}) {
    NewPlace place{.camera = {}, .place_m = {0.0, 0.0, -distance_m}, .water_m = glm::dvec3(0.0)};
    place.camera.eye_m = glm::dvec3(0.0);
    const double height_m = 2.0 * distance_m * std::tan(0.5 * place.camera.vertical_field_of_view_rad);
    scene::Scene scene;
    const AddedObject cone = add_object(scene, {.kind = NewObject::Kind::mesh, .shape = 11}, place);
    ASSERT_EQ(cone.object, (SceneObject{ObjectKind::mesh, 0}));
    EXPECT_EQ(cone.news, "added the mesh cone");
    EXPECT_TRUE(scene.has_sea());
    EXPECT_NEAR(2.0 * scene.meshes[0].size_m / height_m, 0.3, 0.03) << "as high as wide";
    EXPECT_NEAR(scene.meshes[0].position_m.y, scene.meshes[0].size_m, 1e-9) << "it stands on its base";
  }
}

// Fails if a layer is not over the eye, wherever that is.
TEST(NewObjectsTest, LayersAreOverTheEye) {
  for (const glm::dvec3& eye_m :
       {glm::dvec3(0.0), glm::dvec3(-1234.4, 5.0, -0.2), glm::dvec3(987.6, 5.0, 4e8)}) {
    NewPlace place{.camera = {}, .place_m = glm::dvec3(0.0)};
    place.camera.eye_m = eye_m;
    scene::Scene scene;
    add_object(scene, {.kind = NewObject::Kind::cloud_layer}, place);
    EXPECT_NEAR(scene.cloud_layers.at(0).x_m, eye_m.x, 1.0);
    EXPECT_NEAR(scene.cloud_layers[0].z_m, std::min(eye_m.z, 1e7), 1.0);
    EXPECT_NO_THROW(scene::parse_scene(text_of(scene), "layer.toml", ""));
  }
}

// Fails if a boat lacks what makes it sail and be followed, if a second one shares its parts, or if there is
// one without water.
TEST(NewObjectsTest, BoatsHaveHullBodyAndWake) {
  NewPlace place{.camera = {}, .place_m = glm::dvec3(0.0), .water_m = glm::dvec3(3.0, 0.0, -40.0)};
  scene::Scene scene;
  for (int i = 0; i < 2; ++i) add_object(scene, {.kind = NewObject::Kind::boat}, place);
  const std::string text = text_of(scene);
  const scene::Scene read = scene::parse_scene(text, "boats.toml", "");
  ASSERT_EQ(read.bodies.size(), 2u) << text;
  EXPECT_EQ(read.bodies[1].name, "boat 2");
  EXPECT_EQ(read.meshes[scene::mesh_of_body(read, 1)].name, "boat 2 hull");
  EXPECT_EQ(read.ocean.wakes[1].body, "boat 2");
  EXPECT_GT(read.bodies[0].speed_mps, 1.0);
  EXPECT_GT(read.bodies[0].thrust_n, 0.0);
  scene::Scene renamed = read;
  rename_object(renamed, {ObjectKind::body, 1}, "Anna");
  EXPECT_EQ(renamed.meshes[1].name, "Anna hull");
  EXPECT_EQ(renamed.bodies[1].mesh, "Anna hull");
  scene::Scene fleet;
  std::string news;
  for (int i = 0; i < 5; ++i) news = add_object(fleet, {.kind = NewObject::Kind::boat}, place).news;
  EXPECT_EQ(fleet.bodies.size(), 5u);
  EXPECT_EQ(fleet.ocean.wakes.size(), 4u);
  EXPECT_NE(news.find("without a wake"), std::string::npos) << news;
  place.water_m.reset();
  EXPECT_THROW(add_object(scene, {.kind = NewObject::Kind::boat}, place), Error);
  EXPECT_EQ(text_of(scene), text);
}

// Fails if a boat seen from high above is a ship, or one from near a toy.
TEST(NewObjectsTest, BoatsAreOfUsualSizes) {
  for (const double distance_m : {1.0, 20.0, 5000.0}) {
    NewPlace place{.camera = {}, .place_m = glm::dvec3(0.0), .water_m = glm::dvec3(0.0, 0.0, -distance_m)};
    place.camera.eye_m = glm::dvec3(0.0);
    scene::Scene scene;
    EXPECT_EQ(add_object(scene, {.kind = NewObject::Kind::boat}, place).object,
              (SceneObject{ObjectKind::body, 0}));
    EXPECT_GE(scene.meshes.at(0).size_m, 4.0);
    EXPECT_LE(scene.meshes[0].size_m, 30.0);
  }
}

// Fails if a lake is not where the camera looks, is not listed with the terrain, or stays when that goes.
TEST(NewObjectsTest, LakesLieOnTerrain) {
  const NewPlace place{.camera = {}, .place_m = glm::dvec3(120.0, 30.0, -40.0)};
  scene::Scene scene;
  EXPECT_THROW(add_object(scene, {.kind = NewObject::Kind::lake}, place), Error) << "there is no basin";
  scene.terrain.is_given = true;
  const AddedObject added = add_object(scene, {.kind = NewObject::Kind::lake}, place);
  EXPECT_EQ(added.object, (SceneObject{ObjectKind::lake, 0}));
  EXPECT_EQ(scene.lakes.at(0).x_m, 120.0);
  EXPECT_EQ(scene.lakes[0].z_m, -40.0);
  EXPECT_EQ(labels_of(scene), (std::vector<std::string>{"camera", "sun and sky", "terrain", "lake"}));
  rename_object(scene, added.object, "tarn");
  EXPECT_EQ(scene::parse_scene(text_of(scene), "tarn.toml", "").lakes.at(0).name, "tarn");
  EXPECT_FALSE(can_be_duplicated(added.object)) << "water is there already";
  remove_object(scene, {ObjectKind::terrain, 0});
  EXPECT_TRUE(scene.lakes.empty());
}

}  // namespace
}  // namespace offing::present

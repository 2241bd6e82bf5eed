// Presets of clouds and hulls; those of the sea are in sea_by_height_test.cpp.
#include "host/scene/schema/presets.h"

#include <cmath>
#include <set>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "host/clouds/shape/genera.h"
#include "host/scene/prepare/scene_clouds.h"
#include "host/scene/prepare/world_scene.h"
#include "tests/scene/section_text.h"

namespace offing::scene {
namespace {

using test::scene_of;

// Fails if two presets have one name, or a genus has none.
TEST(Presets, HaveNamesOfTheirOwn) {
  std::set<std::string_view> names;
  for (const Preset& preset : presets()) EXPECT_TRUE(names.insert(preset.name).second) << preset.name;
  for (const clouds::Genus genus : clouds::all_genera) {
    const std::string name(clouds::range_of(genus).name);
    EXPECT_TRUE(names.contains("cloud-" + name)) << name;
    EXPECT_TRUE(names.contains("layer-" + name)) << name;
  }
}

// Fails if a preset of a cloud or layer sets another element, another genus, leaves a height of its own, or
// makes a sky without clouds or with more than a window shows quickly.
TEST(Presets, GeneraAreOfOneElement) {
  const std::string clouds =
      "[[cloud]]\nname = \"a\"\ny_m = 77\n[[cloud]]\nname = \"b\"\ny_m = 77\nscale = 3\n";
  const std::string layers = "[[cloud_layer]]\ncoverage = 0.01\n[[cloud_layer]]\ny_m = 77\n";
  for (const Preset& preset : presets()) {
    const std::string genus(preset.name.substr(preset.name.find('-') + 1));
    if (preset.group == ParameterGroup::cloud) {
      Scene scene = scene_of(clouds);
      apply(preset, scene, {1, 0});
      EXPECT_EQ(clouds::range_of(scene.clouds[1].genus).name, genus);
      EXPECT_FALSE(scene.clouds[1].altitude_m) << genus;
      EXPECT_EQ(scene.clouds[1].scale, 1.0) << genus;
      EXPECT_EQ(scene.clouds[1].name, "b");
      EXPECT_EQ(scene.clouds[0].altitude_m, 77.0);
    }
    if (preset.group != ParameterGroup::cloud_layer) continue;
    Scene scene = scene_of(layers);
    apply(preset, scene, {1, 0});
    EXPECT_EQ(clouds::range_of(scene.cloud_layers[1].genus).name, genus);
    EXPECT_EQ(scene.cloud_layers[0].coverage, 0.01);
    scene.cloud_layers.erase(scene.cloud_layers.begin());
    const auto sky = prepare_clouds(scene);
    ASSERT_TRUE(sky) << genus;
    EXPECT_GE(sky->clouds.size(), 1u) << genus;
    EXPECT_LE(sky->clouds.size(), 200u) << genus;
  }
}

// Fails if a hull does not float, is not the body's own, or its thrust does not keep its speed: after 30 s in
// calm water within 15 %.
TEST(Presets, HullsKeepTheirSpeed) {
  const ocl::Device device = ocl::Device::open();
  for (const Preset& preset : presets()) {
    if (preset.group != ParameterGroup::body) continue;
    Scene scene = scene_of(
        "[wind]\nspeed_mps = 0.2\n[ocean]\nsize = 32\ncascade_count = 1\n[[mesh]]\nname = "
        "\"other\"\n[[mesh]]\nname = "
        "\"hull\"\nscale = 3\n[[body]]\nmesh = \"hull\"\nmass_kg = 7\n");
    const Scene before = scene;
    apply(preset, scene, {0, 0});
    EXPECT_EQ(scene.meshes[0].size_m, before.meshes[0].size_m);
    EXPECT_EQ(scene.meshes[1].scale, 1.0);
    world::World world(device, prepare_world(scene, Warnings::left_out));
    world.at(30.0, 10.0);
    const bodies::BodyPose pose = world.bodies()->pose(0, 30.0);
    const double speed_mps = std::hypot(pose.velocity_mps.x, pose.velocity_mps.z);
    EXPECT_NEAR(speed_mps, scene.bodies[0].speed_mps, 0.15 * scene.bodies[0].speed_mps + 0.05) << preset.name;
    EXPECT_GT((pose.turn * glm::dvec3(0.0, 1.0, 0.0)).y, 0.95) << preset.name << " stands upright";
  }
}

}  // namespace
}  // namespace offing::scene

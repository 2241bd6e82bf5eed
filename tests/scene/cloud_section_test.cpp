// [clouds], [[cloud_layer]], [[cloud]] and what belongs to one: what a scene file says of them, read and
// written.
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/scene/file/scene_writer.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "host/scene/schema/unused_parameters.h"
#include "tests/scene/section_text.h"

namespace offing::scene {
namespace {

using test::refusal;
using test::scene_of;

using ::testing::ElementsAre;
using ::testing::HasSubstr;

const std::string two_clouds = R"([clouds]
light = "harris"
seed = 7
quality = 0.5
[[cloud_layer]]
genus = "cirrus"
coverage = 0.25
[[cloud]]
name = "path"
y_m = { keys = [{ t = 0, value = 900 }, { t = 60, value = 1100.5 }] }
x_m = { keys = [{ t = 0, value = -50 }, { t = 60, value = 50 }], interpolation = "linear" }
extinction_per_m = 0.04
colour = [1, 0.5, 0.25]
phase = "rayleigh"
[[cloud.ball]]
x_m = -10
radius_m = 80
[[cloud.ball]]
weight = 2
[[cloud.level]]
ratio = 0.25
[[cloud.particle_edit]]
eye_m = [10, 20, 3000]
yaw_deg = 12.5
left = -0.25
top = 0.125
fate = "removed"
[[cloud.particle_edit]]
push_m = [0, 40, 0]
colour = [1, 0.5, 0.5]
[[cloud]]
genus = "stratus"
modelling = "sampled"
file = "volumes/a.vdb"
wind_mps = [8, 0, -1]
heat_k = 1.5
[[cloud.ball]]
z_m = 3
)";

// Fails if a value goes to another element than the one it was written in, or nowhere.
TEST(CloudSection, ValuesAreThoseOfTheirElement) {
  const Scene scene = scene_of(two_clouds, "scenes");
  EXPECT_EQ(scene.cloud_settings.light, clouds::LightModel::harris);
  EXPECT_EQ(scene.cloud_settings.seed, 7u);
  ASSERT_EQ(scene.cloud_layers.size(), 1u);
  EXPECT_EQ(scene.cloud_layers[0].genus, clouds::Genus::cirrus);
  EXPECT_FALSE(scene.cloud_layers[0].altitude_m);
  ASSERT_EQ(scene.clouds.size(), 2u);
  const CloudScene& first = scene.clouds[0];
  ASSERT_EQ(first.balls.size(), 2u);
  EXPECT_EQ(first.balls[0].centre_m.x, -10.0);
  EXPECT_EQ(first.balls[0].radius_m, 80.0);
  EXPECT_EQ(first.balls[1].weight, 2.0);
  ASSERT_EQ(first.levels.size(), 1u);
  EXPECT_EQ(first.levels[0].ratio, 0.25);
  ASSERT_EQ(first.edits.size(), 2u);
  EXPECT_EQ(first.edits[0].selection.eye_m, glm::dvec3(10.0, 20.0, 3000.0));
  EXPECT_EQ(first.edits[0].selection.low.x, -0.25);
  EXPECT_EQ(first.edits[0].selection.high.y, 0.125);
  EXPECT_EQ(first.edits[0].fate, clouds::ParticleFate::removed);
  EXPECT_EQ(first.edits[1].push_m.y, 40.0);
  EXPECT_EQ(first.edits[1].albedo, glm::dvec3(1.0, 0.5, 0.5));
  EXPECT_EQ(first.altitude_m, 900.0);
  EXPECT_EQ(first.look.phase, clouds::PhaseKind::rayleigh);
  EXPECT_EQ(first.look.albedo, glm::dvec3(1.0, 0.5, 0.25));
  EXPECT_EQ(scene.tracks.size(), 2u);
  EXPECT_EQ(scene.tracks.at({"cloud.y_m"}).keys[1].value, 1100.5);
  const CloudScene& second = scene.clouds[1];
  EXPECT_EQ(second.genus, clouds::Genus::stratus);
  EXPECT_EQ(second.shape.file, "scenes/volumes/a.vdb");
  EXPECT_EQ(second.motion.heat_k, 1.5);
  EXPECT_EQ(second.balls.size(), 1u);
  EXPECT_TRUE(second.levels.empty());
}

// Fails if writing and reading changes a value, or adds one that was left to the genus.
TEST(CloudSection, ComesBackAsItWas) {
  const Scene scene = scene_of(two_clouds, "scenes");
  const std::string text = scene_text(scene, "scenes");
  EXPECT_EQ(scene_text(parse_scene(text, "b.toml", "scenes"), "scenes"), text);
  const Scene back = parse_scene(text, "b.toml", "scenes");
  EXPECT_EQ(back.tracks, scene.tracks);
  for (const Parameter& row : parameter_table()) {
    EXPECT_EQ(value_text(back, row, Digits::exact), value_text(scene, row, Digits::exact)) << row.key;
  }
}

// Clouds that are given without a sea stand alone, as ground does; a bare [ocean] is kept.
TEST(CloudSection, CloudsAloneHaveNoSea) {
  EXPECT_FALSE(scene_of("[[cloud]]\n").has_sea());
  EXPECT_FALSE(scene_of("[[cloud_layer]]\n").has_sea());
  const Scene both = scene_of("[ocean]\n[[cloud]]\n");
  EXPECT_TRUE(both.has_sea());
  EXPECT_TRUE(parse_scene(scene_text(both, ""), "b.toml", "").has_sea());
}

TEST(CloudSection, RefusesWhatNoCloudHas) {
  EXPECT_THAT(refusal("[[cloud]]\n[[cloud.ball]]\nradius_m = -3\n"),
              HasSubstr("a.toml:4:12: cloud.ball.radius_m: expected a number in m within"));
  EXPECT_THAT(refusal("[[cloud]]\ngenus = \"cumulos\"\n"), HasSubstr("one of cirrus"));
  EXPECT_THAT(refusal("[[cloud]]\nextinction_per_m = nan\n"), HasSubstr("cloud.extinction_per_m"));
  EXPECT_THAT(refusal("[[cloud]]\ntarget_particles = 20000000\n"), HasSubstr("cloud.target_particles"));
  EXPECT_THAT(refusal("[[cloud_layer]]\ncoverage = 1.5\n"), HasSubstr("cloud_layer.coverage"));
  EXPECT_THAT(refusal("[[clouds]]\n"), HasSubstr("clouds"));
}

// Fails if a value that does nothing goes unsaid.
TEST(CloudSection, TellsOfValuesThatDoNothing) {
  const Scene scene = scene_of("[[cloud]]\nheat_spread = 0.5\nfluff_m = 3\ngrid = \"smoke\"\n");
  EXPECT_THAT(unused_parameters(scene),
              ElementsAre(HasSubstr("cloud.file is not given"),
                          HasSubstr("none of cloud.mesh, cloud.text and cloud.shape is given"),
                          HasSubstr("cloud.heat_k is not given")));
}

}  // namespace
}  // namespace offing::scene

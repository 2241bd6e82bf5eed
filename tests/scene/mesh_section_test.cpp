// [[light]], [[mesh]] and [[mesh.highlight]]: what a scene file says of them, read and written.
#include <string>

#include <gtest/gtest.h>

#include "host/mesh_shapes/shape_table.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "tests/scene/section_text.h"

namespace offing::scene {
namespace {

using test::refusal;
using test::scene_of;

const std::string two_meshes = R"([[light]]
name = "lamp"
kind = "place"
y_m = 4
colour = [1, 0.5, 0]
[[light]]
[[mesh]]
name = "first"
file = "models/head.ply"
colour = { keys = [{ t = 0, value = [1, 0, 0] }, { t = 2, value = [0, 0.5, 1] }], interpolation = "linear" }
[[mesh.highlight]]
light = "lamp"
nearest_m = [0, -1.5, 2e-3]
[[mesh.highlight]]
split = 3
[[mesh]]
shape = "ship"
yaw_deg = { keys = [{ t = 0, value = 350 }, { t = 4, value = 10 }] }
[[mesh]]
highlights = "off"
[[mesh.highlight]]
texture = "heart"
offset_right.keys = [{ t = 1, value = -2 }, { t = 3, value = 2.5 }]
)";

// Fails if a value of any kind goes to another element than the one it was written in, or nowhere.
TEST(MeshSection, ValuesAreThoseOfTheirElement) {
  const Scene scene = scene_of(two_meshes, "scenes");
  ASSERT_EQ(scene.lights.size(), 2u);
  EXPECT_EQ(scene.lights[0].name, "lamp");
  EXPECT_EQ(scene.lights[0].kind, LightKind::place);
  EXPECT_EQ(scene.lights[0].place_m.y, 4.0);
  EXPECT_EQ(scene.lights[0].colour, glm::dvec3(1.0, 0.5, 0.0));
  EXPECT_EQ(scene.lights[1].colour, LightScene{}.colour);
  ASSERT_EQ(scene.meshes.size(), 3u);
  EXPECT_EQ(scene.meshes[0].file, "scenes/models/head.ply");
  EXPECT_EQ(scene.meshes[1].file, "");
  EXPECT_EQ(mesh_shapes::shapes().at(scene.meshes[1].shape).name, "ship");
  EXPECT_EQ(scene.meshes[2].shown, MeshHighlights::off);
  ASSERT_EQ(scene.meshes[0].highlights.size(), 2u);
  EXPECT_EQ(scene.meshes[0].highlights[0].light, "lamp");
  EXPECT_EQ(scene.meshes[0].highlights[0].rule.nearest_m, glm::dvec3(0.0, -1.5, 2e-3));
  EXPECT_FALSE(scene.meshes[0].highlights[1].rule.nearest_m);
  EXPECT_EQ(scene.meshes[0].highlights[1].rule.controls.split, 3);
  EXPECT_TRUE(scene.meshes[1].highlights.empty());
  ASSERT_EQ(scene.meshes[2].highlights.size(), 1u);
  EXPECT_EQ(scene.meshes[2].highlights[0].rule.controls.texture, highlights::HighlightTexture::heart);
}

// Fails if keyframes of an element go to another one, if a colour loses a channel, or if the constant is not
// that of the first key.
TEST(MeshSection, KeyframesAreThoseOfTheirElement) {
  const Scene scene = scene_of(two_meshes);
  ASSERT_EQ(scene.tracks.size(), 5u);  // three of a colour, two of numbers
  const KeyframeTrack& green = scene.tracks.at({"mesh.colour", {0, 0}, 1});
  EXPECT_EQ(green.keys.back().value, 0.5);
  EXPECT_EQ(green.interpolation, Interpolation::linear);
  EXPECT_EQ(scene.meshes[0].material.colour, glm::dvec3(1.0, 0.0, 0.0));
  EXPECT_GT(scene.tracks.at({"mesh.yaw_deg", {1, 0}}).period, 6.0);
  EXPECT_EQ(scene.tracks.at({"mesh.highlight.offset_right", {2, 0}}).keys.back().value, 2.5);
  EXPECT_EQ(scene.meshes[2].highlights[0].rule.controls.offset.x, -2.0);
}

// Fails if an element, a value, keyframes or their order are lost in writing, or defaults are written.
TEST(MeshSection, ComesBackFromItsText) {
  const Scene scene = scene_of(two_meshes);
  const std::string text = scene_text(scene, "");
  const Scene again = scene_of(text.substr(text.find('\n') + 1));
  for (const Parameter& row : parameter_table()) {
    EXPECT_EQ(value_text(again, row, Digits::exact), value_text(scene, row, Digits::exact)) << row.key;
  }
  EXPECT_EQ(again.tracks, scene.tracks);
  EXPECT_EQ(scene_text(again, ""), text);
  EXPECT_EQ(text.find("squareness"), std::string::npos) << "a default was written:\n" << text;
  EXPECT_NE(text.find("[[mesh]]\nhighlights = \"off\"\n\n[[mesh.highlight]]\n"), std::string::npos) << text;
}

// Fails if meshes bring a sea, or one that the scene has is lost in writing.
TEST(MeshSection, StandsAloneWithoutASea) {
  const Scene dry = scene_of("[[mesh]]\n"), wet = scene_of("[[mesh]]\n[ocean]\n");
  EXPECT_FALSE(dry.has_sea());
  EXPECT_TRUE(wet.has_sea());
  const std::string text = scene_text(wet, "");
  EXPECT_TRUE(scene_of(text.substr(text.find('\n') + 1)).has_sea()) << text;
}

// Fails if elements behind one that is taken away lose their keyframes, or get those of another.
TEST(MeshSection, RemovedElementsTakeTheirKeyframes) {
  Scene scene = scene_of(two_meshes);
  const Section& meshes = *find_parameter("mesh.name")->section;
  const Section& highlights = *find_parameter("mesh.highlight.light")->section;
  remove_element(scene, meshes, {0, 0});
  ASSERT_EQ(scene.tracks.size(), 2u);
  EXPECT_TRUE(scene.tracks.contains({"mesh.yaw_deg", {0, 0}}));
  EXPECT_TRUE(scene.tracks.contains({"mesh.highlight.offset_right", {1, 0}}));
  EXPECT_FALSE(scene.set_at.contains({"mesh.file", {0, 0}}));
  append_element(scene, *find_parameter("mesh.highlight.light"), {});
  scene.meshes[1].highlights[1].light = "behind";
  remove_element(scene, highlights, {1, 0});
  ASSERT_EQ(scene.meshes[1].highlights.size(), 1u);
  EXPECT_EQ(scene.meshes[1].highlights[0].light, "behind");
  EXPECT_EQ(scene.tracks.size(), 1u);
}

// Fails if a fault is told without its place, or passed over. One of each kind of value.
TEST(MeshSection, FaultsAreToldWithTheirPlace) {
  const struct {
    std::string text, message;
  } cases[] = {
      {"[[mesh]]\nshape = \"cube\"\n",
       "a.toml:3:9: mesh.shape: expected one of knot, sphere, ellipsoid, torus, saddle, head, ship, bird, "
       "boat, box, cylinder, cone, bumpy, "
       "got "
       "\"cube\""},
      {"[[mesh]]\nname = \"\"\n", "a.toml:3:8: mesh.name: expected a name, got \"\""},
      {"[[mesh]]\nfile = 3\n", "a.toml:3:8: mesh.file: expected a file name, got 3"},
      {"[[mesh]]\ndetail = 1.5\n",
       "a.toml:3:10: mesh.detail: expected a whole number within [0, 5], got 1.5"},
      {"[[mesh]]\ncolour = [1, 0]\n",
       "a.toml:3:10: mesh.colour: expected a list of three numbers within [0, 1], got [1, 0]"},
      {"[[mesh]]\ncolour = [1, 0, 2]\n",
       "a.toml:3:10: mesh.colour: expected a list of three numbers within [0, 1], got [1, 0, 2]"},
      {"[[mesh]]\ncolour = 0.5\n",
       "a.toml:3:10: mesh.colour: expected a list of three numbers within [0, 1], got 0.5"},
      {"[[mesh]]\ncolour = { keys = [{ t = 0, value = 1 }] }\n",
       "a.toml:3:37: mesh.colour: expected a list of three numbers within [0, 1], got 1"},
      {"[[mesh]]\nscale = { keys = [{ t = 0, value = 1 }] }\n",
       "a.toml:3:9: mesh.scale: expected one value, got keyframes, which it cannot have"},
      {"[[mesh]]\n[[mesh.highlight]]\nopacity = 1.5\n",
       "a.toml:4:11: mesh.highlight.opacity: expected a number within [0, 1], got 1.5"},
      {"[[mesh]]\n[[mesh.highlight]]\npin_m = [0, 0, 0]\nnearest_m = [0, 0, 0]\n",
       "a.toml:5:1: mesh.highlight.nearest_m: expected either pin_m or nearest_m, found both"},
      {"[[mesh]]\n[mesh.highlight]\nopacity = 1\n",
       "a.toml:3:7: mesh.highlight: expected a section [[mesh.highlight]], got a table"},
      {"[[mesh.highlight]]\nopacity = 1\n", "a.toml:2:3: mesh: expected a section [[mesh]], got a table"},
      {"[mesh]\n", "a.toml:2:2: mesh: expected a section [[mesh]], got a table"},
      {"[[light]]\ncolor = [1, 1, 1]\n", "a.toml:3:1: light.color: expected a known key, got \"color\""},
      {"[[light]]\nkind = \"spot\"\n",
       "a.toml:3:8: light.kind: expected one of direction, place, got \"spot\""},
  };
  for (const auto& [text, message] : cases) EXPECT_EQ(refusal(text), message);
}

// Fails if more elements are taken than there may be.
TEST(MeshSection, HoldsItsLimits) {
  std::string text = "[[mesh]]\n";
  for (int i = 0; i < 257; ++i) text += "[[mesh.highlight]]\n";
  EXPECT_EQ(refusal(text), "a.toml:259:1: mesh.highlight: expected at most 256 sections, found more");
}

}  // namespace
}  // namespace offing::scene

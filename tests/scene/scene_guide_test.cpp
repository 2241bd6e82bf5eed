// docs/scenes.md and docs/reference/scene_keys.md say what scenes can hold.
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/schema/key_tables.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::scene {
namespace {

std::string text_of(const char* file) {
  std::ifstream stream(file);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string read_guide() {
  return text_of(OFFING_SCENE_GUIDE);
}

// Fails if the reference of keys is not that of the program. To make it anew: OFFING_WRITE_GUIDE=1
// scene_tests
// --gtest_filter=SceneGuide*.
TEST(SceneGuide, ListsEveryKey) {
  const std::string expected = key_page(parameter_table());
  if (std::getenv("OFFING_WRITE_GUIDE")) std::ofstream(OFFING_SCENE_KEYS) << expected;
  EXPECT_EQ(text_of(OFFING_SCENE_KEYS), expected);
}

/// The first example below a heading.
Scene example_below(const std::string& heading) {
  const std::string guide = read_guide();
  const std::size_t start = guide.find("version = 1\n", guide.find(heading)), end = guide.find("\n```", start);
  return parse_scene(guide.substr(start, end - start), "scenes.md", "");
}

// Fails if the guide's examples are no scenes.
TEST(SceneGuide, ItsExamplesAreScenes) {
  const Scene scene = example_below("# Scenes");
  EXPECT_EQ(scene.ocean.swells.size(), 2u);
  EXPECT_EQ(scene.ocean.raindrops.size(), 1u);
  EXPECT_EQ(scene.tracks.size(), 2u);
  EXPECT_TRUE(scene.view.sun_time_utc);
  EXPECT_TRUE(example_below("## The ground").terrain.is_given);
  const Scene head = example_below("## Meshes");
  ASSERT_EQ(head.meshes.size(), 2u);
  EXPECT_EQ(head.meshes[0].highlights.size(), 2u);
  EXPECT_EQ(head.tracks.size(), 5u);
  EXPECT_EQ(mesh_rules_at(head, 0.0)[0][1].light, 0);
  const Scene sky = example_below("## Clouds");
  EXPECT_EQ(sky.cloud_layers.size(), 1u);
  ASSERT_EQ(sky.clouds.size(), 1u);
  EXPECT_EQ(sky.clouds[0].balls.size(), 2u);
}

// Fails if the guide does not say what a key of a file reads.
TEST(SceneGuide, NamesEveryKeyOfAFile) {
  const std::string guide = read_guide();
  const std::string section = guide.substr(guide.find("## Scenes from strangers"));
  for (const Parameter& row : parameter_table()) {
    if (row.rule != ParameterRule::file_name) continue;
    EXPECT_LT(section.find(fmt::format("`{}`", row.key)), section.find("## Benchmarks")) << row.key;
  }
}

}  // namespace
}  // namespace offing::scene

// docs/scenes.md lists what scenes can say.
#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::scene {
namespace {

const std::string end_of_prose = "make it anew. -->\n";

std::string read_guide() {
  std::ifstream stream(OFFING_SCENE_GUIDE);
  return {std::istreambuf_iterator<char>(stream), {}};
}

std::string motion_text(const Parameter& row) {
  return row.motion == ParameterMotion::constant ? ""
         : row.motion == ParameterMotion::keyed  ? "keys"
                                                 : "keys, turn";
}

std::string_view section_of(const Parameter& row) {
  return row.key.substr(0, row.key.rfind('.'));
}

/// One table a section, in the order of their first rows.
std::string key_tables() {
  std::vector<std::string_view> sections;
  for (const Parameter& row : parameter_table()) {
    if (std::find(sections.begin(), sections.end(), section_of(row)) == sections.end())
      sections.push_back(section_of(row));
  }
  std::string text;
  for (const std::string_view section : sections) {
    std::string lines;
    bool is_repeated = false;
    for (const Parameter& row : parameter_table()) {
      if (section_of(row) != section) continue;
      is_repeated = row.max_count > 1;
      lines += fmt::format("| `{}` | {} | {} | {} | {} |\n", row.key.substr(section.size() + 1),
                           expected_text(row), default_text(row), motion_text(row), row.help);
    }
    text += fmt::format(fmt::runtime(is_repeated ? "\n### `[[{}]]`\n\n" : "\n### `[{}]`\n\n"), section);
    text += "| key | value | default | moves | |\n|---|---|---|---|---|\n" + lines;
  }
  return text;
}

// Fails if the guide's tables are not those of the program. To make them anew: OFFING_WRITE_GUIDE=1
// scene_tests
// --gtest_filter=SceneGuide*.
TEST(SceneGuide, ListsEveryKey) {
  const std::string guide = read_guide();
  const std::size_t prose = guide.find(end_of_prose);
  ASSERT_NE(prose, std::string::npos);
  const std::string expected = guide.substr(0, prose + end_of_prose.size()) + key_tables();
  if (std::getenv("OFFING_WRITE_GUIDE")) std::ofstream(OFFING_SCENE_GUIDE) << expected;
  EXPECT_EQ(read_guide(), expected);
}

/// The example between two headings.
Scene example_between(const std::string& heading, const std::string& next) {
  const std::string guide = read_guide();
  const std::size_t start = guide.find("    version = 1\n", guide.find(heading)), end = guide.find(next);
  return parse_scene(guide.substr(start, end - start), "scenes.md", "");
}

// Fails if the guide's examples are no scenes.
TEST(SceneGuide, ItsExamplesAreScenes) {
  const Scene scene = example_between("# Scenes", "\n## Keyframes");
  EXPECT_EQ(scene.ocean.swells.size(), 1u);
  EXPECT_EQ(scene.ocean.raindrops.size(), 1u);
  EXPECT_EQ(scene.tracks.size(), 2u);
  EXPECT_TRUE(scene.view.sun_time_utc);
  EXPECT_TRUE(example_between("## The ground", "\n## Meshes").terrain.is_given);
  const Scene head = example_between("## Meshes", "\n## Clouds");
  ASSERT_EQ(head.meshes.size(), 2u);
  EXPECT_EQ(head.meshes[0].highlights.size(), 2u);
  EXPECT_EQ(head.tracks.size(), 5u);
  EXPECT_EQ(mesh_rules_at(head, 0.0)[0][1].light, 0);
  const Scene sky = example_between("## Clouds", "\n## Scenes from strangers");
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

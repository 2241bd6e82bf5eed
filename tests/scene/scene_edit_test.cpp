#include "host/scene/file/scene_edit.h"

#include <filesystem>
#include <functional>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "host/io/whole_file.h"
#include "host/scene/file/scene_file.h"

namespace offing::scene {
namespace {

/// Comments, odd order, blank lines, indents and text that is not ASCII.
const std::string written = R"(# Sturm über der Bucht – ein Versuch
version = 1   # always

[[light]]   # the lantern
    name = "Laterne – é"
    colour = [ 1, 0.5,
               0.25 ]  # warm
# the second one
[[light]]
name = "zweite"

[wind]  # before the sea

speed_mps = 12.50  # ö: a comment with "quotes"
[ocean.swell2]
)";

std::string usable() {
  return written.substr(0, written.find("[ocean.swell2]")) +
         "\n[[ocean.swell]]\namplitude_m = 1\nperiod_s = 11 # s\n\n# last words\n";
}

std::optional<std::string> edited(const std::string& text, const std::function<void(Scene&)>& edit) {
  Scene scene = parse_scene(text, "a.toml", "");
  edit(scene);
  return edited_scene_text(text, "", scene, "");
}

std::string replaced(std::string text, const std::string& before, const std::string& now) {
  const std::size_t at = text.find(before);
  EXPECT_NE(at, std::string::npos) << before;
  return text.replace(at, before.size(), now);
}

// Fails if saving without an edit changes a byte.
TEST(SceneEdit, KeepsTextWithoutAnEdit) {
  EXPECT_EQ(edited(usable(), [](Scene&) {}), usable());
}

// Fails if a shipped scene does not survive loading and saving byte for byte.
TEST(SceneEdit, KeepsEveryShippedScene) {
  int count = 0;
  for (const auto& entry : std::filesystem::directory_iterator(OFFING_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    const std::string text =
        read_whole_file(entry.path(), {.kind = "a scene file", .most_bytes = most_scene_bytes});
    const std::filesystem::path folder = entry.path().parent_path();
    EXPECT_EQ(edited_scene_text(text, folder, parse_scene(text, "a.toml", folder), folder), text)
        << entry.path();
    ++count;
  }
  EXPECT_GE(count, 20);
}

// Fails if an edit changes more than the text of its value.
TEST(SceneEdit, ReplacesAValueAlone) {
  EXPECT_EQ(edited(usable(), [](Scene& scene) { scene.wind.wind_speed_mps = 7.25; }),
            replaced(usable(), "12.50", "7.25"));
  EXPECT_EQ(edited(usable(),
                   [](Scene& scene) {
                     scene.lights[0].colour = {1.0, 0.0, 0.25};
                   }),
            replaced(usable(), "[ 1, 0.5,\n               0.25 ]", "[1, 0, 0.25]"));
  EXPECT_EQ(edited(usable(), [](Scene& scene) { scene.lights[0].name = "Größe"; }),
            replaced(usable(), "Laterne – é", "Größe"));
}

// Fails if a new value does not follow the last one of its section, with its indent, or a new section is
// lost.
TEST(SceneEdit, AddsValuesAndSections) {
  EXPECT_EQ(edited(usable(), [](Scene& scene) { scene.wind.wind_direction_rad = 0.5; }),
            replaced(usable(), "with \"quotes\"\n", "with \"quotes\"\ndirection_deg = 28.64788975654116\n"));
  EXPECT_EQ(edited(usable(), [](Scene& scene) { scene.time.end_s = 9.0; }),
            usable() + "\n[time]\nend_s = 9\n");
  EXPECT_EQ(edited("version = 1\nwind = { speed_mps = 5 } # x\n",
                   [](Scene& scene) { scene.wind.wind_direction_rad = 0.5; }),
            "version = 1\nwind = { speed_mps = 5, direction_deg = 28.64788975654116 } # x\n");
}

// Fails if removing the first element changes the others, or leaves its comment.
TEST(SceneEdit, RemovesElements) {
  std::string without_second = usable();
  const std::size_t second = without_second.find("# the second one");
  without_second.erase(second, without_second.find("[wind]") - second);
  EXPECT_EQ(edited(usable(), [](Scene& scene) { scene.lights.pop_back(); }), without_second);
  std::string without_first = usable();
  const std::size_t first = without_first.find("[[light]]");
  without_first.erase(first, without_first.find("# the second one") - first);
  EXPECT_EQ(edited(usable(), [](Scene& scene) { scene.lights.erase(scene.lights.begin()); }), without_first);
}

// Fails if a new element does not stand beside its like.
TEST(SceneEdit, AddsElements) {
  EXPECT_EQ(edited(usable(),
                   [](Scene& scene) {
                     scene.lights.emplace_back();
                     scene.lights.back().name = "dritte";
                   }),
            replaced(usable(), "[wind]", "[[light]]\nname = \"dritte\"\n\n[wind]"));
}

// Fails if an absent value keeps its line.
TEST(SceneEdit, RemovesAbsentValues) {
  EXPECT_EQ(edited(usable(), [](Scene& scene) { scene.ocean.swells[0].period_s.reset(); }),
            replaced(usable(), "period_s = 11 # s\n", ""));
}

// Fails if lines that are added end otherwise than those of the file.
TEST(SceneEdit, KeepsLineEnds) {
  EXPECT_EQ(edited("version = 1\r\n[wind]\r\nspeed_mps = 5\r\n",
                   [](Scene& scene) { scene.wind.wind_direction_rad = 0.0625; }),
            "version = 1\r\n[wind]\r\nspeed_mps = 5\r\ndirection_deg = 3.580986219567645\r\n");
}

// Fails if text is taken apart that cannot be edited.
TEST(SceneEdit, RefusesValuesOutsideTheirSection) {
  EXPECT_EQ(
      edited("version = 1\nwind.speed_mps = 5\n", [](Scene& scene) { scene.wind.wind_direction_rad = 0.5; }),
      std::nullopt);
  EXPECT_EQ(
      edited("version = 1\nwind.speed_mps = 5\n", [](Scene& scene) { scene.wind.wind_speed_mps = 6.0; }),
      "version = 1\nwind.speed_mps = 6\n");
}

}  // namespace
}  // namespace offing::scene

// What windows remember of their looks, and the search over values.
#include "present/panels/look.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <set>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "host/scene/schema/parameter_table.h"
#include "present/panels/panels.h"
#include "present/panels/parameter_widget.h"
#include "present/panels/value_search.h"
#include "tests/io/temporary_folder.h"

namespace offing::present {
namespace {

// Fails if a look is not read as it was written, or a file that somebody has spoiled makes panels unusable.
TEST(LookTest, IsReadAsWritten) {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "state" / "look";
  EXPECT_EQ(read_look(file), Look{});
  const Look look{.theme = Theme::light,
                  .text_scale = 1.5f,
                  .panel_em = 31.25f,
                  .window = {.width = 900, .height = 501, .is_maximised = true}};
  write_look(file, look);
  EXPECT_EQ(read_look(file), look);
  std::ofstream(file)
      << "theme pink\ntext_scale 1e9\npanel_em none\nwindow_width 3\nwindow_height -9\nwhat 3";
  const Look spoiled = read_look(file);
  EXPECT_EQ(spoiled.theme, Theme::dark);
  EXPECT_EQ(spoiled.text_scale, text_scales.back());
  EXPECT_EQ(spoiled.panel_em, Look{}.panel_em);
  EXPECT_EQ(spoiled.window.width, 200);
  EXPECT_EQ(spoiled.window.height, WindowExtent{}.height);
  write_look({}, look);
  write_look("/proc/nonexistent/look", look);
}

// Fails if a label is a raw key, repeats the unit, or two values of a section have the same.
TEST(ParameterLabelTest, AreWords) {
  std::map<std::string, std::set<std::string>> labels;
  for (const scene::Parameter& row : scene::parameter_table()) {
    const std::string words = words_of(row);
    EXPECT_EQ(words.find('_'), std::string::npos) << row.key;
    EXPECT_FALSE(words.empty()) << row.key;
    EXPECT_TRUE(labels[std::string(scene::section_of(row.key))].insert(words).second) << row.key << words;
  }
  const auto words = [](const char* key) { return words_of(*scene::find_parameter(key)); };
  EXPECT_EQ(words("wind.speed_mps"), "speed");
  EXPECT_EQ(words("ocean.hs_m"), "wave height");
  EXPECT_EQ(words("mesh.spin_deg_per_s"), "spin");
  EXPECT_EQ(words("camera.fov_deg"), "field of view");
}

// Fails if a value is not found by words of its panel, name or key, or by others.
TEST(ValueSearchTest, FindsByAllWords) {
  const scene::Parameter& speed = *scene::find_parameter("wind.speed_mps");
  EXPECT_TRUE(is_found("speed", "Wind", speed));
  EXPECT_TRUE(is_found(" WIND spe", "Wind", speed));
  EXPECT_TRUE(is_found("wind.speed_mps", "Wind", speed));
  EXPECT_FALSE(is_found("wind speed direction", "Wind", speed));
  EXPECT_FALSE(is_found("  ", "Wind", speed));
  EXPECT_FALSE(is_found("everything", "Wind", speed));
  EXPECT_TRUE(is_found_in_help("everything", "Wind", speed));
  EXPECT_FALSE(is_found("windy speeds", "Wind", speed));
  EXPECT_TRUE(is_found_alike("windy speeds", "Wind", speed));
  EXPECT_FALSE(is_found_alike("windy waves", "Wind", speed));
  EXPECT_FALSE(is_found_alike("  ", "Wind", speed));
}

// Fails if words that a newcomer looks for find nothing.
TEST(ValueSearchTest, FindsWhatValuesAreAbout) {
  const auto finds = [](const char* wanted, scene::ParameterGroup group) {
    return std::ranges::any_of(scene::parameter_table(), [&](const scene::Parameter& row) {
      const auto panels = group_panels();
      const auto panel = std::ranges::find(panels, row.group, &GroupPanel::group);
      return row.group == group && is_found(wanted, fmt::format("{} {}", panel->title, panel->words), row);
    });
  };
  EXPECT_TRUE(finds("time of day", scene::ParameterGroup::sun));
  EXPECT_TRUE(finds("waves", scene::ParameterGroup::sea));
  EXPECT_TRUE(finds("boat", scene::ParameterGroup::body));
  EXPECT_TRUE(finds("geotiff", scene::ParameterGroup::height_map));
  EXPECT_TRUE(finds("wind", scene::ParameterGroup::wind));
  EXPECT_FALSE(finds("boat", scene::ParameterGroup::wind));
}

}  // namespace
}  // namespace offing::present

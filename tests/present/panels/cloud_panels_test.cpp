// The panels of clouds, as panel_edits_test.cpp has it of the others: clouds are made anew after each row.
#include <algorithm>
#include <array>

#include "tests/present/panels/panel_edits.h"

namespace offing::test {
namespace {

class CloudPanelsTest : public PanelEdits, public testing::WithParamInterface<present::GroupPanel> {};

// Fails as PanelEdits::expect_what_a_fresh_start_shows() says.
TEST_P(CloudPanelsTest, ShowWhatAFreshStartShows) {
  expect_what_a_fresh_start_shows({GetParam()});
}

/// All but that of clouds themselves, whose rows go by parts.
std::vector<present::GroupPanel> panels_of_clouds() {
  std::vector<present::GroupPanel> panels;
  for (const present::GroupPanel& panel : present::group_panels()) {
    if (is_of_clouds(panel.group) && panel.group != scene::ParameterGroup::cloud) panels.push_back(panel);
  }
  return panels;
}

INSTANTIATE_TEST_SUITE_P(Panels, CloudPanelsTest, testing::ValuesIn(panels_of_clouds()), panel_name);

/// What all rows of a cloud would take longer than ten minutes for; and of a file, a mesh, a text and a shape
/// a cloud has one only.
struct CloudPart {
  const char* name;
  std::string_view first, last;
};
constexpr std::array parts{CloudPart{"Place", "cloud.name", "cloud.base_m"},
                           CloudPart{"File", "cloud.file", "cloud.up"},
                           CloudPart{"Mesh", "cloud.mesh", "cloud.mesh"},
                           CloudPart{"Text", "cloud.text", "cloud.text"},
                           CloudPart{"Shape", "cloud.shape", "cloud.shape"},
                           CloudPart{"Form", "cloud.yaw_deg", "cloud.fluff_m"},
                           CloudPart{"Noise", "cloud.noise_wavelength_m", "cloud.noise_change_per_s"},
                           CloudPart{"Look", "cloud.extinction_per_m", "cloud.droplet_um"},
                           CloudPart{"Motion", "cloud.wind_mps", "cloud.obstacle_radius_m"},
                           CloudPart{"Heat", "cloud.heat_k", "cloud.heat_condensing_m"}};

class CloudRowsTest : public PanelEdits, public testing::WithParamInterface<CloudPart> {};

// Fails as PanelEdits::expect_what_a_fresh_start_shows() says.
TEST_P(CloudRowsTest, ShowWhatAFreshStartShows) {
  const auto panels = present::group_panels();
  const auto panel = std::ranges::find(panels, scene::ParameterGroup::cloud, &present::GroupPanel::group);
  ASSERT_NE(panel, panels.end());
  expect_what_a_fresh_start_shows({*panel, GetParam().first, GetParam().last});
}

INSTANTIATE_TEST_SUITE_P(Parts, CloudRowsTest, testing::ValuesIn(parts),
                         [](const auto& part) { return part.param.name; });

// Fails if a row of clouds belongs to no part.
TEST(CloudPartsTest, HoldEveryRow) {
  std::size_t part = 0;
  bool is_open = false;
  for (const scene::Parameter& row : scene::parameter_table()) {
    if (row.group != scene::ParameterGroup::cloud) continue;
    ASSERT_LT(part, parts.size()) << row.key;
    if (!is_open) {
      EXPECT_EQ(row.key, parts[part].first);
    }
    is_open = row.key != parts[part].last;
    if (!is_open) ++part;
  }
  EXPECT_EQ(part, parts.size());
}

}  // namespace
}  // namespace offing::test

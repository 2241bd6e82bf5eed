// The panels of clouds, as panel_edits_test.cpp has it of the others: clouds are made anew after each row.
#include "tests/present/panel_edits.h"

namespace offing::test {
namespace {

class CloudPanelsTest : public PanelEdits, public testing::WithParamInterface<present::GroupPanel> {};

// Fails as PanelEdits::expect_what_a_fresh_start_shows() says.
TEST_P(CloudPanelsTest, ShowWhatAFreshStartShows) {
  expect_what_a_fresh_start_shows(GetParam());
}

/// All but that of clouds themselves, whose forty rows take longer than ten minutes.
std::vector<present::GroupPanel> panels_of_clouds() {
  std::vector<present::GroupPanel> panels;
  for (const present::GroupPanel& panel : present::group_panels()) {
    if (is_of_clouds(panel.group) && panel.group != scene::ParameterGroup::cloud) panels.push_back(panel);
  }
  return panels;
}

INSTANTIATE_TEST_SUITE_P(Panels, CloudPanelsTest, testing::ValuesIn(panels_of_clouds()), panel_name);

}  // namespace
}  // namespace offing::test

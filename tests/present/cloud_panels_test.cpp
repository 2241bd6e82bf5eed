// The panels of clouds, as panel_edits_test.cpp has it of the others: clouds are made anew after each row.
#include "tests/present/panel_edits.h"

namespace offing::test {
namespace {

class CloudPanelsTest : public PanelEdits, public testing::WithParamInterface<present::GroupPanel> {};

// Fails as PanelEdits::expect_what_a_fresh_start_shows() says.
TEST_P(CloudPanelsTest, ShowWhatAFreshStartShows) {
  expect_what_a_fresh_start_shows(GetParam());
}

/// Forty rows, or clouds that take a minute to be made after a pull: too long even for a slow test.
bool is_long(const present::GroupPanel& panel) {
  return panel.group == scene::ParameterGroup::cloud || panel.group == scene::ParameterGroup::cloud_layer;
}

std::vector<present::GroupPanel> panels_of_clouds() {
  std::vector<present::GroupPanel> panels;
  for (const present::GroupPanel& panel : present::group_panels()) {
    if (panel.group >= scene::ParameterGroup::clouds && !is_long(panel)) panels.push_back(panel);
  }
  return panels;
}

INSTANTIATE_TEST_SUITE_P(Panels, CloudPanelsTest, testing::ValuesIn(panels_of_clouds()),
                         [](const auto& panel) {
                           std::string name = panel.param.title;
                           std::erase(name, ' ');
                           return name;
                         });

}  // namespace
}  // namespace offing::test

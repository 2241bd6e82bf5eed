// The panels of wakes, meshes, lights and floating bodies, as panel_edits_test.cpp has it of the others: what
// they edit has a history, or is looked at for long before it is shown.
#include "tests/present/panels/panel_edits.h"

namespace offing::test {
namespace {

class WorldPanelsTest : public PanelEdits, public testing::WithParamInterface<present::GroupPanel> {};

// Fails as PanelEdits::expect_what_a_fresh_start_shows() says. Bodies are put back to their start, at the
// time that is shown, with each edit: at time 0 that is what a fresh start does.
TEST_P(WorldPanelsTest, ShowWhatAFreshStartShows) {
  expect_what_a_fresh_start_shows({GetParam()});
}

std::vector<present::GroupPanel> panels_of_world() {
  std::vector<present::GroupPanel> panels;
  for (const present::GroupPanel& panel : present::group_panels()) {
    if (is_of_world(panel.group)) panels.push_back(panel);
  }
  return panels;
}

INSTANTIATE_TEST_SUITE_P(Panels, WorldPanelsTest, testing::ValuesIn(panels_of_world()), panel_name);

}  // namespace
}  // namespace offing::test

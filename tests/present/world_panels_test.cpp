// The panels of wakes, meshes and lights, as panel_edits_test.cpp has it of the others: what they
// edit has a history, or is looked at for long before it is shown.
#include "tests/present/panel_edits.h"

namespace offing::test {
namespace {

using scene::ParameterGroup;

class WorldPanelsTest : public PanelEdits, public testing::WithParamInterface<present::GroupPanel> {};

// Fails as PanelEdits::expect_what_a_fresh_start_shows() says; of meshes and their highlights, which go by
// degrees from where they were before an edit, as expect_edits().
TEST_P(WorldPanelsTest, ShowWhatAFreshStartShows) {
  if (GetParam().group == ParameterGroup::highlight || GetParam().group == ParameterGroup::mesh) {
    expect_edits(GetParam());
  } else {
    expect_what_a_fresh_start_shows(GetParam());
  }
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

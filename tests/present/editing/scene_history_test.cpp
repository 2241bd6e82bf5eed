#include "present/editing/scene_history.h"

#include <gtest/gtest.h>

namespace offing::present {
namespace {

scene::Scene windy(double speed_mps) {
  scene::Scene scene;
  scene.wind.wind_speed_mps = speed_mps;
  return scene;
}

// Fails if a step is lost or taken twice, or if what was undone comes back after another edit.
TEST(SceneHistoryTest, StepsGoBackAndForth) {
  SceneHistory history(windy(1.0));
  EXPECT_FALSE(history.undo());
  EXPECT_FALSE(history.redo());
  history.note(windy(2.0));
  history.note(windy(3.0));
  EXPECT_FALSE(history.can_redo());
  EXPECT_EQ(history.undo()->wind.wind_speed_mps, 2.0);
  EXPECT_EQ(history.undo()->wind.wind_speed_mps, 1.0);
  EXPECT_FALSE(history.undo());
  EXPECT_TRUE(history.can_redo());
  EXPECT_EQ(history.redo()->wind.wind_speed_mps, 2.0);
  history.note(windy(4.0));
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(history.undo()->wind.wind_speed_mps, 2.0);
  EXPECT_EQ(history.redo()->wind.wind_speed_mps, 4.0);
}

// Fails if a step is named after another one.
TEST(SceneHistoryTest, SaysWhatItGoesBackOver) {
  SceneHistory history(windy(1.0));
  EXPECT_EQ(history.undo_words(), "");
  history.note(windy(2.0));
  scene::Scene dark = windy(2.0);
  dark.view.sun_direction.elevation_rad = 0.1;
  history.note(dark);
  EXPECT_EQ(history.redo_words(), "");
  EXPECT_EQ(history.undo_words(), "Sun: elevation");
  history.undo();
  EXPECT_EQ(history.undo_words(), "Wind: speed");
  EXPECT_EQ(history.redo_words(), "Sun: elevation");
  history.undo();
  EXPECT_EQ(history.redo_words(), "Wind: speed");
  history.redo();
  EXPECT_EQ(history.undo_words(), "Wind: speed");
}

// Fails if what was taken back comes back by redo, or takes the edit before with it.
TEST(SceneHistoryTest, NothingIsLeftOfWhatIsTakenBack) {
  SceneHistory history(windy(1.0));
  history.note(windy(2.0));
  history.note(windy(3.0));
  history.take_back();
  EXPECT_EQ(history.now().wind.wind_speed_mps, 2.0);
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(history.undo()->wind.wind_speed_mps, 1.0);
}

// A day of edits must not fill the memory: the last hundred can be undone.
TEST(SceneHistoryTest, HoldsAHundredSteps) {
  SceneHistory history(windy(0.0));
  for (int i = 1; i <= 150; ++i) history.note(windy(0.1 * i));
  int steps = 0;
  while (history.undo()) ++steps;
  EXPECT_EQ(steps, 100);
}

}  // namespace
}  // namespace offing::present

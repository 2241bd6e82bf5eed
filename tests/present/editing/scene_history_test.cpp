#include "present/editing/scene_history.h"

#include <cstddef>
#include <functional>
#include <vector>

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
  EXPECT_TRUE(history.take_out([](const auto&, const auto&) { return true; }));
  EXPECT_EQ(history.now().wind.wind_speed_mps, 2.0);
  EXPECT_FALSE(history.redo());
  EXPECT_EQ(history.undo()->wind.wind_speed_mps, 1.0);
}

// Fails if an edit that is taken out takes later ones with it, comes back by undo or redo, or leaves what it
// added.
TEST(SceneHistoryTest, LaterEditsOutliveOneThatIsTakenOut) {
  SceneHistory history(windy(1.0));
  const auto edit = [&](const std::function<void(scene::Scene&)>& change) {
    scene::Scene scene = history.now();
    change(scene);
    history.note(scene);
  };
  edit([](scene::Scene& scene) { scene.lakes.emplace_back().x_m = 1.0; });
  edit([](scene::Scene& scene) {  // the one to go
    scene.lakes.emplace_back().x_m = 2.0;
    scene.lakes[0].level_m = 9.0;
    scene.terrain.is_given = true;
    scene.terrain.origin_x_m = 5.0;
    scene.tracks[{"sun.elevation_deg", {}}] = {.keys = {{0.0, 0.1}, {5.0, 0.2}}};
  });
  edit([](scene::Scene& scene) { scene.lakes[1].wind_speed_mps = 7.0; });
  edit([](scene::Scene& scene) { scene.lakes.emplace_back().x_m = 3.0; });
  edit([](scene::Scene& scene) { scene.wind.wind_speed_mps = 2.0; });
  edit([](scene::Scene& scene) { scene.wind.wind_speed_mps = 3.0; });
  history.undo();
  const auto went = history.take_out([](const scene::Scene& before, const scene::Scene& after) {
    return before.terrain.is_given != after.terrain.is_given;
  });
  ASSERT_TRUE(went);
  EXPECT_EQ(went->before.lakes.size(), 1u);
  EXPECT_EQ(went->after.lakes.size(), 2u);
  const auto expect_without = [](const scene::Scene& scene, double wind_speed_mps, std::size_t lakes) {
    EXPECT_EQ(scene.wind.wind_speed_mps, wind_speed_mps);
    ASSERT_EQ(scene.lakes.size(), lakes);
    const std::vector<double> places_m{1.0, 3.0};
    for (std::size_t i = 0; i < lakes; ++i) EXPECT_EQ(scene.lakes[i].x_m, places_m[i]);
    EXPECT_FALSE(scene.terrain.is_given);
    EXPECT_FALSE(scene.terrain.origin_x_m);
    EXPECT_TRUE(scene.tracks.empty());
  };
  expect_without(history.now(), 2.0, 2);
  expect_without(*history.redo(), 3.0, 2);
  history.undo();
  expect_without(*history.undo(), 1.0, 2);
  expect_without(*history.undo(), 1.0, 1);
  expect_without(*history.undo(), 1.0, 1);  // without the wind of the lake that went
  expect_without(*history.undo(), 1.0, 0);
  EXPECT_FALSE(history.can_undo());
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

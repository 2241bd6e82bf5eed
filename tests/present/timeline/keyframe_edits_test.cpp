#include "present/timeline/keyframe_edits.h"

#include <gtest/gtest.h>

namespace offing::present {
namespace {

Tracks two_tracks() {
  return {{{"camera.x_m"}, {.keys = {{0.0, 1.0}, {2.0, 5.0}, {4.0, 2.0}}}},
          {{"camera.yaw_deg"}, {.keys = {{0.0, 0.0}, {2.0 + 1e-9, 1.0}}}}};
}

// Fails if a keyframe is not found, or those of one time count as several.
TEST(KeyframeEditsTest, KnowsTimes) {
  const Tracks tracks = two_tracks();
  EXPECT_EQ(key_times(tracks).size(), 3u);
  EXPECT_EQ(key_after(tracks, 0.0), 2.0);
  EXPECT_EQ(key_after(tracks, 1.0), 2.0);
  EXPECT_FALSE(key_after(tracks, 4.0));
  EXPECT_EQ(key_before(tracks, 2.0), 0.0);
  EXPECT_EQ(key_before(tracks, 9.0), 4.0);
  EXPECT_FALSE(key_before(tracks, 0.0));
  EXPECT_EQ(values_with_keys(tracks, 2.0), "camera x (east), camera yaw");
  EXPECT_EQ(values_with_keys(tracks, 4.0), "camera x (east)");
}

// Fails if keyframes of another time move, one of this time stays, a value changes, or one passes its
// neighbour.
TEST(KeyframeEditsTest, MovesAllOfATime) {
  const Tracks tracks = two_tracks();
  const Tracks moved = with_moved_keys(tracks, 2.0, 3.0, 0.1);
  EXPECT_EQ(moved.at({"camera.x_m"}).keys, (std::vector<Keyframe>{{0.0, 1.0}, {3.0, 5.0}, {4.0, 2.0}}));
  EXPECT_EQ(moved.at({"camera.yaw_deg"}).keys, (std::vector<Keyframe>{{0.0, 0.0}, {3.0, 1.0}}));
  EXPECT_EQ(with_moved_keys(tracks, 2.0, 9.0, 0.1).at({"camera.yaw_deg"}).keys[1].time_s, 3.9);
  EXPECT_EQ(with_moved_keys(tracks, 2.0, -9.0, 0.1).at({"camera.x_m"}).keys[1].time_s, 0.1);
  EXPECT_EQ(with_moved_keys(tracks, 4.0, 9.0, 0.1).at({"camera.x_m"}).keys[2].time_s, 9.0);
  EXPECT_EQ(with_moved_keys(tracks, 2.0, 3.0, 2.5), tracks) << "there is no room for a frame on both sides";
}

}  // namespace
}  // namespace offing::present

// [[bookmark]]: views of a scene to come back to.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "host/scene/schema/parameter_table.h"

namespace offing::scene {
namespace {

using ::testing::HasSubstr;

constexpr const char* two = R"(version = 1

[[bookmark]]
name = "Bug, 뱃머리"
x_m = 12.5
y_m = 3
z_m = -40
yaw_deg = 200
pitch_deg = -10
roll_deg = 5
fov_deg = 30

[[bookmark]]
)";

// Fails if a bookmark is read as another view, or one without a word is not the camera's usual one.
TEST(BookmarkSection, IsRead) {
  const Scene scene = parse_scene(two, "a.toml", "");
  ASSERT_EQ(scene.bookmarks.size(), 2u);
  const BookmarkScene& bow = scene.bookmarks[0];
  EXPECT_EQ(bow.name, "Bug, 뱃머리");
  EXPECT_EQ(bow.camera.eye_m, glm::dvec3(12.5, 3.0, -40.0));
  EXPECT_NEAR(bow.camera.yaw_rad, 3.490658503988659, 1e-15);
  EXPECT_NEAR(bow.camera.pitch_rad, -0.17453292519943295, 1e-16);
  EXPECT_NEAR(bow.camera.roll_rad, 0.08726646259971647, 1e-16);
  EXPECT_NEAR(bow.camera.vertical_field_of_view_rad, 0.5235987755982988, 1e-15);
  const Camera usual = Scene{}.view.camera, other = scene.bookmarks[1].camera;
  EXPECT_EQ(other.eye_m, usual.eye_m);
  EXPECT_EQ(other.pitch_rad, usual.pitch_rad);
  EXPECT_EQ(other.vertical_field_of_view_rad, usual.vertical_field_of_view_rad);
}

// Fails if a bookmark is lost or changed by being saved.
TEST(BookmarkSection, IsWrittenAsItWasRead) {
  const std::string text = scene_text(parse_scene(two, "a.toml", ""), "");
  EXPECT_EQ(text, two);
  EXPECT_EQ(scene_text(parse_scene(text, "b.toml", ""), ""), text);
}

// Fails if a bookmark can be where the camera cannot, or the other way round.
TEST(BookmarkSection, HasTheRangesOfTheCamera) {
  int count = 0;
  for (const Parameter& row : parameter_table()) {
    if (row.group != ParameterGroup::bookmark || row.key == "bookmark.name") continue;
    ++count;
    const Parameter* camera = find_parameter("camera." + std::string(name_of(row.key)));
    ASSERT_NE(camera, nullptr) << row.key;
    EXPECT_EQ(row.low, camera->low) << row.key;
    EXPECT_EQ(row.high, camera->high) << row.key;
    EXPECT_EQ(row.scale, camera->scale) << row.key;
    EXPECT_EQ(row.unit, camera->unit) << row.key;
    EXPECT_EQ(row.motion, ParameterMotion::constant) << row.key;
  }
  EXPECT_EQ(count, 7);
}

// Fails if a fault in one is not told with its place.
TEST(BookmarkSection, FaultsAreTold) {
  try {
    parse_scene("version = 1\n[[bookmark]]\npitch_deg = 91\n", "a.toml", "");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.toml:3:13: bookmark.pitch_deg: expected a number in deg within"));
  }
}

}  // namespace
}  // namespace offing::scene

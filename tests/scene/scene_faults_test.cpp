// Several faults of one scene file.
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"

namespace offing::scene {
namespace {

// Tables are read in the order of their keys. Fails if the first fault of the file is not the first that is
// reported, if one is reported twice, or if more than ten are.
TEST(SceneFaults, TheFirstTenAreReportedInOrder) {
  std::string text =
      "version = 1\n[wind]\nspeed_mps = 200\n[ocean]\nsizes = 64\nwind_speed_mps = 0\n"
      "[[ocean.swell]]\nperiod_s = 8\nwavelength_m = 80\n[sky]\nozone = 3\n[camera]\n"
      "y_m = { keys = [{ t = 0, value = 1e9 }] }\n";
  for (int i = 0; i < 7; ++i) text += "[[light]]\nx_m = \"left\"\n";
  try {
    parse_scene(text, "storm.toml", "");
    FAIL() << "accepted";
  } catch (const ErrorList& list) {
    std::vector<std::string> places;
    for (const Error& error : list.errors()) {
      const std::string what = error.what();
      places.push_back(what.substr(0, what.find(" expected")));
    }
    EXPECT_EQ(std::string(list.what()), list.errors().front().what());
    EXPECT_THAT(
        places,
        testing::ElementsAre(
            "storm.toml:3:13: wind.speed_mps:", "storm.toml:5:1: ocean.sizes:",
            "storm.toml:6:18: ocean.wind_speed_mps:", "storm.toml:9:1: ocean.swell.wavelength_m:",
            "storm.toml:11:1: sky.ozone:", "storm.toml:13:34: camera.y_m:", "storm.toml:15:7: light.x_m:",
            "storm.toml:17:7: light.x_m:", "storm.toml:19:7: light.x_m:", "storm.toml:21:7: light.x_m:"));
  }
}

}  // namespace
}  // namespace offing::scene

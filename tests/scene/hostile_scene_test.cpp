// Scenes that somebody, or a failing disk, has spoiled.
#include <random>
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/moving_view.h"
#include "host/scene/scene_file.h"
#include "host/scene/scene_meshes.h"

namespace offing::scene {
namespace {

// A valid scene with every kind of value and section.
const std::string valid = R"(version = 1
[world]
seed = 42
latitude_deg = -33.9
[time]
fps = 30
[wind]
speed_mps = 12.5
[camera]
y_m = { keys = [{ t = 0, value = 5 }, { t = 2.5, value = 8 }], interpolation = "linear" }
yaw_deg.keys = [{ t = 0, value = 350 }, { t = 9, value = 10 }]
[sun]
time_utc = 2024-06-21T12:30:00+01:00
time_scale = 60
[sky]
ozone_du = 280
[render]
exposure_ev = -0.5
[ocean]
spectrum = "tma"
size = 64
spectrum_file = "buoy.data_spec"
[[ocean.cascade]]
patch_m = 300
[[ocean.swell]]
period_s = 11
direction_deg = 30
[[ocean.raindrop]]
x_m = 2.5
amplitude_m = -0.01
[[light]]
name = "lamp"
colour = { keys = [{ t = 0, value = [1, 0.5, 0] }, { t = 2, value = [0, 0, 1] }] }
[[mesh]]
shape = "head"
colour = [0.5, 0.25, 0]
[[mesh.highlight]]
light = "lamp"
nearest_m = [0, 1, 2]
opacity = { keys = [{ t = 0, value = 0 }, { t = 2, value = 1 }] }
[[mesh.highlight]]
texture = "star"
)";

// What comes of a text: "" for a scene that can be shown, else the message. Anything but Error fails.
std::string outcome(const std::string& text) {
  try {
    const OceanScene scene = parse_scene(text, "a.toml", "");
    view_at(scene, 1.0);
    lamps_at(scene, 1.0);
    mesh_materials_at(scene, 1.0);
    mesh_rules_at(scene, 1.0);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_FALSE(error.hint().empty());
    return error.what();
  }
}

// Fails if a spoiled scene crashes, hangs, throws anything but our error, or is refused without line and
// column. 20,000 scenes with one to four bytes, words or lines changed, doubled, moved or lost; the seed is
// fixed.
TEST(HostileScene, IsReadOrRefusedWithItsPlace) {
  ASSERT_EQ(outcome(valid), "");
  const std::string words[] = {"nan",
                               "-inf",
                               "1e999",
                               "[[",
                               "]]",
                               "{",
                               "}",
                               "\"",
                               "\0\x01",
                               "\n",
                               "keys",
                               "t",
                               "value",
                               "=",
                               "[",
                               "99999999999999999999",
                               "true",
                               "\xff\xfe",
                               "2024-13-45T99:99:99Z",
                               "ocean.swell",
                               "'''",
                               "\\u0000"};
  const std::regex place("a\\.toml:[0-9]+:[0-9]+: [^]*");
  std::mt19937 random(11);
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  int refused = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    std::string text = valid;
    for (std::size_t change = 0; change <= below(4) && !text.empty(); ++change) {
      const std::size_t at = below(text.size()), length = below(30);
      switch (below(5)) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, length);
          break;
        case 2:
          text.insert(at, text.substr(below(text.size()), length));
          break;
        case 3:
          text.insert(at, words[below(std::size(words))]);
          break;
        default:
          text.resize(at + 1);
      }
    }
    const std::string message = outcome(text);
    refused += message.empty() ? 0 : 1;
    ASSERT_TRUE(message.empty() || std::regex_match(message, place)) << message << "\n" << text;
    ASSERT_LT(message.size(), 600u) << message;
  }
  EXPECT_GT(refused, 10'000);  // most changes break something; some fall into numbers
  EXPECT_LT(refused, 20'000);
}

// Fails if many keyframes or elements take more than time in proportion, or more than there may be are taken.
TEST(HostileScene, HoldsItsLimits) {
  const auto keys = [](int count) {
    std::string text = "version = 1\n[camera]\nx_m.keys = [";
    for (int i = 0; i < count; ++i) text += "{ t = " + std::to_string(i) + ", value = 1 },";
    return text + "]\n";
  };
  EXPECT_EQ(outcome(keys(10'000)), "");
  EXPECT_EQ(outcome(keys(10'001)), "a.toml:3:1: camera.x_m: expected 1 ... 10000 keys, found 10001");
}

}  // namespace
}  // namespace offing::scene

#include "host/scene/file/scene_writer.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/schema/parameter_table.h"
#include "tests/io/temporary_folder.h"

namespace offing::scene {
namespace {

// Every value of the table, to the last bit.
void expect_same_values(const Scene& found, const Scene& expected) {
  for (const Parameter& row : parameter_table()) {
    EXPECT_EQ(value_text(found, row, Digits::exact), value_text(expected, row, Digits::exact)) << row.key;
  }
}

// A scene with every row set to something that is not its default: the example where there is one, else a
// place in the range that no short decimal hits, else the last choice.
Scene unusual_scene() {
  Scene scene;
  for (const Parameter& row : parameter_table()) {
    const Place place{.subject = std::string(row.key), .assignment = ""};
    WrittenValue written{.value = row.low + (row.high - row.low) / 3.0, .shown = ""};
    if (const auto* choice = std::get_if<ChoiceStorage>(&row.storage)) {
      written.value = std::string(choice->names.back());
    } else if (row.rule == ParameterRule::power_of_two) {
      written.value = std::int64_t{128};
    } else if (std::holds_alternative<ValueAt<int>>(row.storage) ||
               std::holds_alternative<ValueAt<std::uint64_t>>(row.storage)) {
      written.value = std::max(std::int64_t{2}, static_cast<std::int64_t>(row.low) + 1);
    } else if (std::holds_alternative<ValueAt<glm::dvec3>>(row.storage)) {
      written.value = std::vector<double>{row.low, row.low + (row.high - row.low) / 3.0, row.high};
    } else if (!row.example.empty()) {
      written = read_flag_value(row, row.example);
    }
    // Of two rows that say the same a section takes one.
    if (!row.instead_of.empty()) continue;
    store(scene, row, written, place);
    if (std::holds_alternative<ValueAt<std::vector<double>>>(row.storage))
      store(scene, row, {.value = row.low + 1.0 / 3.0, .shown = ""}, place);
  }
  return scene;
}

// Fails if a kind of value is not written, or not so that it reads back.
TEST(SceneWriter, EveryValueComesBack) {
  const Scene scene = unusual_scene();
  expect_same_values(parse_scene(scene_text(scene, ""), "again.toml", ""), scene);
}

// Fails if elements of a repeated section get each other's values, or values that they do not have.
TEST(SceneWriter, KeepsElementsApart) {
  const std::string text =
      "version = 1\n[[ocean.swell]]\namplitude_m = 0.8\nperiod_s = 11\n"
      "[[ocean.swell]]\n[[ocean.swell]]\nwavelength_m = 250\ndirection_deg = 30\n";
  const Scene scene = parse_scene(text, "a.toml", "");
  ASSERT_EQ(scene.ocean.swells.size(), 3u);
  expect_same_values(parse_scene(scene_text(scene, ""), "again.toml", ""), scene);
}

// Fails if more sections are written than can be read back.
TEST(SceneWriter, RefusesMoreThanCanBeReadBack) {
  Scene scene;
  scene.clouds.emplace_back().balls.resize(find_parameter("cloud.ball.radius_m")->max_count);
  EXPECT_EQ(parse_scene(scene_text(scene, ""), "again.toml", "").clouds[0].balls.size(),
            scene.clouds[0].balls.size());
  scene.clouds[0].balls.emplace_back();
  EXPECT_THROW(scene_text(scene, ""), Error);
  scene.clouds[0].balls.assign(find_parameter("cloud.ball.radius_m")->max_count,
                               {{1.0 / 3.0, 2.0 / 3.0, 4.0 / 3.0}});
  scene.clouds.resize(8, scene.clouds[0]);
  const TemporaryFolder folder;
  EXPECT_THROW(save_scene(scene, folder.path() / "large.toml", Existing::keep), Error);
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "large.toml"));
}

// Fails if keyframes are lost, moved, or go another way.
TEST(SceneWriter, KeyframesComeBack) {
  const Scene scene = parse_scene(
      "version = 1\n[camera]\nx_m = { keys = [{ t = -0.1, value = 3 }, { t = 1e7, value = 4.7 }] }\n"
      "yaw_deg = { keys = [{ t = 0, value = 350 }, { t = 1, value = -20.3 }], interpolation = \"linear\" }\n"
      "[sun]\nelevation_deg.keys = [{ t = 3, value = 30 }]\n",
      "a.toml", "");
  const std::string text = scene_text(scene, "");
  EXPECT_NE(text.find("x_m = { keys = [{ t = -0.1, value = 3 }, { t = 10000000, value = 4.7 }] }"),
            std::string::npos)
      << text;
  const Scene again = parse_scene(text, "again.toml", "");
  ASSERT_EQ(again.tracks.size(), scene.tracks.size());
  for (const auto& [key, track] : scene.tracks) {
    const KeyframeTrack& found = again.tracks.at(key);
    EXPECT_EQ(found.interpolation, track.interpolation) << key.key;
    EXPECT_EQ(found.period, track.period) << key.key;
    ASSERT_EQ(found.keys.size(), track.keys.size()) << key.key;
    for (std::size_t i = 0; i < track.keys.size(); ++i) {
      EXPECT_EQ(found.keys[i].time_s, track.keys[i].time_s) << key.key;
      EXPECT_EQ(found.keys[i].value, track.keys[i].value) << key.key;
    }
  }
  EXPECT_EQ(scene_text(again, ""), text);
}

// Fails if a scene in which a program has set what says the same twice cannot be read back, or means another
// sun or swell then: the date counts, and the wavelength.
TEST(SceneWriter, WritesWhatCounts) {
  Scene scene = parse_scene("version = 1\n[sun]\ntime_utc = 2024-06-21T12:30:05+01:00\n", "a.toml", "");
  scene.view.sun_direction.azimuth_rad = 2.0;
  scene.ocean.swells = {{.wavelength_m = 50.0, .period_s = 4.0}, {.period_s = 5.0}};
  const Scene again = parse_scene(scene_text(scene, ""), "again.toml", "");
  EXPECT_EQ(again.view.sun_time_utc, (UtcTime{2024, 6, 21, 11, 30, 5}));
  EXPECT_EQ(again.view.sun_direction.azimuth_rad, Scene{}.view.sun_direction.azimuth_rad);
  EXPECT_EQ(again.ocean.swells[0].wavelength_m, 50.0);
  EXPECT_FALSE(again.ocean.swells[0].period_s);
  EXPECT_EQ(again.ocean.swells[1].period_s, 5.0);
}

// Fails if defaults are written out, which would keep a scene from following better ones.
TEST(SceneWriter, LeavesDefaultsOut) {
  EXPECT_EQ(scene_text(Scene{}, ""), "version = 1\n");
}

// Fails if numbers are not written as people do where that is exact: degrees are kept as radians.
TEST(SceneWriter, WritesNumbersAsPeopleDo) {
  const Scene scene = parse_scene(
      "version = 1\n[wind]\nspeed_mps = 8.7\ndirection_deg = 30\n[[ocean.cascade]]\npatch_m = 250.1\n",
      "a.toml", "");
  EXPECT_EQ(
      scene_text(scene, ""),
      "version = 1\n\n[wind]\nspeed_mps = 8.7\ndirection_deg = 30\n\n[[ocean.cascade]]\npatch_m = 250.1\n");
}

// Fails if a file name is not found from the new file's folder, or breaks its quotes.
TEST(SceneWriter, NamesFilesFromItsFolder) {
  Scene scene;
  scene.ocean.spectrum_file = "/data/buoys/odd \"name\\.data_spec";
  const std::string text = scene_text(scene, "/data/scenes");
  EXPECT_NE(text.find("../buoys/"), std::string::npos) << text;
  const Scene again = parse_scene(text, "a.toml", "/data/scenes");
  EXPECT_EQ(std::filesystem::path(again.ocean.spectrum_file).lexically_normal(), scene.ocean.spectrum_file);
}

// Fails if a file name is whole where it need not be: a scene and its spectrum could not move together.
TEST(SceneWriter, NamesFilesFromTheCurrentFolder) {
  const TemporaryFolder folder;
  const std::filesystem::path before = std::filesystem::current_path();
  std::filesystem::current_path(folder.path());
  std::filesystem::create_directory("buoys");
  std::ofstream("buoys/a.data_spec") << "a";
  Scene scene;
  for (const std::filesystem::path& file :
       {std::filesystem::path("buoys/a.data_spec"), std::filesystem::absolute("buoys/a.data_spec")}) {
    scene.ocean.spectrum_file = file.string();
    const std::string text = scene_text(scene, "");
    EXPECT_NE(text.find("\"buoys/a.data_spec\""), std::string::npos) << text;
    const std::string beside = scene_text(scene, "scenes");
    EXPECT_NE(beside.find("\"../buoys/a.data_spec\""), std::string::npos) << beside;
  }
  std::filesystem::current_path(before);
}

// Fails if a name that no file can have ends a program: with another exception than Error.
TEST(SceneWriter, RefusesNamesThatNoFileCanHave) {
  const TemporaryFolder folder;
  for (const Existing existing : {Existing::keep, Existing::replace}) {
    EXPECT_THROW(save_scene({}, folder.path() / (std::string(300, 'x') + ".toml"), existing), Error);
    EXPECT_THROW(save_scene({}, folder.path() / "missing" / "a.toml", existing), Error);
  }
}

// Fails if a file is lost that the user did not want to replace, or another kind of file is written.
TEST(SceneWriter, ReplacesOnlyWhatItMay) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "sea.toml";
  const auto bytes = [&] {
    std::ifstream stream(file);
    return std::string(std::istreambuf_iterator<char>(stream), {});
  };
  Scene scene;
  save_scene(scene, file, Existing::keep);
  scene.wind.wind_speed_mps = 20.0;
  EXPECT_THROW(save_scene(scene, file, Existing::keep), Error);
  EXPECT_EQ(bytes(), scene_text(Scene{}, folder.path()));
  save_scene(scene, file, Existing::replace);
  EXPECT_EQ(bytes(), scene_text(scene, folder.path()));
  EXPECT_THROW(save_scene(scene, folder.path() / "sea.png", Existing::keep), Error);
}

}  // namespace
}  // namespace offing::scene

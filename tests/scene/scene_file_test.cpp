#include "host/scene/file/scene_file.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing::scene {
namespace {

struct Refusal {
  std::string what;
  std::string hint;
};

Refusal refusal_of(const std::string& text) {
  try {
    parse_scene(text, "storm.toml", "");
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    return {error.what(), error.hint()};
  }
  return {"accepted", ""};
}

// Fails if a documented key is not read, or goes to the wrong place.
TEST(SceneFile, ReadsEveryKindOfValue) {
  const Scene scene = parse_scene(R"(version = 1
[world]
seed = 42
[time]
fps = 30
loop_period_s = 20.0
[wind]
speed_mps = 12.5
direction_deg = 180
[ocean]
spectrum = "tma"
depth_m = 20
size = 64
spectrum_file = "data/buoy.data_spec"
record = 3
[[ocean.cascade]]
patch_m = 300
[[ocean.cascade]]
patch_m = 40.5
[ocean.foam]
decay_s = 3.5
[ocean.gerstner]
count = 16
split_wavelength_m = 45
)",
                                  "storm.toml", "scenes");
  EXPECT_EQ(scene.world.seed, 42u);
  EXPECT_EQ(scene.time.frames_per_second, 30.0);
  EXPECT_EQ(scene.time.loop_period_s, 20.0);
  EXPECT_EQ(scene.wind.wind_speed_mps, 12.5);
  EXPECT_NEAR(scene.wind.wind_direction_rad, 3.14159265358979, 1e-13);
  EXPECT_EQ(scene.ocean.spectrum.model, ocean::SpectrumModel::tma);
  EXPECT_EQ(scene.ocean.depth_m, 20.0);
  EXPECT_EQ(scene.ocean.parameters.size, 64);
  EXPECT_EQ(scene.ocean.spectrum_file, "scenes/data/buoy.data_spec");  // relative to the scene file
  EXPECT_EQ(scene.ocean.record, 3);
  EXPECT_EQ(scene.ocean.patch_lengths_m, (std::vector<double>{300.0, 40.5}));
  EXPECT_EQ(scene.ocean.parameters.foam.decay_s, 3.5);
  EXPECT_EQ(scene.ocean.gerstner_count, 16);
  EXPECT_EQ(scene.ocean.gerstner_split_m, 45.0);
}

// Fails if swells or raindrops are not read, run into each other, or lose their defaults.
TEST(SceneFile, ReadsWavesBesideTheSpectrum) {
  const Scene scene = parse_scene(R"(version = 1
[[ocean.swell]]
amplitude_m = 1.5
period_s = 12
direction_deg = 90
[[ocean.swell]]
wavelength_m = 80
phase_deg = 180
[[ocean.raindrop]]
x_m = 3
z_m = -4
time_s = 0.5
amplitude_m = -0.02
wavelength_m = 0.3
decay_s = 2
[[ocean.raindrop]]
)",
                                  "storm.toml", "");
  ASSERT_EQ(scene.ocean.swells.size(), 2u);
  EXPECT_EQ(scene.ocean.swells[0].amplitude_m, 1.5);
  EXPECT_EQ(scene.ocean.swells[0].period_s, 12.0);
  EXPECT_FALSE(scene.ocean.swells[0].wavelength_m);
  EXPECT_NEAR(scene.ocean.swells[0].direction_rad, 1.5707963267948966, 1e-15);
  EXPECT_EQ(scene.ocean.swells[0].phase_rad, 0.0);
  EXPECT_EQ(scene.ocean.swells[1].amplitude_m, 0.5);
  EXPECT_EQ(scene.ocean.swells[1].wavelength_m, 80.0);
  EXPECT_FALSE(scene.ocean.swells[1].period_s);
  EXPECT_NEAR(scene.ocean.swells[1].phase_rad, 3.141592653589793, 1e-15);
  ASSERT_EQ(scene.ocean.raindrops.size(), 2u);
  EXPECT_EQ(scene.ocean.raindrops[0].x_m, 3.0);
  EXPECT_EQ(scene.ocean.raindrops[0].z_m, -4.0);
  EXPECT_EQ(scene.ocean.raindrops[0].time_s, 0.5);
  EXPECT_EQ(scene.ocean.raindrops[0].amplitude_m, -0.02);
  EXPECT_EQ(scene.ocean.raindrops[0].wavelength_m, 0.3);
  EXPECT_EQ(scene.ocean.raindrops[0].decay_s, 2.0);
  EXPECT_EQ(scene.ocean.raindrops[1].wavelength_m, ocean::Raindrop{}.wavelength_m);
}

// Fails if an absolute file name is bent to the scene's folder.
TEST(SceneFile, KeepsAbsoluteNames) {
  const Scene scene =
      parse_scene("version = 1\n[ocean]\nspectrum_file = \"/data/buoy.spec\"\n", "a.toml", "scenes");
  EXPECT_EQ(scene.ocean.spectrum_file, "/data/buoy.spec");
}

// Fails if an empty scene is not the default sea.
TEST(SceneFile, DefaultsNeedNoKeys) {
  const Scene scene = parse_scene("version = 1", "a.toml", "");
  EXPECT_EQ(scene.ocean.parameters.size, Scene{}.ocean.parameters.size);
  EXPECT_TRUE(scene.ocean.patch_lengths_m.empty());
}

// Fails if a key that was renamed no longer works, or works beside its new name.
TEST(SceneFile, EarlierKeysStillWork) {
  const Scene scene = parse_scene(
      "version = 1\n[clouds]\nsoft_puffs = \"wisps\"\n[[cloud]]\npuffs = \"soft\"\n", "a.toml", "");
  EXPECT_EQ(scene.cloud_settings.soft_billboards, "wisps");
  EXPECT_EQ(scene.clouds[0].look.billboards, clouds::BillboardSet::soft);
  try {
    parse_scene("version = 1\n[[cloud]]\npuffs = \"soft\"\nbillboards = \"soft\"\n", "a.toml", "");
    ADD_FAILURE() << "both were taken";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(),
                 "a.toml:4:1: cloud.billboards: expected either puffs or billboards, found both");
  }
}

struct BadScene {
  const char* name;
  const char* text;
  const char* what;
  const char* hint;
};

class BadScenes : public testing::TestWithParam<BadScene> {};

// Each fails if the fault is accepted, or its place, key, expectation or fix is not told.
TEST_P(BadScenes, AreRefusedWithPlaceAndHint) {
  const Refusal refusal = refusal_of(GetParam().text);
  if (GetParam().what != nullptr) {
    EXPECT_EQ(refusal.what, GetParam().what);
  }
  EXPECT_EQ(refusal.hint, GetParam().hint);
}

INSTANTIATE_TEST_SUITE_P(
    Faults, BadScenes,
    testing::Values(
        BadScene{
            "wrong_type", "version = 1\n[ocean]\nwind_speed_mps = \"17 kn\"\n",
            "storm.toml:3:18: ocean.wind_speed_mps: expected a number in m/s within [0.1, 60], got \"17 kn\"",
            "write wind_speed_mps = 10"},
        BadScene{"out_of_range", "version = 1\n[ocean]\ndepth_m = -5\n",
                 "storm.toml:3:11: ocean.depth_m: expected a number in m within [0.1, 12000], got -5",
                 "write depth_m = 0.1"},
        BadScene{"not_finite", "version = 1\n[wind]\nspeed_mps = nan\n",
                 "storm.toml:3:13: wind.speed_mps: expected a number in m/s within [0.1, 60], got nan",
                 "write speed_mps = 10"},
        BadScene{"infinite", "version = 1\n[wind]\nspeed_mps = inf\n",
                 "storm.toml:3:13: wind.speed_mps: expected a number in m/s within [0.1, 60], got inf",
                 "write speed_mps = 60"},
        BadScene{"real_for_whole", "version = 1\n[ocean]\nsize = 512.0\n",
                 "storm.toml:3:8: ocean.size: expected a power of two within [16, 4096], got 512.0",
                 "write size = 512"},
        BadScene{"boolean", "version = 1\n[ocean]\ngamma = true\n",
                 "storm.toml:3:9: ocean.gamma: expected a number within [1, 20], got true",
                 "write gamma = 3.3"},
        BadScene{"too_large", "version = 1\n[wind]\nspeed_mps = 200\n",
                 "storm.toml:3:13: wind.speed_mps: expected a number in m/s within [0.1, 60], got 200",
                 "write speed_mps = 60"},
        BadScene{"no_power_of_two", "version = 1\n[ocean]\nsize = 1500\n",
                 "storm.toml:3:8: ocean.size: expected a power of two within [16, 4096], got 1500",
                 "write size = 1024"},
        BadScene{"real_for_count", "version = 1\n[ocean.gerstner]\ncount = 12.4\n",
                 "storm.toml:3:9: ocean.gerstner.count: expected a whole number within [0, 64], got 12.4",
                 "write count = 12"},
        BadScene{"misspelt_choice", "version = 1\n[[cloud]]\ngenus = \"cumulonimbis\"\n", nullptr,
                 "write genus = \"cumulonimbus\""},
        BadScene{"date", "version = 1\n[ocean]\ngamma = 1979-05-27\n",
                 "storm.toml:3:9: ocean.gamma: expected a number within [1, 20], got 1979-05-27",
                 "write gamma = 3.3"},
        BadScene{"choice", "version = 1\n[ocean]\nspectrum = \"jonswop\"\n",
                 "storm.toml:3:12: ocean.spectrum: expected one of phillips, pm, jonswap, tma, swell, got "
                 "\"jonswop\"",
                 "write spectrum = \"jonswap\""},
        BadScene{"unknown_key", "version = 1\n[ocean]\nwind_sped_mps = 3\n",
                 "storm.toml:3:1: ocean.wind_sped_mps: expected a known key, got \"wind_sped_mps\"",
                 "did you mean wind_speed_mps?"},
        BadScene{"key_of_another_section", "version = 1\n[ocean]\npatch_m = 300\n",
                 "storm.toml:3:1: ocean.patch_m: expected a known key, got \"patch_m\"",
                 "patch_m belongs in [[ocean.cascade]] or [terrain.canopy]"},
        BadScene{"key_of_other_sections", "version = 1\ndirection_deg = 30\n",
                 "storm.toml:2:1: direction_deg: expected a known key, got \"direction_deg\"",
                 "direction_deg belongs in [wind] or [[ocean.swell]]"},
        BadScene{"misspelt_key_of_another_section", "version = 1\n[sun]\nexposure_evs = 1\n",
                 "storm.toml:3:1: sun.exposure_evs: expected a known key, got \"exposure_evs\"",
                 "did you mean exposure_ev in [render]?"},
        BadScene{"quoted_time_without_zone", "version = 1\n[sun]\ntime_utc = \"2024-06-21T12:00\"\n",
                 "storm.toml:3:12: sun.time_utc: expected a time in UTC of the years 1900 ... 2100, got "
                 "\"2024-06-21T12:00\" without a zone",
                 "add a Z, which means UTC: time_utc = \"2024-06-21T12:00Z\""},
        BadScene{"unknown_section", "version = 1\n[oceann]\nsize = 64\n",
                 "storm.toml:2:2: oceann: expected a known key, got \"oceann\"", "did you mean ocean?"},
        BadScene{"unknown_nested", "version = 1\n[[ocean.cascade]]\npatch = 3\n",
                 "storm.toml:3:1: ocean.cascade.patch: expected a known key, got \"patch\"",
                 "did you mean patch_m?"},
        BadScene{"body_as_a_table", "version = 1\n[body]\ndraught_m = 3\n",
                 "storm.toml:2:2: body: expected a section [[body]], got a table",
                 "write [[body]] on a line of its own and its keys below"},
        BadScene{"wake_as_a_table", "version = 1\n[ocean.wake]\nsize = 16\n",
                 "storm.toml:2:8: ocean.wake: expected a section [[ocean.wake]], got a table",
                 "write [[ocean.wake]] on a line of its own and its keys below"},
        BadScene{"swell_value", "version = 1\n[[ocean.swell]]\nperiod_s = 0\n",
                 "storm.toml:3:12: ocean.swell.period_s: expected a number in s within [0.3, 120], got 0",
                 "write period_s = 0.3"},
        BadScene{"swell_key", "version = 1\n[[ocean.swell]]\nperoid_s = 8\n",
                 "storm.toml:3:1: ocean.swell.peroid_s: expected a known key, got \"peroid_s\"",
                 "did you mean period_s?"},
        BadScene{"swell_said_twice", "version = 1\n[[ocean.swell]]\nwavelength_m = 80\nperiod_s = 8\n",
                 "storm.toml:4:1: ocean.swell.period_s: expected either period_s or wavelength_m, found both",
                 "remove one of them"},
        BadScene{"swell_said_twice_the_other_way",
                 "version = 1\n[[ocean.swell]]\nperiod_s = 8\nwavelength_m = 80\n",
                 "storm.toml:4:1: ocean.swell.wavelength_m: expected either period_s or wavelength_m, found "
                 "both",
                 "remove one of them"},
        BadScene{"swell_not_repeated", "version = 1\n[ocean.swell]\nperiod_s = 3\n",
                 "storm.toml:2:8: ocean.swell: expected a section [[ocean.swell]], got a table",
                 "write [[ocean.swell]] on a line of its own and its keys below"},
        BadScene{
            "raindrop_type", "version = 1\n[[ocean.raindrop]]\nx_m = \"left\"\n",
            "storm.toml:3:7: ocean.raindrop.x_m: expected a number in m within [-10000000, 10000000], got "
            "\"left\"",
            "write x_m = 0"},
        BadScene{"gerstner_count", "version = 1\n[ocean.gerstner]\ncount = 65\n",
                 "storm.toml:3:9: ocean.gerstner.count: expected a whole number within [0, 64], got 65",
                 "write count = 64"},
        BadScene{"gerstner_key", "version = 1\n[ocean.gerstner]\nlimit_m = 65\n",
                 "storm.toml:3:1: ocean.gerstner.limit_m: expected a known key, got \"limit_m\"",
                 "known here: count, split_wavelength_m"},
        BadScene{"keyframes_of_a_constant",
                 "version = 1\n[ocean]\ngamma = { keys = [{ t = 0, value = 1 }] }\n",
                 "storm.toml:3:9: ocean.gamma: expected one value, got keyframes, which it cannot have",
                 "write one constant value; keyframes are for ocean.wake, ocean.wake.hull, camera, render, "
                 "sun, sky, light, mesh, "
                 "mesh.highlight, body, cloud"},
        BadScene{"keyframes_of_a_constant_beside_others",
                 "version = 1\n[sun]\ntime_scale = { keys = [{ t = 0, value = 1 }] }\n",
                 "storm.toml:3:14: sun.time_scale: expected one value, got keyframes, which it cannot have",
                 "write one constant value; keyframes are for sun.azimuth_deg, sun.elevation_deg"},
        BadScene{"keyframe_times_fall",
                 "version = 1\n[camera]\ny_m = { keys = [{ t = 2, value = 3 }, { t = 1, value = 4 }] }\n",
                 "storm.toml:3:45: camera.y_m: t: expected a time after 2, the time of the key before, got 1",
                 "write the keys in order of time"},
        BadScene{
            "keyframe_twice",
            "version = 1\n[camera]\ny_m = { keys = [{ t = 2, value = 3 }, { t = 2.0, value = 4 }] }\n",
            "storm.toml:3:45: camera.y_m: t: expected a time after 2, the time of the key before, got 2.0",
            "remove one of the two keys"},
        BadScene{"keyframe_time", "version = 1\n[camera]\ny_m.keys = [{ t = \"now\", value = 3 }]\n",
                 "storm.toml:3:19: camera.y_m: t: expected a time in s within [-1e+08, 1e+08], got \"now\"",
                 "write t = 2.5"},
        BadScene{"keyframe_time_not_finite", "version = 1\n[camera]\ny_m.keys = [{ t = nan, value = 3 }]\n",
                 "storm.toml:3:19: camera.y_m: t: expected a time in s within [-1e+08, 1e+08], got nan",
                 "write t = 2.5"},
        BadScene{"keyframe_value",
                 "version = 1\n[camera]\ny_m.keys = [{ t = 0, value = 3 }, { t = 1, value = -4e5 }]\n",
                 "storm.toml:3:52: camera.y_m: expected a number in m within [-12000, 50000], got -400000.0",
                 "write value = -12000"},
        BadScene{"keyframe_without_value", "version = 1\n[camera]\ny_m.keys = [{ t = 0 }]\n",
                 "storm.toml:3:13: camera.y_m: expected a key of t and value, got a table",
                 "write keys = [{ t = 0, value = 1 }, { t = 2, value = 3 }]"},
        BadScene{"keyframe_key", "version = 1\n[camera]\ny_m.keys = [{ t = 0, valu = 3 }]\n",
                 "storm.toml:3:22: camera.y_m: expected keys of keyframes, got \"valu\"",
                 "did you mean value?"},
        BadScene{"keyframe_of_numbers", "version = 1\n[camera]\ny_m.keys = [1, 2]\n",
                 "storm.toml:3:13: camera.y_m: expected a key { t = ..., value = ... }, got 1",
                 "write keys = [{ t = 0, value = 1 }, { t = 2, value = 3 }]"},
        BadScene{"keyframes_not_listed", "version = 1\n[camera]\ny_m.keys = 3\n",
                 "storm.toml:3:12: camera.y_m: expected a list of keys, got 3",
                 "write keys = [{ t = 0, value = 1 }, { t = 2, value = 3 }]"},
        BadScene{"keyframes_empty", "version = 1\n[camera]\ny_m = { keys = [] }\n",
                 "storm.toml:3:7: camera.y_m: expected 1 ... 10000 keys, found 0",
                 "write keys = [{ t = 0, value = 1 }, { t = 2, value = 3 }]"},
        BadScene{"keyframe_interpolation",
                 "version = 1\n[camera]\ny_m = { keys = [{ t = 0, value = 3 }], interpolation = \"fast\" }\n",
                 "storm.toml:3:56: camera.y_m: interpolation: expected one of smooth, linear, got \"fast\"",
                 "write interpolation = \"smooth\""},
        BadScene{"keyframes_option",
                 "version = 1\n[camera]\ny_m = { keys = [{ t = 0, value = 3 }], interpolate = \"linear\" }\n",
                 "storm.toml:3:40: camera.y_m: expected keys of keyframes, got \"interpolate\"",
                 "did you mean interpolation?"},
        BadScene{"table_without_keys", "version = 1\n[camera]\ny_m = { value = 3 }\n",
                 "storm.toml:3:7: camera.y_m: expected a number in m within [-12000, 50000], got a table",
                 "write y_m = 5"},
        BadScene{"sun_said_twice", "version = 1\n[sun]\nazimuth_deg = 3\ntime_utc = 2024-06-21T12:00:00Z\n",
                 "storm.toml:4:1: sun.time_utc: expected either azimuth_deg or time_utc, found both",
                 "remove one of them"},
        BadScene{"sun_time_of_no_zone", "version = 1\n[sun]\ntime_utc = 2024-06-21T12:00:00\n",
                 "storm.toml:3:12: sun.time_utc: expected a time in UTC of the years 1900 ... 2100, got "
                 "2024-06-21T12:00:00 without a zone",
                 "add a Z, which means UTC: time_utc = 2024-06-21T12:00:00Z"},
        BadScene{"sun_time_of_no_day", "version = 1\n[sun]\ntime_utc = \"2024-06-31T12:00Z\"\n",
                 "storm.toml:3:12: sun.time_utc: expected a time in UTC of the years 1900 ... 2100, got "
                 "\"2024-06-31T12:00Z\"",
                 "write time_utc = \"2024-06-21T12:00Z\""},
        BadScene{"sun_time_too_early", "version = 1\n[sun]\ntime_utc = 1899-12-31T23:59:59Z\n",
                 "storm.toml:3:12: sun.time_utc: expected a time in UTC of the years 1900 ... 2100, got "
                 "1899-12-31T23:59:59Z",
                 "write time_utc = \"2024-06-21T12:00Z\""},
        BadScene{"sky_value", "version = 1\n[sky]\naerosol_optical_depth = 3\n",
                 "storm.toml:3:25: sky.aerosol_optical_depth: expected a number within [0, 2], got 3",
                 "write aerosol_optical_depth = 2"},
        BadScene{"sky_key", "version = 1\n[sky]\nozone = 3\n",
                 "storm.toml:3:1: sky.ozone: expected a known key, got \"ozone\"", "did you mean ozone_du?"},
        BadScene{"section_as_value", "version = 1\nocean = 3\n",
                 "storm.toml:2:1: ocean: expected a section [ocean], got 3",
                 "write [ocean] on a line of its own and its keys below"},
        BadScene{"cascade_not_repeated", "version = 1\n[ocean.cascade]\npatch_m = 3\n",
                 "storm.toml:2:8: ocean.cascade: expected a section [[ocean.cascade]], got a table",
                 "write [[ocean.cascade]] on a line of its own and its keys below"},
        BadScene{"no_version", "[ocean]\nsize = 64\n",
                 "storm.toml:1:1: version: expected version = 1, found none",
                 "write version = 1 on the first line"},
        BadScene{"later_version", "version = 2\n", "storm.toml:1:11: version: expected 1, got 2",
                 "this version of offing reads scenes of version = 1"}),
    [](const auto& tested) { return std::string(tested.param.name); });

// Fails if a fifth cascade is dropped or taken.
TEST(SceneFile, RefusesTooManyCascades) {
  std::string text = "version = 1\n";
  for (int i = 0; i < 5; ++i) {
    text += "[[ocean.cascade]]\npatch_m = 10\n";
  }
  EXPECT_EQ(refusal_of(text).what,
            "storm.toml:11:11: ocean.cascade.patch_m: expected at most 4 values, found more");
}

// Fails if swells or raindrops beyond the limit are taken, or dropped without a word.
TEST(SceneFile, RefusesTooManyElements) {
  std::string swells = "version = 1\n", drops = "version = 1\n";
  for (int i = 0; i < 65; ++i) swells += "[[ocean.swell]]\n";
  for (int i = 0; i < 4097; ++i) drops += "[[ocean.raindrop]]\n";
  EXPECT_EQ(refusal_of(swells).what,
            "storm.toml:66:1: ocean.swell: expected at most 64 sections, found more");
  EXPECT_EQ(refusal_of(drops).what,
            "storm.toml:4098:1: ocean.raindrop: expected at most 4096 sections, found more");
}

// Fails if a fault in the syntax loses its place.
TEST(SceneFile, RefusesWhatIsNotToml) {
  EXPECT_EQ(refusal_of("version = 1\n[ocean\n").what.substr(0, 17), "storm.toml:2:7: e");
  EXPECT_NE(refusal_of(std::string("version = 1\n\0\1\2", 15)).what, "accepted");
  EXPECT_NE(refusal_of("version = 1\n\xff\xfe").what, "accepted");
}

// Fails if nesting overflows the stack.
TEST(SceneFile, RefusesDeepNesting) {
  EXPECT_NE(refusal_of("a = " + std::string(100000, '[')).what, "accepted");
}

// Fails if a missing file, a folder or an endless file ends in anything but an error that names it.
TEST(SceneFile, RefusesWhatCannotBeRead) {
  for (const char* name : {"/nonexistent/storm.toml", "/", "/dev/zero"}) {
    try {
      load_scene(name);
      ADD_FAILURE() << name << " was accepted";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_EQ(std::string(error.what()).rfind(std::string(name) + ": ", 0), 0u) << error.what();
    }
  }
}

// Fails if what benchmarks read from a scene is refused, or passed over where it is no section of its own.
TEST(SceneFile, LeavesBenchmarksToThemselves) {
  const Scene scene = parse_scene(
      "version = 1\n[terrain]\nposts = 9\n[bench.walk]\ncount = 4\n[[bench.fly]]\nx = 1\n", "a.toml", "");
  EXPECT_EQ(scene.terrain.fractal.posts, 9);
  EXPECT_TRUE(scene.set_at.contains("terrain.posts"));
  EXPECT_THROW(parse_scene("version = 1\nbench = 4\n", "a.toml", ""), Error);
  EXPECT_THROW(parse_scene("version = 1\n[terrain.bench]\nx = 4\n", "a.toml", ""), Error);
}

}  // namespace
}  // namespace offing::scene

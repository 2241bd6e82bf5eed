// Seas by height and period, and irregular swells, as a simulation gets them.
#include <cmath>
#include <numbers>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocean/spectrum/sea_spectrum.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_hash.h"
#include "host/scene/prepare/sampled_spectrum.h"
#include "host/scene/prepare/sea.h"
#include "host/scene/prepare/world_scene.h"
#include "host/scene/schema/presets.h"
#include "host/scene/schema/unused_parameters.h"

namespace offing::scene {
namespace {

Scene sea_scene(const std::string& more) {
  return parse_scene("version = 1\n[ocean]\nsize = 64\n" + more, "a.toml", "");
}

ocean::SeaState state_with(const std::string& more) {
  return ocean::integrate_sea_state(prepare_sea(sea_scene(more)).spectrum);
}

// Fails if a key does not reach the spectrum: height within the quadrature's 1e-5, period within 1e-6.
TEST(SeaByHeight, KeysMakeTheSea) {
  const ocean::SeaState jonswap = state_with("hs_m = 2.5\ntp_s = 8\ngamma = 1.5\n");
  EXPECT_NEAR(jonswap.hs_m, 2.5, 1e-4);
  EXPECT_NEAR(jonswap.peak_period_s, 8.0, 1e-4);
  const ocean::SeaState tma = state_with("spectrum = \"tma\"\ndepth_m = 6\nhs_m = 1.2\ntp_s = 9\n");
  EXPECT_NEAR(tma.hs_m, 1.2, 1e-4);
  EXPECT_NEAR(tma.peak_period_s, 9.0, 1e-4);
  EXPECT_NEAR(state_with("hs_m = 2.5\ntz_s = 6\n").tm02_s, 6.0, 1e-4);
  EXPECT_NEAR(state_with("hs_m = 4\n").peak_period_s, 10.0, 0.05) << "5 sqrt(Hs), fully developed";
}

// Fails if two keys that say the same pass, or one that has no effect is passed over.
TEST(SeaByHeight, ExcludesWhatItReplaces) {
  for (const std::string both : {"hs_m = 2\nfetch_m = 1e4\n", "hs_m = 2\ntp_s = 8\ntz_s = 6\n"}) {
    EXPECT_THROW(sea_scene(both), Error) << both;
  }
  const auto warnings = [](const std::string& more) {
    const Scene scene = sea_scene(more);
    return unused_parameters(scene, prepare_sea(scene, Warnings::left_out));
  };
  EXPECT_THAT(warnings("tp_s = 8\n"), testing::ElementsAre(testing::HasSubstr("there is no hs_m")));
  EXPECT_THAT(warnings("spectrum = \"phillips\"\nhs_m = 2\n"),
              testing::ElementsAre(testing::HasSubstr("the spectrum is phillips")));
  EXPECT_THAT(warnings("hs_m = 2\n[wind]\nspeed_mps = 9\n"),
              testing::ElementsAre(testing::HasSubstr("ocean.wind_speed_mps")));
  EXPECT_THAT(warnings("hs_m = 2\nwind_speed_mps = 9\n"), testing::IsEmpty());
}

// Fails if a preset names a key that is not there, a value out of range, or leaves what contradicts it.
TEST(SeaByHeight, PresetsMakeSeasOfTheBeaufortScale) {
  int forces = 0;
  double last_hs_m = 0.0;
  for (const Preset& preset : presets()) {
    if (preset.group != ParameterGroup::sea) continue;
    ++forces;
    Scene scene = sea_scene("tz_s = 5\nhs_m = 1\nwind_speed_mps = 3\n");
    apply(preset, scene);
    const Sea sea = prepare_sea(scene);
    const ocean::SeaState state = ocean::integrate_sea_state(sea.spectrum);
    EXPECT_NEAR(state.peak_period_s, 5.0 * std::sqrt(state.hs_m), 0.02 * state.peak_period_s) << preset.name;
    EXPECT_GT(state.hs_m, last_hs_m) << preset.name;
    last_hs_m = state.hs_m;
    const double force = std::stod(std::string(preset.name.substr(std::string("beaufort-").size())));
    EXPECT_NEAR(sea.wind.wind_speed_mps, 0.836 * std::pow(force, 1.5), 0.05) << preset.name;
    EXPECT_THAT(unused_parameters(scene, sea), testing::IsEmpty()) << preset.name;
  }
  EXPECT_EQ(forces, 12);
  EXPECT_THROW(find_preset("hull-buoy", "--preset"), Error) << "which is not of the sea";
  try {
    find_preset("beaufort-13", "--preset");
    FAIL() << "a preset that is not there";
  } catch (const Error& error) {
    EXPECT_STREQ(error.what(), "--preset: expected the name of a preset, got \"beaufort-13\"");
    EXPECT_THAT(error.hint(), testing::HasSubstr("beaufort-12"));
  }
}

// Fails if the wind of whitecaps and wave age is not the one that makes such a sea, or one's own.
TEST(SeaByHeight, HasTheWindThatMakesIt) {
  // m0 omega^3 / (1.6e-7 22^3 g) by hand: 0.390625 0.48447 / (1.70368e-3 9.81) = 11.32 m/s.
  const Scene by_height = sea_scene("hs_m = 2.5\ntp_s = 8\nwind_direction_deg = 30\n");
  EXPECT_NEAR(prepare_sea(by_height).wind.wind_speed_mps, 11.32, 0.01);
  EXPECT_NEAR(prepare_world(by_height).wind.wind_speed_mps, 11.32, 0.01);
  EXPECT_NEAR(prepare_world(by_height).wind.wind_direction_rad, std::numbers::pi / 6.0, 1e-12);
  EXPECT_EQ(prepare_sea(sea_scene("hs_m = 2.5\ntp_s = 8\nwind_speed_mps = 5\n")).wind.wind_speed_mps, 5.0);
  EXPECT_EQ(prepare_sea(sea_scene("")).wind.wind_speed_mps, 10.0);
}

constexpr const char* two_swells =
    "[[ocean.swell]]\nhs_m = 1.5\ntp_s = 14\ndirection_deg = 90\nspread_deg = 12\n"
    "[[ocean.swell]]\nhs_m = 2\ntp_s = 10\ndirection_deg = 200\n";

// Fails if a swell's energy is not added to the wind's, or its period, direction or spread are lost. Energies
// add within the quadrature's 1e-5; of the swell alone the peak is exact, the spread that of cos^2s, 0.1
// degrees.
TEST(IrregularSwell, JoinsTheSpectrum) {
  const ocean::SeaState all = state_with(std::string("hs_m = 1\ntp_s = 5\n") + two_swells);
  EXPECT_NEAR(all.hs_m, std::sqrt(1.0 + 1.5 * 1.5 + 4.0), 1e-4);
  EXPECT_NEAR(all.peak_period_s, 10.0, 0.01);
  EXPECT_NEAR(all.peak_direction_rad * 180.0 / std::numbers::pi, 200.0, 0.5);
  const Sea alone =
      prepare_sea(sea_scene("hs_m = 0.001\ntp_s = 1\n[[ocean.swell]]\nhs_m = 1.5\ntp_s = 14\ndirection_deg = "
                            "90\nspread_deg = 12\n"));
  const ocean::SeaState swell = ocean::integrate_sea_state(alone.spectrum);
  EXPECT_NEAR(swell.hs_m, 1.5, 1e-4);
  EXPECT_NEAR(swell.peak_period_s, 14.0, 1e-3);
  EXPECT_NEAR(swell.spread_rad * 180.0 / std::numbers::pi, 12.0, 0.1);
  EXPECT_NEAR(swell.mean_direction_rad, std::numbers::pi / 2.0, 1e-3);
  EXPECT_TRUE(alone.swells.empty());
}

// Fails if swells of one wave and irregular ones get mixed up, or a key of the other kind passes unreported.
TEST(IrregularSwell, StandsBesideSingleWaves) {
  const Scene scene = sea_scene(std::string(two_swells) + "[[ocean.swell]]\namplitude_m = 0.3\n");
  const Sea sea = prepare_sea(scene);
  EXPECT_EQ(sea.irregular_swells, 2u);
  ASSERT_EQ(sea.swells.size(), 1u);
  EXPECT_EQ(sea.swells[0].amplitude_m, 0.3);
  EXPECT_EQ(spectrum_name(scene, sea), "jonswap, wind 10 m/s, 2 swells");

  EXPECT_THROW(sea_scene("[[ocean.swell]]\nhs_m = 1\namplitude_m = 1\n"), Error);
  const Scene unused = sea_scene("[[ocean.swell]]\nhs_m = 1\nphase_deg = 9\n[[ocean.swell]]\ntp_s = 9\n");
  EXPECT_THAT(unused_parameters(unused, prepare_sea(unused, Warnings::left_out)),
              testing::UnorderedElementsAre(testing::HasSubstr("it is many waves"),
                                            testing::HasSubstr("it is one wave")));
}

// Fails if frames of another swell pass for these when a bake resumes.
TEST(IrregularSwell, IsInTheHash) {
  const auto hash = [](const std::string& more) {
    const Scene scene = sea_scene("[[ocean.swell]]\nhs_m = 1\n" + more);
    return scene_hash(scene, prepare_sea(scene), "");
  };
  for (const std::string other : {"tp_s = 13\n", "spread_deg = 20\n", "direction_deg = 5\n"}) {
    EXPECT_NE(hash(""), hash(other)) << other;
  }
}

// Fails if an exported sea lacks its swells: height within 1 %, of 99 frequencies of which the swell's 6 %
// have few.
TEST(IrregularSwell, IsExported) {
  const Sea sea = prepare_sea(sea_scene(std::string("hs_m = 1\ntp_s = 5\n") + two_swells));
  const double hs_m = 4.0 * std::sqrt(variance_m2(sampled_spectrum(sea)));
  EXPECT_NEAR(hs_m / std::sqrt(1.0 + 1.5 * 1.5 + 4.0), 1.0, 0.01);
}

// Fails if maps that lose waves that were asked for are made without a word.
TEST(SeaByHeight, TellsWhatTheMapsLack) {
  const auto warning = [](const std::string& more) {
    const Scene scene = sea_scene(more);
    return height_warning(scene, prepare_sea(scene, Warnings::left_out));
  };
  EXPECT_EQ(warning("hs_m = 2\ntp_s = 8\n"), "");
  EXPECT_THAT(warning("hs_m = 2\ntp_s = 8\n[[ocean.cascade]]\npatch_m = 900\n"),
              testing::HasSubstr("of the waves' energy"));
}

}  // namespace
}  // namespace offing::scene

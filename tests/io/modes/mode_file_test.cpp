#include "host/io/modes/mode_file.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/io/temporary_folder.h"
#include "tests/ocl/expect_error.h"

namespace offing {
namespace {

using test::expect_error;

constexpr double turn_rad = 2.0 * std::numbers::pi;

ModalSea example() {
  return {
      .modes =
          {{.amplitude_m = 1.0 / 3.0,
            .kx_radpm = turn_rad / 80.0,
            .kz_radpm = -3.0 * turn_rad / 80.0,
            .omega_radps = 1.5661234567890,
            .phase_rad = -2.123456789012,
            .patch = 0},
           {.amplitude_m = 1e-7,
            .kx_radpm = -7.0 * turn_rad / 15.0,
            .kz_radpm = 0.0,
            .omega_radps = 5.36,
            .phase_rad = 3.0,
            .patch = 1},
           {.amplitude_m = 0.5, .kx_radpm = 0.01, .kz_radpm = 0.02, .omega_radps = 0.468, .phase_rad = 0.0}},
      .patch_lengths_m = {80.0, 15.0},
      .size = 16,
      .split_radpm = 0.05,
      .choppiness = 0.9,
      .depth_m = 40.0,
      .loop_period_s = 60.0};
}

/// Equal to `share` of each number.
void expect_same(const ModalSea& found, const ModalSea& expected, double share) {
  EXPECT_EQ(found.patch_lengths_m, expected.patch_lengths_m);
  EXPECT_EQ(found.size, expected.size);
  EXPECT_EQ(found.split_radpm, expected.split_radpm);
  EXPECT_EQ(found.choppiness, expected.choppiness);
  EXPECT_EQ(found.depth_m, expected.depth_m);
  EXPECT_EQ(found.loop_period_s, expected.loop_period_s);
  ASSERT_EQ(found.modes.size(), expected.modes.size());
  for (std::size_t i = 0; i < found.modes.size(); ++i) {
    EXPECT_EQ(found.modes[i].patch, expected.modes[i].patch);
    for (double SeaMode::*value : {&SeaMode::amplitude_m, &SeaMode::kx_radpm, &SeaMode::kz_radpm,
                                   &SeaMode::omega_radps, &SeaMode::phase_rad}) {
      EXPECT_NEAR(found.modes[i].*value, expected.modes[i].*value,
                  share * std::abs(expected.modes[i].*value));
    }
  }
}

// Fails if a column or a fact is lost, or has fewer digits than the header promises: 9 of amplitude and
// phase.
TEST(ModeFile, CsvReadsBackToItsDigits) {
  expect_same(parse_modes_csv(modes_csv(example()), "a.csv"), example(), 0.5e-8);
}

// Fails if NetCDF, which holds doubles, loses anything.
TEST(ModeFile, NetcdfReadsBackExactly) {
  const TemporaryFolder folder;
  write_modes(folder.path() / "a.nc", example());
  expect_same(read_modes(folder.path() / "a.nc", Trust::untrusted), example(), 0.0);
  write_modes(folder.path() / "a.csv", example());
  expect_same(read_modes(folder.path() / "a.csv", Trust::untrusted), example(), 0.5e-8);
}

// Fails if a wave follows another patch once patches are sorted from long to short, or columns need an order.
TEST(ModeFile, TakesPatchesAndColumnsInAnyOrder) {
  const ModalSea modes = parse_modes_csv(
      "# patch_length_m = 15, 80\n# size = 16\n"
      "patch, phase_rad,amplitude_m,omega_radps,kx_radpm,kz_radpm,more\n"
      "1,0.5,2,0.9,0,0.0785398163397,x\n\n# a note\n0,0,1,2,0.418879020479,0,\n",
      "a.csv");
  EXPECT_EQ(modes.patch_lengths_m, (std::vector<double>{80.0, 15.0}));
  EXPECT_EQ(modes.modes[0].patch, 0);
  EXPECT_EQ(modes.modes[1].patch, 1);
  EXPECT_EQ(modes.modes[0].amplitude_m, 2.0);
  EXPECT_EQ(modes.depth_m, std::numeric_limits<double>::infinity());
}

TEST(ModeFileErrors, NameFileAndLine) {
  const std::string facts = "# patch_length_m = 80\n# size = 16\n";
  const std::string names = "amplitude_m,kx_radpm,kz_radpm,omega_radps,phase_rad,patch\n";
  const std::string row = "1,0,0.0785398163397,0.9,0.5,0\n";
  std::string alone = names;
  for (int i = 0; i < 129; ++i) alone += "1,0,0.1,0.9,0.5,-1\n";
  const struct {
    std::string text;
    const char* message;
  } cases[] = {
      {"", "b:0: expected a line of column names, got the end of the file"},
      {"# size = 16\n", "b:1: expected a line of column names, got the end of the file"},
      {"amplitude_m,kx_radpm\n", "b:1: expected a column kz_radpm, got none"},
      {names, "b: expected at least one wave, got none"},
      {facts + names + "1,0,x,0.9,0.5,0\n", "b:4: expected a number in column kz_radpm, got \"x\""},
      {facts + names + "1,0,0.0785398163397\n", "b:4: expected a number in column omega_radps, got \"\""},
      {facts + names + row + "-1,0,0.0785398163397,0.9,0.5,0\n",
       "b:5: expected amplitude_m >= 0 and omega_radps > 0, got -1"},
      {facts + names + "1,0,0.0785398163397,0,0.5,0\n",
       "b:4: expected amplitude_m >= 0 and omega_radps > 0, got 0"},
      {facts + names + "1e9,0,0.0785398163397,1,0.5,0\n",
       "b:4: expected amplitude_m within [-1e6, 1e6], got 1e+09"},
      {facts + names + "1,0,0.08,0.9,0.5,0\n",
       "b:4: expected kx and kz at whole multiples of 0.0785398 rad/m, up to 7 of them, got 0.08"},
      {facts + names + "1,0,0.628318530718,0.9,0.5,0\n", "up to 7 of them, got 0.628319"},
      {facts + names + "1,0,0,0.9,0.5,0\n", "b:4: expected kx or kz other than 0, got 0"},
      {facts + names + "1,0,0.0785398163397,0.9,0.5,1\n",
       "b:4: expected a patch within [0, 0], or -1 for none, got 1"},
      {alone, "b:130: expected at most 128 waves that are on no patch, got 129"},
      {"# size = 17\n" + names + row, "b: expected a power of two as size, got 17"},
      {"# size = 16, 16\n" + names + row, "b: expected one size within [16, 4096], got 2"},
      {"# size = a\n" + names + row, "b:1: expected numbers after size =, got \" a\""},
      {"# choppiness = 11\n" + names + row, "b: expected one choppiness within [0, 10], got 11"},
      {"# patch_length_m = 1, 2, 3, 4, 5\n" + names + row, "b: expected up to 4 patches, got 5"},
      {"# patch_length_m = 80, 80\n" + names + row, "b: expected patches of different lengths, got 80"},
      {"# patch_length_m = -1\n" + names + row, "b: expected patch_length_m within [0.01, 1e6], got -1"},
  };
  for (const auto& c : cases) {
    const std::string hint =
        expect_error(ErrorKind::bad_input, c.message, [&] { parse_modes_csv(c.text, "b"); });
    EXPECT_FALSE(hint.empty()) << c.message;
  }
}

}  // namespace
}  // namespace offing

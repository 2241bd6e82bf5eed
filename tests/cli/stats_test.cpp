#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/scene/file/scene_file.h"
#include "tests/cli/offing_program.h"

// The sea-state certificate and the listing of spectra, as scripts read them.

namespace offing::test {
namespace {

using nlohmann::json;

json parsed(const std::vector<std::string>& arguments) {
  const ProgramResult result = run_offing(arguments);
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  return json::parse(result.output, nullptr, false);
}

std::vector<std::string> keys(const json& object) {
  std::vector<std::string> names;
  for (const auto& [name, value] : object.items()) {
    names.push_back(name);
  }
  return names;
}

// Fails if a documented key is missing or misnamed, or a figure is no number.
TEST(Stats, HasTheDocumentedKeys) {
  const json stats = parsed({"ocean", "stats", "--size", "32", "--seeds", "2", "--json", "--quiet"});
  EXPECT_THAT(keys(stats["asked"]),
              testing::UnorderedElementsAre("hs_m", "peak_period_s", "tp_s", "tm01_s", "tm02_s", "tz_s",
                                            "mean_direction_deg", "peak_direction_deg", "spread_deg", "mss"));
  EXPECT_THAT(keys(stats["measured"]),
              testing::UnorderedElementsAre("hs_m", "peak_period_s", "tp_s", "tm01_s", "tm02_s", "tz_s",
                                            "mean_direction_deg", "peak_direction_deg", "spread_deg", "mss",
                                            "skewness", "kurtosis", "max_ka", "folded_share"));
  for (const auto& [name, value] : stats["measured"].items()) {
    EXPECT_TRUE(value.is_number()) << name;
  }
}

// Fails if the wind height, the g or the amplitude of Pierson-Moskowitz slip: Hs = 0.20925 U^2 / g = 2.133 m
// and Tp = 6.96 s at U = 10 m/s (19.5 m), within 1 %.
TEST(Stats, AsksWhatPiersonMoskowitzSays) {
  const json stats = parsed({"ocean", "stats", "--spectrum", "pm", "--wind-speed-mps", "10", "--size", "32",
                             "--seeds", "1", "--json", "--quiet"});
  EXPECT_NEAR(stats["asked"]["hs_m"].get<double>(), 2.133, 0.02133);
  EXPECT_NEAR(stats["asked"]["tp_s"].get<double>(), 6.96, 0.0696);
}

// Fails if the surface does not carry the energy, the periods or the direction that it was asked for. The
// gate is four standard errors on each side, stated by the program from its mode energies: false alarm 2e-4
// over the three figures. The surface is measured by transforming elevation and rate of change back, not from
// the amplitudes it was made of.
TEST(Stats, SurfaceFollowsTheSpectrum) {
  const json stats =
      parsed({"ocean", "stats", "--spectrum", "jonswap", "--wind-speed-mps", "12", "--wind-direction-deg",
              "130", "--size", "64", "--seeds", "12", "--json", "--quiet"});
  const json& expected = stats["resolved"];
  const json& error = stats["standard_error"];
  for (const char* name : {"hs_m", "tm02_s", "mean_direction_deg"}) {
    EXPECT_NEAR(stats["measured"][name].get<double>(), expected[name].get<double>(),
                4 * error[name].get<double>())
        << name;
  }
  EXPECT_NEAR(expected["mean_direction_deg"].get<double>(), 130.0, 0.1);
  // Linear waves: elevation is Gaussian. With 12 seas of about 500 effective waves the standard error of
  // skewness is below 0.02, that of kurtosis below 0.05.
  EXPECT_NEAR(stats["measured"]["skewness"].get<double>(), 0.0, 0.08);
  EXPECT_NEAR(stats["measured"]["kurtosis"].get<double>(), 3.0, 0.2);
}

// Fails if flags of height and period do not replace a scene's wind and fetch, or two that say the same pass;
// if swells of flags are not added, or their bearings are not. Asked figures are exact to 1e-5.
TEST(Stats, TakesHeightPeriodAndSwells) {
  const TemporaryFolder folder;
  const std::string scene = (folder.path() / "a.toml").string();
  std::ofstream(scene) << "version = 1\n[ocean]\nfetch_m = 5e4\nsize = 32\n";
  const json stats =
      parsed({"ocean", "stats", scene, "--hs-m", "2", "--tp-s", "8", "--swell",
              "hs_m = 1, tp_s = 15, direction_deg = 300", "--swell", "hs_m=2,tp_s=11,direction_deg=10",
              "--compass", "--seeds", "1", "--json", "--quiet"});
  EXPECT_NEAR(stats["asked"]["hs_m"].get<double>(), 3.0, 1e-4);
  EXPECT_NEAR(stats["asked"]["peak_period_s"].get<double>(), 11.0, 0.02);
  EXPECT_NEAR(stats["asked"]["peak_direction_deg"].get<double>(), 10.0, 1.5);  // beside other waves
  const ProgramResult both = run_offing({"ocean", "stats", "--tp-s", "8", "--tz-s", "6"});
  EXPECT_EQ(both.exit_code, 2);
  EXPECT_THAT(both.errors, testing::HasSubstr("expected either --tp-s or --tz-s, found both"));
  const ProgramResult unknown = run_offing({"ocean", "stats", "--swell", "height=2"});
  EXPECT_EQ(unknown.exit_code, 2);
  EXPECT_THAT(unknown.errors, testing::HasSubstr("expected a key of [[ocean.swell]], got \"height\""));
}

/// Height, peak period, gamma and depth of a sea; no depth: jonswap.
struct AskedSea {
  double hs_m, tp_s, gamma, depth_m = 0.0;
};

/// Fails if the program asks its maps for another height or peak than it was asked for (exact to 1e-5), if
/// the maps cannot hold them within 1 %, or if the mean of 8 seas is three standard errors off. The standard
/// errors are theory; the seeds are fixed, so that a sound sea never fails.
void expect_height_and_period(const AskedSea& sea, const std::string& size) {
  const bool is_deep = sea.depth_m == 0.0;
  std::vector<std::string> arguments = {"ocean",      "stats",
                                        "--spectrum", is_deep ? "jonswap" : "tma",
                                        "--hs-m",     fmt::format("{}", sea.hs_m),
                                        "--tp-s",     fmt::format("{}", sea.tp_s),
                                        "--gamma",    fmt::format("{}", sea.gamma),
                                        "--size",     size,
                                        "--seeds",    "8",
                                        "--json",     "--quiet"};
  if (!is_deep) arguments.insert(arguments.end(), {"--depth-m", fmt::format("{}", sea.depth_m)});
  const json stats = parsed(arguments);
  SCOPED_TRACE(testing::Message() << "Hs " << sea.hs_m << " Tp " << sea.tp_s << " gamma " << sea.gamma
                                  << " depth " << sea.depth_m);
  for (const auto& [name, asked] : {std::pair{"hs_m", sea.hs_m}, std::pair{"peak_period_s", sea.tp_s}}) {
    EXPECT_NEAR(stats["asked"][name].get<double>() / asked, 1.0, 1e-5) << name;
    EXPECT_NEAR(stats["resolved"][name].get<double>() / asked, 1.0, 0.01) << name;
    EXPECT_NEAR(stats["measured"][name].get<double>(), asked,
                3.0 * stats["standard_error"][name].get<double>())
        << name;
  }
}

// A few of the seas below on maps small enough for every day.
TEST(Stats, SeasHaveTheirHeightAndPeriod) {
  for (const AskedSea& sea : {AskedSea{2.0, 9.0, 1.0}, AskedSea{4.0, 10.0, 7.0}, AskedSea{1.0, 8.0, 1.5, 4.0},
                              AskedSea{3.0, 12.0, 3.3, 20.0}}) {
    expect_height_and_period(sea, "128");
  }
}

// Thirty pairs of height and period in deep water, and thirty in depths from a hundredth of the deep
// wavelength to all of it, with gamma from 1 to 7.
TEST(Stats, SixtySeasHaveTheirHeightAndPeriod) {
  const double periods_s[] = {1.5, 3.0, 5.0, 8.0, 12.0, 18.0},
               steepnesses[] = {0.005, 0.01, 0.02, 0.035, 0.05};
  const double gammas[] = {1.0, 1.5, 2.0, 3.3, 5.0, 7.0}, depths[] = {0.01, 0.03, 0.1, 0.3, 1.0};
  for (int i = 0; i < 30; ++i) {
    const double tp_s = periods_s[i % 6], deep_m = 1.5613 * tp_s * tp_s;  // g / 2 pi
    AskedSea sea{steepnesses[i / 6] * deep_m, tp_s, gammas[(i + i / 6) % 6]};
    expect_height_and_period(sea, "512");
    sea.depth_m = std::max(depths[(2 * i + i / 6) % 5] * deep_m, 0.1);
    expect_height_and_period(sea, "512");
  }
}

// Fails if seas of different seeds were scaled to one height (no spread), or scatter unlike their mode
// energies say: 24 seeds leave 50 % either way four standard deviations off (1 / sqrt(2 * 23) = 0.147
// relative).
TEST(Stats, SpreadFollowsTheory) {
  const json stats =
      parsed({"ocean", "stats", "--size", "32", "--patch-m", "300", "--seeds", "24", "--json", "--quiet"});
  const double theory = stats["standard_error"]["hs_m"].get<double>() * std::sqrt(24.0);
  EXPECT_GT(stats["spread"]["hs_m"].get<double>(), 0.5 * theory);
  EXPECT_LT(stats["spread"]["hs_m"].get<double>(), 1.6 * theory);
}

// Fails if energy is lost without a word: cascades and out-of-band part must add up to m0.
TEST(Stats, AccountsForAllEnergy) {
  const json stats = parsed({"ocean", "stats", "--size", "64", "--seeds", "1", "--json", "--quiet"});
  double sum = stats["out_of_band_m2"].get<double>();
  for (const json& cascade : stats["cascades"]) {
    sum += cascade["expected_m0_m2"].get<double>();
  }
  EXPECT_NEAR(sum / stats["m0_m2"].get<double>(), 1.0, 0.003);
}

// Fails if a sea that travels toward 20 degrees past east is not said to come from 290, or is another one
// when it is asked for by that bearing. A scene file's direction is of travel all the same.
TEST(Stats, TakesAndTellsBearings) {
  const auto stats = [](std::vector<std::string> more) {
    more.insert(more.begin(), {"ocean", "stats", "--size", "32", "--seeds", "1", "--json", "--quiet"});
    return parsed(more);
  };
  const TemporaryFolder folder;
  const std::string scene = (folder.path() / "a.toml").string();
  std::ofstream(scene) << "version = 1\n[wind]\ndirection_deg = 20\n";
  const json travel = stats({"--wind-direction-deg", "20"});
  json compass = stats({"--wind-direction-deg", "290", "--compass"});
  EXPECT_NEAR(travel["asked"]["mean_direction_deg"].get<double>(), 20.0, 0.01);
  EXPECT_NEAR(compass["asked"]["mean_direction_deg"].get<double>(), 290.0, 0.01);
  EXPECT_EQ(stats({scene, "--compass"}), compass);
  EXPECT_EQ(compass["measured"]["tm02_s"], travel["measured"]["tm02_s"]);
}

// Fails if a flag without any part in the sea is ignored in silence, or stops the work.
TEST(Stats, TellsWhatIsNotUsed) {
  const ProgramResult result =
      run_offing({"ocean", "stats", "--size", "16", "--seeds", "1", "--record", "3", "--swell-hs-m", "2"});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors,
              testing::HasSubstr("warning: --record: not used: there is no measured spectrum\n"));
  EXPECT_THAT(result.errors,
              testing::HasSubstr("warning: --swell-hs-m: not used: the spectrum is jonswap\n"));
}

// Fails if a scene that comes with Offing is not read, sets what has no part in its sea, or one of ground
// alone is taken for a sea.
TEST(Stats, TakesTheScenesWithoutAWarning) {
  int seas = 0;
  for (const auto& entry : std::filesystem::directory_iterator(OFFING_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    const ProgramResult result =
        run_offing({"ocean", "stats", entry.path().string(), "--size", "32", "--seeds", "1"});
    EXPECT_THAT(result.errors, testing::Not(testing::HasSubstr("warning"))) << entry.path();
    if (!scene::load_scene(entry.path()).has_sea()) {
      EXPECT_EQ(result.exit_code, 2) << entry.path();
      EXPECT_THAT(result.errors, testing::HasSubstr("expected a sea, found none"));
    } else {
      EXPECT_EQ(result.exit_code, 0) << result.errors;
      ++seas;
    }
  }
  EXPECT_GE(seas, 4);
}

// Fails if the text for people lacks what it must say.
TEST(Stats, TextSaysWhatIsLinear) {
  const ProgramResult result = run_offing({"ocean", "stats", "--size", "32", "--seeds", "2", "--quiet"});
  ASSERT_EQ(result.exit_code, 0);
  EXPECT_THAT(result.output, testing::HasSubstr("no skewness"));
  EXPECT_THAT(result.output, testing::HasSubstr("out of band"));
}

struct MeasuredFile {
  const char* name;
  double hs_m;  ///< 4 sqrt(m0) of the first record, by an independent reader
};

class MeasuredFiles : public testing::TestWithParam<MeasuredFile> {};

// Fails if the sea made from a file has not the file's height: asked within 1 %, measured within four
// standard errors.
TEST_P(MeasuredFiles, KeepTheirHeight) {
  const char* data = std::getenv("OFFING_TEST_DATA");
  if (data == nullptr) {
    GTEST_SKIP() << "OFFING_TEST_DATA is not set: no measured spectra";
  }
  const std::string file = std::string(data) + "/spectra/" + GetParam().name;
  const json stats = parsed(
      {"ocean", "stats", "--spectrum-file", file, "--size", "64", "--seeds", "8", "--json", "--quiet"});
  EXPECT_NEAR(stats["asked"]["hs_m"].get<double>(), GetParam().hs_m, 0.01 * GetParam().hs_m);
  for (const char* name : {"hs_m", "tm02_s"}) {
    EXPECT_NEAR(stats["measured"][name].get<double>(), stats["resolved"][name].get<double>(),
                4 * stats["standard_error"][name].get<double>())
        << name;
  }
}

INSTANTIATE_TEST_SUITE_P(Files, MeasuredFiles,
                         testing::Values(MeasuredFile{"41010.data_spec", 1.1188},
                                         MeasuredFile{"ww3station.spec", 1.1573},
                                         MeasuredFile{"swanfile.spec", 1.7164},
                                         MeasuredFile{"buoy}2024-09-09T01h15Z.spt", 0.8490}),
                         [](const auto& tested) { return "File" + std::to_string(tested.index); });

/// Two records in NDBC form: 1 m^2/Hz over 0.1 Hz, thus Hs = 4 sqrt(0.1), then none at all.
class Listing : public testing::Test {
 protected:
  Listing() {
    std::ofstream(file()) << "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) ... >\n"
                             "2020 06 08 03 50 0.225 1.000 (0.100) 1.000 (0.200)\n"
                             "2020 06 08 02 50 0.225 0.000 (0.100) 0.000 (0.200)\n";
  }
  std::string file() const { return (folder_.path() / "a.data_spec").string(); }
  std::string path(const char* name) const { return (folder_.path() / name).string(); }

 private:
  TemporaryFolder folder_;
};

// Fails if a record, its time or its height is wrong, or a record without energy stops the list.
TEST_F(Listing, ListsRecords) {
  const json records = parsed({"ocean", "spectrum", file(), "--json"})["records"];
  ASSERT_EQ(records.size(), 2u);
  EXPECT_EQ(records[0]["time_utc"], "2020-06-08T03:50Z");
  EXPECT_NEAR(records[0]["hs_m"].get<double>(), 4 * std::sqrt(0.1), 1e-3);
  EXPECT_EQ(records[1]["hs_m"], 0.0);
  EXPECT_TRUE(records[0]["mean_direction_deg"].is_null());
  EXPECT_THAT(run_offing({"ocean", "spectrum", file()}).output, testing::HasSubstr("2020-06-08T02:50Z"));
}

// Fails if listing thousands of records cannot be stopped. The export, which comes first, tells that reading
// is over; a listing of 4000 that nobody stops takes twenty seconds and exits with 0.
TEST_F(Listing, StopsWhenAsked) {
  std::ofstream many(path("many.spec"));
  many << "'WAVEWATCH III SPECTRA'     2     4     1 'waves'\n  0.1 0.2\n  0.0 1.5708 3.1416 4.7124\n";
  for (int i = 0; i < 4000; ++i) {
    many << "20200608 015000\n'41010     '  28.90 -78.50  800.0  10.0 90.0  0.00 90.0\n"
            "  1.0 0.5 0.1 0.1 0.1 0.1 0.1 0.1\n";
  }
  many.close();
  OffingProgram program({"ocean", "spectrum", path("many.spec"), "--export-spectrum", path("all.spec")});
  while (program.is_running() && !std::filesystem::exists(path("all.spec"))) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.send_signal(SIGINT);
  const ProgramResult stopped = program.wait();
  EXPECT_EQ(stopped.exit_code, 130);
  EXPECT_THAT(stopped.errors, testing::HasSubstr("error: stopped at the user's request\nhint: "));
}

// Fails if one record is not drawn as text and as a picture.
TEST_F(Listing, DrawsARecord) {
  const ProgramResult result =
      run_offing({"ocean", "spectrum", file(), "--record", "0", "--plot", path("plot.png")});
  EXPECT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.output, testing::HasSubstr("0.2000"));
  EXPECT_THAT(result.output, testing::HasSubstr("####"));
  EXPECT_GT(std::filesystem::file_size(path("plot.png")), 1000u);
}

// Fails if a sea changes on the way out to a WAVEWATCH III file and back: same height within its seven digits
// and the modelled sea's tail beyond ten peak frequencies (1e-4).
TEST_F(Listing, ExportsAndReadsBack) {
  const ProgramResult result =
      run_offing({"ocean", "bake", "--size", "16", "--cascades", "1", "--frames", "0:0",
                  "--wind-direction-deg", "70", "--export-spectrum", path("sea.spec"), "-o", path("out")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const json record = parsed({"ocean", "spectrum", path("sea.spec"), "--json"})["records"][0];
  EXPECT_NEAR(record["hs_m"].get<double>(), 2.1386, 0.005);  // JONSWAP, U = 10 m/s, F = 100 km
  EXPECT_NEAR(record["mean_direction_deg"].get<double>(), 70.0, 0.2);
}

}  // namespace
}  // namespace offing::test

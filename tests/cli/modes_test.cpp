#include <cmath>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/offing_program.h"

// `offing ocean modes`, the seas that are made of its files, and series as NetCDF.

namespace offing::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class Modes : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  /// A small sea of two cascades and Gerstner waves, at a point and a time.
  ProgramResult run(std::vector<std::string> arguments, bool is_drawn = true) const {
    std::vector<std::string> all = {"ocean", arguments.front(), "--quiet"};
    if (is_drawn) {
      for (const char* flag :
           {"--size", "64", "--cascades", "2", "--gerstner-count", "8", "--choppiness", "0.7"}) {
        all.emplace_back(flag);
      }
    }
    all.insert(all.end(), arguments.begin() + 1, arguments.end());
    return run_offing(all);
  }

  TemporaryFolder folder_;
};

// Fails if the sea of either file is another one than it was written from: a patch, a band, a frequency or
// the choppiness is lost. Heights are printed to 1e-7 of themselves; the waves' amplitudes are floats. Limit
// 1e-5 m.
TEST_F(Modes, MakeTheSameSeaAgain) {
  const std::vector<std::string> question = {"query", "--at", "120,-35", "--time", "5000.25", "--json"};
  const ProgramResult drawn = run(question);
  ASSERT_EQ(drawn.exit_code, 0) << drawn.errors;
  for (const char* name : {"sea.nc", "sea.csv"}) {
    const ProgramResult written = run({"modes", "-o", path(name), "--json"});
    ASSERT_EQ(written.exit_code, 0) << written.errors;
    EXPECT_GT(json::parse(written.output)["hs_m"], 1.0);
    std::vector<std::string> again = question;
    again.insert(again.end(), {"--modes-file", path(name)});
    const ProgramResult found = run(again, false);
    ASSERT_EQ(found.exit_code, 0) << found.errors;
    const json a = json::parse(drawn.output), b = json::parse(found.output);
    EXPECT_NEAR(a["height_m"], b["height_m"], 1e-5) << name;
    for (int axis = 0; axis < 3; ++axis)
      EXPECT_NEAR(a["velocity_mps"][axis], b["velocity_mps"][axis], 1e-5) << name;
  }
  EXPECT_EQ(run({"modes", "-o", path("sea.csv")}).exit_code, 2);  // is there
  EXPECT_THAT(run({"modes", "-o", path("sea.txt")}).errors, HasSubstr(".nc"));
}

// Fails if a file of modes that is missing, or is something else, ends in anything but an error that names
// it.
TEST_F(Modes, NameABadFile) {
  std::ofstream(path("a.csv")) << "x,y\n1,2\n";
  const auto errors_of = [&](const std::string& file) {
    const ProgramResult result = run({"query", "--at", "0,0", "--modes-file", file}, false);
    EXPECT_EQ(result.exit_code, 2);
    return result.errors;
  };
  EXPECT_THAT(errors_of(path("none.nc")), HasSubstr("expected a file of modes, got no such file"));
  EXPECT_THAT(errors_of(path("a.csv")), HasSubstr("a.csv:1: expected a column amplitude_m, got none"));
}

// Fails if an irregular swell beside a file of modes is left out without a word, or a swell of one wave is
// refused.
TEST_F(Modes, RefuseIrregularSwells) {
  ASSERT_EQ(run({"modes", "-o", path("sea.csv")}).exit_code, 0);
  const auto with = [&](const std::string& swell) {
    return run({"query", "--at", "0,0", "--modes-file", path("sea.csv"), "--swell", swell}, false);
  };
  const ProgramResult refused = with("hs_m=1,tp_s=14");
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.errors,
            "error: --swell: hs_m: expected no irregular swell beside a file of modes, found hs_m = 1\n"
            "hint: remove hs_m to add one wave of amplitude_m, or give the swell to `offing ocean modes`\n");
  EXPECT_EQ(with("amplitude_m=1").exit_code, 0);
}

// Fails if --swell takes keys that a scene refuses: a key twice, or two that exclude each other.
TEST_F(Modes, RefuseSwellsThatContradictThemselves) {
  const auto errors_of = [&](const std::string& swell) {
    return run({"query", "--at", "0,0", "--swell", swell}).errors;
  };
  EXPECT_THAT(errors_of("hs_m=1,hs_m=2"), HasSubstr("expected hs_m once, found it twice"));
  EXPECT_THAT(errors_of("hs_m=1,amplitude_m=2"),
              HasSubstr("expected either hs_m or amplitude_m, found both"));
  EXPECT_THAT(errors_of("period_s=9,wavelength_m=90"), HasSubstr("found both"));
}

// Fails if the number of points is not known before the first of them is answered, which NetCDF needs.
TEST_F(Modes, SeriesAreNetcdf) {
  std::ofstream(path("points.csv")) << "x_m,z_m\n0,0\n10,5\n";
  const ProgramResult result =
      run({"query", "--points", path("points.csv"), "--times", "0:2:0.5", "-o", path("water.nc"), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(json::parse(result.output)["samples"], 10);
  std::ifstream file(path("water.nc"), std::ios::binary);
  const std::string bytes{std::istreambuf_iterator<char>(file), {}};
  EXPECT_TRUE(bytes.starts_with("CDF\x02")) << bytes.size();
  EXPECT_THAT(bytes, HasSubstr("sea_surface_height_above_mean_sea_level"));
}

// Fails if the name of the file does not choose its format.
TEST_F(Modes, SeriesAreJson) {
  ASSERT_EQ(run({"query", "--at", "0,0", "--times", "0:2:0.5", "-o", path("water.json")}).exit_code, 0);
  std::ifstream file(path("water.json"));
  EXPECT_EQ(json::parse(file).size(), 5);
}

}  // namespace
}  // namespace offing::test

// The commands on floating bodies, as their users run them, on a cube whose numbers are known.
#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

using testing::HasSubstr;

class Bodies : public testing::Test {
 protected:
  /// A cube of 10 m, half below the water, whose mass centre is its centre of buoyancy.
  Bodies() {
    std::ofstream(scene()) << R"(version = 1
[ocean]
size = 32
cascade_count = 1
wind_speed_mps = 6
[[mesh]]
shape = "box"
size_m = 5
[[body]]
name = "cube"
draught_m = 5
mass_centre_m = [0, -2.5, 0]
x_m = 30
)";
  }

  std::string scene() const { return (folder_.path() / "cube.toml").string(); }
  std::string file(const char* name) const { return (folder_.path() / name).string(); }

 private:
  TemporaryFolder folder_;
};

// Closed forms: mass by volume, GM = I / V + KB - KG = 10^4 / 12 / 500 m. Fails if a number is another's.
TEST_F(Bodies, InfoTellsHydrostatics) {
  const ProgramResult result = run_offing({"bodies", "info", scene(), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto cube = nlohmann::json::parse(result.output)["bodies"][0];
  EXPECT_EQ(cube["name"], "cube");
  EXPECT_NEAR(cube["mass_kg"].get<double>(), 512500.0, 1.0);
  EXPECT_NEAR(cube["displaced_m3"].get<double>(), 500.0, 1e-3);
  EXPECT_NEAR(cube["draught_m"].get<double>(), 5.0, 1e-6);
  EXPECT_NEAR(cube["gm_roll_m"].get<double>(), 10.0 / 6.0, 1e-4);
  EXPECT_NEAR(cube["gm_pitch_m"].get<double>(), 10.0 / 6.0, 1e-4);
  // With the water that moves along; without it 2 pi sqrt(draught / g) = 4.49 s. The peak of Capytaine's
  // heave is below 6 s.
  EXPECT_NEAR(cube["heave_period_s"].get<double>(), 5.65, 0.1);
  EXPECT_EQ(cube["hydrodynamics"]["source"], "panel method");
  EXPECT_THAT(run_offing({"bodies", "info", scene()}).output, HasSubstr("512500 kg"));
}

// The bow of a ship is a blade in the coarse mesh of her hull. Fails if its two sides spoil the equations:
// periods were no numbers. Against the whole mesh, 5 %; 0.4 and 0.7 % were measured.
TEST_F(Bodies, BladesDoNotSpoilTheData) {
  std::vector<nlohmann::json> ships;
  for (const char* faces : {"1000", "100000"}) {
    std::ofstream(file("ship.toml")) << R"(version = 1
[ocean]
size = 32
[[mesh]]
shape = "ship"
size_m = 26
[[body]]
draught_m = 1.4
hull_faces = )" << faces << "\n";
    const ProgramResult result = run_offing({"bodies", "info", file("ship.toml"), "--json"});
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    ships.push_back(nlohmann::json::parse(result.output)["bodies"][0]);
  }
  for (const char* period : {"heave_period_s", "pitch_period_s"})
    EXPECT_NEAR(ships[0][period].get<double>() / ships[1][period].get<double>(), 1.0, 0.05) << period;
}

// Heave of Capytaine 3.0 in waves from ahead, m/m. Fails if periods, directions or motions are mixed up.
// Limit 5 %. Very long waves carry the hull along: it heaves with their crests.
TEST_F(Bodies, RaoIsThatOfAnotherProgram) {
  const ProgramResult result =
      run_offing({"bodies", "rao", scene(), "--periods", "4,5,8,10,14,25", "--directions", "180", "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const auto waves = nlohmann::json::parse(result.output)["bodies"][0]["waves"];
  ASSERT_EQ(waves.size(), 6u);
  const std::vector<double> expected{0.114, 0.853, 1.158, 1.048, 1.010};
  for (std::size_t i = 1; i < expected.size(); ++i)
    EXPECT_NEAR(waves[i]["heave_mpm"].get<double>() / expected[i], 1.0, 0.05) << waves[i]["period_s"];
  EXPECT_NEAR(waves[0]["heave_mpm"].get<double>(), expected[0], 0.03);
  EXPECT_NEAR(waves[5]["heave_lead_deg"].get<double>(), 0.0, 2.0);
  // Water below a crest moves as the wave travels: astern. So surge is a quarter of a turn off.
  EXPECT_NEAR(std::abs(waves[5]["surge_lead_deg"].get<double>()), 90.0, 3.0);
  EXPECT_LT(waves[5]["sway_mpm"].get<double>(), 1e-3);
}

TEST_F(Bodies, RaoWritesTableAndPlot) {
  const ProgramResult result = run_offing(
      {"bodies", "rao", scene(), "--periods", "5:7:1", "-o", file("rao.csv"), "--plot", file("rao.png")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  std::ifstream table(file("rao.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_THAT(line, HasSubstr("body,direction_deg,period_s,surge_mpm,surge_lead_deg"));
  std::size_t rows = 0;
  while (std::getline(table, line)) ++rows;
  EXPECT_EQ(rows, 9u);
  EXPECT_TRUE(std::ifstream(file("rao.png")).good());
  for (const char* periods : {"5:4:1", "0", "a", "5:7", "5,,7", "1:1000:0.0001"}) {
    const ProgramResult fault = run_offing({"bodies", "rao", scene(), "--periods", periods});
    EXPECT_EQ(fault.exit_code, 2) << periods;
    EXPECT_THAT(fault.errors, HasSubstr("error: --periods: expected")) << periods;
    EXPECT_THAT(fault.errors, HasSubstr("hint: ")) << periods;
  }
}

// Columns belong to each other: velocities are changes of places, accelerations those of velocities. Fails if
// one is of another time or axis. Over 0.1 s the cube's motions of some seconds differ from chords by at most
// 1 %.
TEST_F(Bodies, MotionIsConsistent) {
  const ProgramResult result =
      run_offing({"bodies", "motion", scene(), "--times", "2:4:0.05", "-o", file("motion.csv")});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  std::ifstream table(file("motion.csv"));
  std::string line;
  std::getline(table, line);
  EXPECT_THAT(line, HasSubstr("time_s,body,x_m,y_m,z_m,origin_x_m"));
  std::vector<std::vector<double>> rows;
  while (std::getline(table, line)) {
    std::istringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');)
      row.push_back(cell == "cube" ? 0.0 : std::stod(cell));
    rows.push_back(row);
  }
  ASSERT_EQ(rows.size(), 41u);
  ASSERT_EQ(rows[0].size(), 28u + 9 * 6);
  const std::size_t y = 3, origin_y = 6, velocity_y = 16, acceleration_y = 22;
  double most = 0.0, most_rate = 0.0;
  for (const auto& row : rows) {
    most = std::max(most, std::abs(row[velocity_y]));
    most_rate = std::max(most_rate, std::abs(row[acceleration_y]));
  }
  EXPECT_GT(most, 1e-4);
  for (std::size_t i = 1; i + 1 < rows.size(); ++i) {
    EXPECT_NEAR((rows[i + 1][y] - rows[i - 1][y]) / 0.1, rows[i][velocity_y], 0.02 * most) << i;
    EXPECT_NEAR((rows[i + 1][velocity_y] - rows[i - 1][velocity_y]) / 0.1, rows[i][acceleration_y],
                0.05 * most_rate)
        << i;
    EXPECT_NEAR(rows[i][origin_y] - rows[i][y], 2.5, 0.1);
  }
}

// Fails if forces are of another kind, time or axis than their column says. Their sum moves the mass with its
// added mass, which for a cube of half its width as draught is 0.5 to 0.9 of it (Capytaine).
TEST_F(Bodies, ForcesMoveTheMass) {
  const ProgramResult result = run_offing({"bodies", "motion", scene(), "--times", "2:6:0.05"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  std::istringstream table(result.output);
  std::string line;
  std::getline(table, line);
  std::vector<std::string> names;
  std::istringstream heads(line);
  for (std::string name; std::getline(heads, name, ',');) names.push_back(name);
  const auto column = [&](const std::string& name) {
    return static_cast<std::size_t>(std::ranges::find(names, name) - names.begin());
  };
  double work = 0.0, squares = 0.0, weight_n = 0.0;
  while (std::getline(table, line)) {
    std::istringstream cells(line);
    std::vector<double> row;
    for (std::string cell; std::getline(cells, cell, ',');)
      row.push_back(cell == "cube" ? 0.0 : std::stod(cell));
    double sum_n = 0.0;
    for (std::size_t i = 0; i < names.size(); ++i) {
      if (names[i].ends_with("_y_n")) sum_n += row[i];
    }
    const double rate = row[column("acceleration_y_mps2")];
    work += sum_n * rate;
    squares += rate * rate;
    weight_n = -row[column("gravity_y_n")];
  }
  const double moved = work / squares / (weight_n / 9.81);
  EXPECT_GT(moved, 1.4);
  EXPECT_LT(moved, 2.0);
}

TEST_F(Bodies, ScenesWithoutBodiesAreRefused) {
  std::ofstream(file("empty.toml")) << "version = 1\n[ocean]\nsize = 16\n";
  for (const char* command : {"info", "rao", "motion"}) {
    const ProgramResult result = run_offing({"bodies", command, file("empty.toml")});
    EXPECT_EQ(result.exit_code, 2) << command;
    EXPECT_THAT(result.errors, HasSubstr("expected a scene with a [[body]], found none")) << command;
  }
}

}  // namespace
}  // namespace offing::test

// offing clouds: volumes and particles of a scene, and what they hold.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;

class Clouds : public ::testing::Test {
 protected:
  Clouds() {
    std::ofstream(path("a.toml")) << R"(version = 1
[time]
fps = 2
end_s = 1.5

[[cloud]]
genus = "cumulus"
modelling = "sampled"
target_particles = 300
wind_mps = [10, 0, 0]
sway_m = 0
y_m = 1000
[[cloud.ball]]
radius_m = 200
[[cloud.ball]]
x_m = 150
y_m = 60
radius_m = 150
)";
  }
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  nlohmann::json json_of(const std::vector<std::string>& arguments) const {
    const ProgramResult result = run_offing(arguments);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output, nullptr, false);
  }

  /// Runs it and expects a refusal with these words.
  static void expect_refusal(const std::vector<std::string>& arguments, int exit_code,
                             const std::string& words) {
    const ProgramResult result = run_offing(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << result.errors;
    EXPECT_THAT(result.errors, HasSubstr(words));
    EXPECT_THAT(result.errors, HasSubstr("hint: "));
  }

  TemporaryFolder folder_;
};

// What is told of a volume when it is made is what is found in its file. A half has 11 bits: the mean of so
// many roundings is far below 0.1 %.
TEST_F(Clouds, AVolumeHoldsWhatWasBuilt) {
  const auto built =
      json_of({"clouds", "build", path("a.toml"), "-o", path("a.vdb"), "--cell-m", "10", "--json"});
  const auto found = json_of({"clouds", "info", path("a.vdb"), "--json"});
  EXPECT_EQ(found["cell_m"], 10.0);
  EXPECT_EQ(found["bricks"], built["bricks"]);
  EXPECT_NEAR(found["density_sum"].get<double>() / built["density_sum"].get<double>(), 1.0, 1e-6);
  EXPECT_NEAR(found["optical_mass_m2"].get<double>() / built["optical_mass_m2"].get<double>(), 1.0, 1e-6);
  const auto half =
      json_of({"clouds", "build", path("a.toml"), "-o", path("h.vdb"), "--cell-m", "10", "--half", "--json"});
  EXPECT_LT(half["bytes"], built["bytes"]);
  EXPECT_NEAR(json_of({"clouds", "info", path("h.vdb"), "--json"})["density_sum"].get<double>() /
                  built["density_sum"].get<double>(),
              1.0, 1e-3);
}

// Particles carry the optical mass of the field that they were sampled from: two samplings of one field, of
// which that of the volume is the finer one; 2 % is what cells of 20 m miss of a ball of 150 m.
TEST_F(Clouds, ParticlesHoldTheSameMass) {
  const auto built = json_of({"clouds", "build", path("a.toml"), "-o", path("a.ply"), "--json"});
  EXPECT_LE(built["particles"].get<int>(), 300);
  const auto found = json_of({"clouds", "info", path("a.ply"), "--json"});
  EXPECT_EQ(found["particles"], built["particles"]);
  EXPECT_NEAR(found["optical_mass_m2"].get<double>() / built["optical_mass_m2"].get<double>(), 1.0, 1e-6);
  const auto volume =
      json_of({"clouds", "build", path("a.toml"), "-o", path("a.vdb"), "--cell-m", "10", "--json"});
  EXPECT_NEAR(found["optical_mass_m2"].get<double>() / volume["optical_mass_m2"].get<double>(), 1.0, 0.05);
  const auto scene = json_of({"clouds", "info", path("a.toml"), "--json"});
  EXPECT_EQ(scene["particles"], built["particles"]);
  EXPECT_EQ(scene["clouds"][0]["genus"], "cumulus");
}

// Fails if clouds are told by their genus alone: those of a scene may all be of one.
TEST_F(Clouds, TellsNames) {
  std::ofstream(path("names.toml")) << R"(version = 1
[clouds]
quality = 0.1
[[cloud]]
name = "snowman"
[[cloud]]
[[cloud_layer]]
genus = "altocumulus"
)";
  const auto clouds = json_of({"clouds", "info", path("names.toml"), "--json"})["clouds"];
  ASSERT_GT(clouds.size(), 2);
  EXPECT_EQ(clouds[0]["name"], "snowman");
  EXPECT_EQ(clouds[1]["name"], "");
  EXPECT_EQ(clouds[2]["name"], "");
  EXPECT_THAT(run_offing({"clouds", "info", path("names.toml")}).output,
              HasSubstr("particles, \"snowman\"\n"));
}

// What was removed by hand is in no file. Fails if a volume is made of the field, which knows of no edits.
TEST_F(Clouds, EditsByHandAreHonoured) {
  std::ifstream plain(path("a.toml"));
  std::ofstream(path("e.toml"))
      << plain.rdbuf() << "[[cloud.particle_edit]]\neye_m = [0, 0, 9000]\nright = 0\nfate = \"removed\"\n";
  for (const char* file : {"a.ply", "a.vdb"}) {
    const auto whole = json_of({"clouds", "build", path("a.toml"), "-o", path(file), "--json"});
    const auto part = json_of({"clouds", "build", path("e.toml"), "-o", path(file), "--json", "--force"});
    const double share = part["optical_mass_m2"].get<double>() / whole["optical_mass_m2"].get<double>();
    EXPECT_GT(share, 0.2) << file;
    EXPECT_LT(share, 0.9) << file;
  }
}

// Fails if frames are all of one time, or named otherwise.
TEST_F(Clouds, SequencesMoveWithTheWind) {
  json_of({"clouds", "build", path("a.toml"), "-o", path("a.%03d.ply"), "--json"});
  const auto first = json_of({"clouds", "info", path("a.000.ply"), "--json"});
  const auto last = json_of({"clouds", "info", path("a.002.ply"), "--json"});
  EXPECT_FALSE(std::filesystem::exists(path("a.003.ply")));
  // 10 m/s for 1 s.
  EXPECT_NEAR(last["low_m"][0].get<double>() - first["low_m"][0].get<double>(), 10.0, 0.05);
  EXPECT_NEAR(last["low_m"][1].get<double>(), first["low_m"][1].get<double>(), 0.05);
}

// A built volume is a cloud of another scene.
TEST_F(Clouds, WhatWasBuiltCanBeShaped) {
  json_of({"clouds", "build", path("a.toml"), "-o", path("a.vdb"), "--cell-m", "20", "--json"});
  json_of({"clouds", "build", path("a.toml"), "-o", path("a.ply"), "--json"});
  std::ofstream(path("b.toml"))
      << "version = 1\n[[cloud]]\nfile = \"a.vdb\"\ntarget_particles = 200\n[[cloud]]\n"
         "file = \"a.ply\"\ncolour = [1, 0.5, 0.2]\n";
  const auto found = json_of({"clouds", "info", path("b.toml"), "--json"});
  EXPECT_EQ(found["clouds"].size(), 2u);
  EXPECT_NEAR(found["clouds"][0]["low_m"][1].get<double>(), found["clouds"][1]["low_m"][1].get<double>(),
              60.0);
  // Two colours are told.
  json_of({"clouds", "build", path("b.toml"), "-o", path("b.vdb"), "--json"});
  EXPECT_EQ(json_of({"clouds", "info", path("b.vdb"), "--json"})["has_colour"], true);
}

// Fails if what moves a cloud, beside drift, is in its particles and not in its volume, or if the volume has
// a noise of its time and the particles that of time 0. Cells of another size: 3 % for the rim.
TEST_F(Clouds, VolumesMoveAsParticlesDo) {
  const auto build = [&](const std::string& keys, const char* file, const char* time_s) {
    std::ofstream(path("moved.toml"))
        << "version = 1\n[[cloud]]\ngenus = \"stratus\"\ntarget_particles = 200\n"
        << keys;
    return json_of(
        {"clouds", "build", path("moved.toml"), "-o", path(file), "--time", time_s, "--force", "--json"});
  };
  // It has not risen yet: only what is above the level is there.
  const std::string heat = "heat_k = 1\nheat_condensation_m = 150\n";
  const double above_m2 = build(heat, "m.ply", "0")["optical_mass_m2"].get<double>();
  EXPECT_LT(above_m2, 0.5 * build("", "m.ply", "0")["optical_mass_m2"].get<double>());
  EXPECT_NEAR(build(heat, "m.vdb", "0")["optical_mass_m2"].get<double>() / above_m2, 1.0, 0.03);
  const std::string shear = "wind_mps = [10, 0, 0]\nshear_per_s = 0.5\n";
  build(shear, "m.ply", "300");
  build(shear, "m.vdb", "300");
  const auto particles = json_of({"clouds", "info", path("m.ply"), "--json"});
  const auto volume = json_of({"clouds", "info", path("m.vdb"), "--json"});
  const double width_m = particles["high_m"][0].get<double>() - particles["low_m"][0].get<double>();
  EXPECT_NEAR(volume["low_m"][0].get<double>(), particles["low_m"][0].get<double>(), 0.1 * width_m);
  EXPECT_NEAR(volume["high_m"][0].get<double>(), particles["high_m"][0].get<double>(), 0.1 * width_m);
  const std::string changing = "noise_change_per_s = 0.1\n";
  EXPECT_EQ(build(changing, "m.vdb", "0")["density_sum"], build(changing, "m.vdb", "300")["density_sum"]);
}

// Fails if a file is written that cannot be read again, or an error names cells that nobody gave.
TEST_F(Clouds, WritesNoFilesOfNothing) {
  std::ofstream(path("none.toml"))
      << "version = 1\n[[cloud]]\nmodelling = \"sampled\"\n[[cloud.ball]]\nweight = 0\n";
  for (const char* file : {"n.ply", "n.vdb"}) {
    expect_refusal({"clouds", "build", path("none.toml"), "-o", path(file)}, 2,
                   "expected density at 0 s, found none");
    EXPECT_FALSE(std::filesystem::exists(path(file)));
  }
  std::ofstream(path("tiny.toml")) << "version = 1\n[[cloud]]\nmodelling = \"sampled\"\ntarget_particles = "
                                      "5\n[[cloud.ball]]\nradius_m = 0.01\n";
  json_of({"clouds", "build", path("tiny.toml"), "-o", path("t.vdb"), "--json"});
  std::ofstream(path("far.toml"))
      << "version = 1\n[[cloud]]\nmodelling = \"sampled\"\n[[cloud.ball]]\n[[cloud.ball]]\nx_m = 400000\n"
         "y_m = 400000\nz_m = 400000\n";
  expect_refusal({"clouds", "build", path("far.toml"), "-o", path("f.ply")}, 2, "cloud 1: cloud: ");
  expect_refusal({"clouds", "build", path("far.toml"), "-o", path("f.ply")}, 2,
                 "hint: ask for fewer cloud.target");
}

// OpenVDB's own program agrees on what a file of ours holds.
TEST_F(Clouds, VdbPrintOpensIt) {
  if (std::system("command -v vdb_print >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "no vdb_print (libopenvdb-tools)";
  json_of({"clouds", "build", path("a.toml"), "-o", path("a.vdb"), "--cell-m", "10", "--json"});
  const auto found = json_of({"clouds", "info", path("a.vdb"), "--json"});
  const std::string command = fmt::format("vdb_print -l '{}' > '{}'", path("a.vdb"), path("out.txt"));
  ASSERT_EQ(std::system(command.c_str()), 0);
  std::ifstream file(path("out.txt"));
  std::string text{std::istreambuf_iterator<char>(file), {}};
  std::erase(text, ',');  // of thousands
  EXPECT_THAT(text,
              HasSubstr(fmt::format("Number of active voxels:       {}", found["cells"].get<std::size_t>())));
}

// Fails if a small device is asked for more particles than it holds for minutes before it says so, or does
// not say what to change. Of 1 GiB PoCL 3.1 gives a quarter in one piece, PoCL 7.1 all.
TEST_F(Clouds, RefusesMoreParticlesThanADeviceHolds) {
  std::ofstream(path("big.toml"))
      << "version = 1\n[[cloud]]\nmodelling = \"sampled\"\ntarget_particles = 10000000\n";
  const ScopedEnvironment memory("POCL_MEMORY_LIMIT", "1");
  for (const nlohmann::json& device : json_of({"devices", "--json"})) {
    if (device["is_default"].get<bool>() &&
        device["max_allocation_bytes"].get<std::uint64_t>() >= 480'000'000)
      GTEST_SKIP() << "the device holds the most particles that a cloud may have";
  }
  const ProgramResult result = run_offing({"clouds", "build", path("big.toml"), "-o", path("big.ply")});
  EXPECT_EQ(result.exit_code, 1) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("cloud.target_particles: 10000000 particles take 480 MB"));
  EXPECT_THAT(result.errors, HasSubstr("hint: ask for fewer"));
}

TEST_F(Clouds, RefusesWhatItCannotDo) {
  expect_refusal({"clouds", "build", path("a.toml"), "-o", path("a.obj")}, 2, ".vdb");
  expect_refusal({"clouds", "build", path("a.toml"), "-o", path("a.ply"), "--half"}, 2, "--half");
  expect_refusal({"clouds", "build", path("a.toml"), "-o", path("a.vdb"), "--cell-m", "-2"}, 2, "--cell-m");
  expect_refusal({"clouds", "build", path("a.toml"), "-o", path("a.vdb"), "--frames", "0:4"}, 2, "--frames");
  expect_refusal({"clouds", "info", path("none.vdb")}, 2, "none.vdb");
  expect_refusal({"clouds", "info", path("none.toml")}, 2, "hint: check the name of the scene file");
  std::ofstream(path("empty.toml")) << "version = 1\n";
  expect_refusal({"clouds", "build", path("empty.toml"), "-o", path("a.vdb")}, 2,
                 "expected clouds, found none");
  std::ofstream(path("bad.toml")) << "version = 1\n[[cloud]]\n[[cloud.ball]]\nradius_m = -5\n";
  expect_refusal({"clouds", "info", path("bad.toml")}, 2, "cloud.ball.radius_m");
}

// Fails if a run overwrites what was there, or what it reads.
TEST_F(Clouds, NeverReplacesItsInput) {
  json_of({"clouds", "build", path("a.toml"), "-o", path("a.ply"), "--json"});
  expect_refusal({"clouds", "build", path("a.toml"), "-o", path("a.ply")}, 2, "a.ply");
  std::ofstream(path("b.toml")) << "version = 1\n[[cloud]]\nfile = \"a.ply\"\n";
  expect_refusal({"clouds", "build", path("b.toml"), "-o", path("a.ply"), "--force"}, 2, "a.ply");
  json_of({"clouds", "build", path("a.toml"), "-o", path("a.ply"), "--force", "--json"});
}

}  // namespace
}  // namespace offing::test

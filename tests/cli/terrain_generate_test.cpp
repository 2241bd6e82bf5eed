#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/io/height_maps/read_height_map.h"
#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

class TerrainGenerate : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  ProgramResult generate(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"terrain", "generate"});
    return run_offing(arguments);
  }

  TemporaryFolder folder_;
};

// Fails if what is written is not what it says, or cannot be read as the program tells.
TEST_F(TerrainGenerate, WritesWhatInfoReads) {
  const ProgramResult made =
      generate({"--posts", "65", "--side-m", "6400", "--seed", "3", "-o", path("a.r32"), "--json"});
  ASSERT_EQ(made.exit_code, 0) << made.errors;
  const auto json = nlohmann::json::parse(made.output);
  EXPECT_EQ(json["spacing_m"], 100.0);
  const ProgramResult read =
      run_offing({"terrain", "info", path("a.r32"), "--raw-size", "65x65", "--spacing-m", "100", "--json"});
  ASSERT_EQ(read.exit_code, 0) << read.errors;
  const auto info = nlohmann::json::parse(read.output);
  EXPECT_EQ(info["lowest_m"], json["lowest_m"]);
  EXPECT_EQ(info["highest_m"], json["highest_m"]);
}

// Fails if the GeoTIFF has other heights than the plain numbers, or needs a flag to be read.
TEST_F(TerrainGenerate, WritesTheSameAsGeoTiff) {
  for (const char* name : {"b.tif", "b.r32"}) {
    ASSERT_EQ(generate({"--posts", "150", "--side-m", "2980", "--seed", "3", "-o", path(name)}).exit_code, 0);
  }
  const HeightMap tiff = read_height_map(path("b.tif")).map;
  HeightMapOptions plain;
  plain.raw_columns = plain.raw_rows = 150;
  const HeightMap raw = read_height_map(path("b.r32"), plain).map;
  EXPECT_EQ(tiff.heights_m, raw.heights_m);
  EXPECT_DOUBLE_EQ(tiff.spacing_x_m, 20.0);
  EXPECT_DOUBLE_EQ(tiff.spacing_z_m, 20.0);
  EXPECT_EQ(read_height_map(path("b.tif")).source.spacing_source, SpacingSource::file);
}

TEST_F(TerrainGenerate, RefusesWithAHint) {
  for (const std::vector<std::string>& arguments : {std::vector<std::string>{"--posts", "1"},
                                                    {"--side-m", "0"},
                                                    {"--roughness", "2"},
                                                    {"--erosion", "2"},
                                                    {"--mean-m", "inf"},
                                                    {"--seed", "-1"},
                                                    {"--longest-m", "1"},
                                                    {"--relief-m", "nan"}}) {
    std::vector<std::string> command = arguments;
    command.insert(command.end(), {"-o", path("b.r32")});
    const ProgramResult result = generate(command);
    EXPECT_EQ(result.exit_code, 2) << arguments.back();
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n")) << arguments.back();
    EXPECT_FALSE(std::filesystem::exists(path("b.r32"))) << arguments.back();
  }
  EXPECT_EQ(generate({"-o", path("b.png")}).exit_code, 2);
  std::ofstream(path("c.r32")) << "mine";
  EXPECT_EQ(generate({"--posts", "9", "-o", path("c.r32")}).exit_code, 2);
  EXPECT_EQ(std::filesystem::file_size(path("c.r32")), 4u);
}

}  // namespace
}  // namespace offing::test

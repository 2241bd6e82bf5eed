#include <array>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <limits>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/folder_content.h"
#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

/// A height map that none can use, and the flags that go with it.
struct BadMap {
  std::string name, content;
  std::vector<std::string> flags;
  int exit_code = 2;
};

std::string floats(std::size_t count, float last) {
  std::vector<float> values(count, 1.0f);
  values.back() = last;
  return {reinterpret_cast<const char*>(values.data()), count * sizeof(float)};
}

const std::string grid_header = "xllcenter 500000\nyllcenter 6400000\ncellsize 20\nNODATA_value -9999\n";

std::vector<BadMap> bad_maps() {
  constexpr float infinite = std::numeric_limits<float>::infinity();
  const std::vector<std::string> metres{"--unit", "metre"}, raw{"--raw-size", "4x4", "--spacing-m", "10"};
  return {
      {"cut.tif", std::string("II*\0\b\0\0\0", 8), {}},
      {"foreign.tif", "these are no heights", {}},
      {"voids.asc", "ncols 2\nnrows 2\n" + grid_header + "-9999 -9999\n-9999 -9999\n", metres},
      {"row.asc", "ncols 4\nnrows 1\n" + grid_header + "1 2 3 4\n", metres},
      {"unit.asc", "ncols 2\nnrows 2\nxllcenter 7\nyllcenter 45\ncellsize 0.001\n1 2\n3 4\n", {}},
      {"nan.r32", floats(16, std::numeric_limits<float>::quiet_NaN()), raw},
      {"inf.r32", floats(16, infinite), raw},
      {"minus_inf.r32", floats(16, -infinite), raw},
      {"cut.r32", floats(15, 1.0f), raw},
      {"huge.vrt",
       "<VRTDataset rasterXSize=\"100000\" rasterYSize=\"100000\">"
       "<VRTRasterBand dataType=\"Float32\" band=\"1\"/></VRTDataset>",
       {"--spacing-m", "10"},
       1},  // sound, but too much for this machine
  };
}

class TerrainBadInput : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  /// Runs the command on the map and expects one line that names it, a hint, its exit code, and no new file.
  void expect_refusal(const BadMap& map, std::vector<std::string> command) const {
    const auto before = folder_content(folder_.path());
    command.insert(command.begin(), "terrain");
    const ProgramResult result = run_offing(command);
    EXPECT_EQ(result.exit_code, map.exit_code) << map.name << ", " << command[1] << ": " << result.errors;
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n")) << map.name;
    EXPECT_THAT(result.errors, ::testing::HasSubstr(map.name)) << command[1];
    EXPECT_EQ(result.output, "") << map.name << ", " << command[1];
    EXPECT_EQ(folder_content(folder_.path()), before) << map.name << ", " << command[1];
  }

  TemporaryFolder folder_;
};

// Fails if a command takes a map that none can use, ends otherwise than with a line and a hint, or leaves a
// file behind.
TEST_F(TerrainBadInput, GetsOneLineAndWritesNothing) {
  for (const BadMap& map : bad_maps()) {
    std::ofstream(path(map.name), std::ios::binary) << map.content;
    const std::vector<std::vector<std::string>> commands{
        {"info", path(map.name)},
        {"render", path(map.name), "--size", "32x16", "-o", path("out.png"), "--depth", path("out.exr")},
        {"profile", path(map.name), "--from", "0,0", "--to", "10,10", "-o", path("out.csv")},
        {"height", path(map.name), "--at", "1,1"},
        {"ray", path(map.name), "--from", "1,100,1", "--direction", "0,-1,0"},
        {"los", path(map.name), "--from", "1,1,2", "--to", "5,5,2"}};
    for (std::vector<std::string> command : commands) {
      command.insert(command.end(), map.flags.begin(), map.flags.end());
      expect_refusal(map, command);
    }
  }
}

// The same of a folder and of nothing.
TEST_F(TerrainBadInput, FoldersAndNothing) {
  std::filesystem::create_directory(path("a_folder.tif"));
  for (const std::string name : {"a_folder.tif", "none.tif"}) {
    const ProgramResult result = run_offing({"terrain", "render", path(name), "-o", path("out.png")});
    EXPECT_EQ(result.exit_code, 2) << result.errors;
    EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n")) << name;
    EXPECT_FALSE(std::filesystem::exists(path("out.png"))) << name;
  }
}

// Fails if the size that a header claims is believed: 2^31 - 1 posts a side in a file of 146 bytes made
// thousands of folders, and Ctrl-C went unheard.
TEST_F(TerrainBadInput, TilingLooksAtTheSizeFirst) {
  std::string tiff("II*\0\x08\0\0\0", 8);
  const auto add = [&](std::uint32_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) tiff += static_cast<char>(value >> 8 * i);
  };
  // Tag, type (3: 16 bits, 4: 32 bits), value: TIFF 6.0, section 8.
  const std::vector<std::array<std::uint32_t, 3>> entries{
      {256, 4, 0x7fffffff}, {257, 4, 0x7fffffff}, {258, 3, 8},          {259, 3, 1}, {262, 3, 1},
      {273, 4, 145},        {277, 3, 1},          {278, 4, 0x7fffffff}, {279, 4, 1}};
  add(static_cast<std::uint32_t>(entries.size()), 2);
  for (const auto& [tag, type, value] : entries) {
    add(tag, 2);
    add(type, 2);
    add(1, 4);
    add(value, 4);
  }
  tiff.resize(146);
  std::ofstream(path("huge.tif"), std::ios::binary) << tiff;
  const ProgramResult result = run_offing({"terrain", "tile", path("huge.tif"), "-o", path("store")});
  EXPECT_EQ(result.exit_code, 2) << result.errors;
  EXPECT_THAT(result.errors, ::testing::HasSubstr("huge.tif: expected at most 1048576 posts per side"));
  EXPECT_FALSE(std::filesystem::exists(path("store")));
}

}  // namespace
}  // namespace offing::test

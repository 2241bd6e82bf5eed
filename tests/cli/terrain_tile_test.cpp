// `offing terrain tile`, `render` and `fly` over what it makes.
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/io/exr_image.h"
#include "host/io/png_image.h"
#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

namespace fs = std::filesystem;

class TerrainTile : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  /// Generated ground of that many posts a side, 10 m apart, and the flags that read it.
  std::vector<std::string> make_ground(int posts) const {
    const std::string side_m = std::to_string(10 * (posts - 1)), size = std::to_string(posts);
    const ProgramResult made =
        run_offing({"terrain", "generate", "--posts", size, "--side-m", side_m, "-o", path("ground.r32")});
    EXPECT_EQ(made.exit_code, 0) << made.errors;
    return {path("ground.r32"), "--raw-size", size + "x" + size, "--spacing-m", "10"};
  }
  std::vector<std::string> tile_command(const std::vector<std::string>& ground,
                                        const std::string& store) const {
    std::vector<std::string> command{"terrain", "tile"};
    command.insert(command.end(), ground.begin(), ground.end());
    command.insert(command.end(), {"-o", path(store), "--json"});
    return command;
  }
  ProgramResult tile(const std::vector<std::string>& ground, const std::string& store) const {
    return run_offing(tile_command(ground, store));
  }
  std::map<std::string, std::string> content_of(const std::string& store) const {
    std::map<std::string, std::string> content;
    for (const auto& entry : fs::recursive_directory_iterator(path(store))) {
      if (!entry.is_regular_file()) continue;
      std::ifstream file(entry.path(), std::ios::binary);
      content[fs::relative(entry.path(), path(store))] = {std::istreambuf_iterator<char>(file), {}};
    }
    return content;
  }

  TemporaryFolder folder_;
};

// Fails if a picture of a store is another than that of its map: where tiles of level 0 lie, distances are
// the same but for rounding (1e-5 of themselves), and colours to 1 of 255 on the mean.
TEST_F(TerrainTile, AStoreLooksAsItsMap) {
  const std::vector<std::string> ground = make_ground(600);
  const ProgramResult tiled = tile(ground, "store");
  ASSERT_EQ(tiled.exit_code, 0) << tiled.errors;
  const auto json = nlohmann::json::parse(tiled.output);
  EXPECT_EQ(json["levels"], 3);
  EXPECT_EQ(json["tiles"], 9 + 4 + 1);
  const auto render = [&](const std::vector<std::string>& input, const std::string& name) {
    std::vector<std::string> command{"terrain", "render"};
    command.insert(command.end(), input.begin(), input.end());
    command.insert(command.end(), {"-o", path(name + ".png"), "--depth", path(name + ".exr"), "--size",
                                   "1280x1440", "--camera", "3000,1800,5000,0,-20"});
    const ProgramResult result = run_offing(command);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
  };
  render(ground, "map");
  render({path("store")}, "tiles");
  const std::vector<float> map_m = read_exr(path("map.exr")).channel("Z"),
                           tiles_m = read_exr(path("tiles.exr")).channel("Z");
  std::size_t differing = 0;
  for (std::size_t i = 0; i < map_m.size(); ++i) {
    const bool is_same = map_m[i] == tiles_m[i] || std::abs(map_m[i] - tiles_m[i]) < 1e-5f * map_m[i];
    differing += is_same ? 0 : 1;
  }
  EXPECT_LE(differing, map_m.size() / 10'000);
  const RgbImage map = read_png(path("map.png")), tiles = read_png(path("tiles.png"));
  double difference = 0.0;
  for (std::size_t i = 0; i < map.rgb.size(); ++i) {
    difference += std::abs(map.rgb[i] - tiles.rgb[i]) / static_cast<double>(map.rgb.size());
  }
  EXPECT_LT(difference, 1.0);
}

// Fails if a run that was killed leaves something that the next run does not mend: the store must have the
// bytes of one that was made at once.
TEST_F(TerrainTile, GoesOnAfterAKill) {
  const std::vector<std::string> ground = make_ground(2049);
  ASSERT_EQ(tile(ground, "once").exit_code, 0);
  for (int kill = 0; kill < 3; ++kill) {
    OffingProgram program(tile_command(ground, "killed"));
    std::this_thread::sleep_for(std::chrono::milliseconds(40 + 60 * kill));
    program.send_signal(SIGKILL);
    program.wait();
  }
  const ProgramResult last = run_offing([&] {
    std::vector<std::string> command = tile_command(ground, "killed");
    command.push_back("--force");  // a quick machine may have finished it
    return command;
  }());
  ASSERT_EQ(last.exit_code, 0) << last.errors;
  EXPECT_EQ(content_of("killed"), content_of("once"));
}

// Fails if info tells another map than that of the store, or a command that wants a map does not say so.
TEST_F(TerrainTile, TellsOfStores) {
  ASSERT_EQ(tile(make_ground(300), "store").exit_code, 0);
  const ProgramResult info = run_offing({"terrain", "info", path("store"), "--json"});
  ASSERT_EQ(info.exit_code, 0) << info.errors;
  const auto json = nlohmann::json::parse(info.output);
  EXPECT_EQ(json["columns"], 300);
  EXPECT_EQ(json["spacing_x_m"], 10.0);
  EXPECT_EQ(json["tiles"], 5);
  EXPECT_THAT(run_offing({"terrain", "info", path("store")}).output, ::testing::HasSubstr("300 x 300"));
  const ProgramResult height = run_offing({"terrain", "height", path("store"), "--at", "5,5"});
  EXPECT_EQ(height.exit_code, 2);
  EXPECT_THAT(height.errors, ::testing::HasSubstr("found a tile store"));
}

TEST_F(TerrainTile, KeepsWhatIsThere) {
  const std::vector<std::string> ground = make_ground(300);
  ASSERT_EQ(tile(ground, "store").exit_code, 0);
  const ProgramResult again = tile(ground, "store");
  EXPECT_EQ(again.exit_code, 1);
  EXPECT_THAT(again.errors, ::testing::HasSubstr("--force"));
  std::vector<std::string> forced = tile_command(ground, "store");
  forced.push_back("--force");
  const ProgramResult third = run_offing(forced);
  EXPECT_EQ(third.exit_code, 0) << third.errors;
  EXPECT_EQ(nlohmann::json::parse(third.output)["tiles_kept"], 5);
}

// Nothing is written for input that cannot be read.
TEST_F(TerrainTile, RefusesBadInput) {
  std::ofstream(path("short.r32")) << "12";
  const ProgramResult result = tile({path("short.r32"), "--raw-size", "9x9"}, "store");
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, ::testing::MatchesRegex("error: [^\n]+\nhint: [^\n]+\n"));
  EXPECT_FALSE(fs::exists(path("store")));
  const ProgramResult resampled =
      tile({path("short.r32"), "--raw-size", "9x9", "--reproject", "utm"}, "store");
  EXPECT_EQ(resampled.exit_code, 2);
  fs::create_directory(path("empty"));
  EXPECT_EQ(tile({path("empty")}, "store").exit_code, 2);
  EXPECT_EQ(run_offing({"terrain", "fly", path("empty"), "--frames", "1"}).exit_code, 2);
  EXPECT_FALSE(fs::exists(path("store")));
}

// Fails if a flight shows sky where the map has ground, takes more memory for tiles than it may, or writes
// other pictures than it says.
TEST_F(TerrainTile, FliesOverAStore) {
  const std::vector<std::string> ground = make_ground(1500);
  ASSERT_EQ(tile(ground, "store").exit_code, 0);
  std::vector<std::string> command{"terrain",      "fly",        path("store"), "--frames", "12",
                                   "--every",      "4",          "--size",      "160x90",   "--speed-mps",
                                   "3000",         "--cache-mb", "40",          "--json",   "-o",
                                   path("frames"), "--compare"};
  command.insert(command.end(), ground.begin(), ground.end());
  const ProgramResult flown = run_offing(command);
  ASSERT_EQ(flown.exit_code, 0) << flown.errors;
  const auto json = nlohmann::json::parse(flown.output);
  EXPECT_EQ(json["comparison"]["frames"], 3);
  EXPECT_EQ(json["comparison"]["holes_flown"], 0);
  EXPECT_EQ(json["comparison"]["holes_loaded"], 0);
  EXPECT_LE(json["cache_mb"], 40.0);
  EXPECT_GT(json["frame_ms"]["median"], 0.0);
  EXPECT_TRUE(fs::exists(path("frames/frame.000000.png")));
  EXPECT_TRUE(fs::exists(path("frames/frame.000008.png")));
  EXPECT_FALSE(fs::exists(path("frames/frame.000001.png")));
}

// A tile that is broken and one that is gone: one warning each, which names the file, and the flight goes on
// without holes.
TEST_F(TerrainTile, FliesOnOverBrokenTiles) {
  const std::vector<std::string> ground = make_ground(600);
  ASSERT_EQ(tile(ground, "store").exit_code, 0);
  fs::remove(path("store/0/0001/0001.tile"));
  fs::resize_file(path("store/0/0001/0002.tile"), 5000);
  std::vector<std::string> command{"terrain", "fly",     path("store"), "--frames", "4",      "--every",  "2",
                                   "--size",  "640x360", "--speed-mps", "100",      "--json", "--compare"};
  command.insert(command.end(), ground.begin(), ground.end());
  const ProgramResult flown = run_offing(command);
  ASSERT_EQ(flown.exit_code, 0) << flown.errors;
  const auto json = nlohmann::json::parse(flown.output);
  EXPECT_EQ(json["tiles"]["failed"], 2);
  EXPECT_EQ(json["comparison"]["holes_loaded"], 0);
  for (const char* name : {"0001.tile", "0002.tile"}) {
    const std::size_t first = flown.errors.find(name);
    EXPECT_NE(first, std::string::npos) << flown.errors;
    EXPECT_EQ(flown.errors.find(name, first + 1), std::string::npos) << flown.errors;
  }
}

}  // namespace
}  // namespace offing::test

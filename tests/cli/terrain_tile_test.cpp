// `offing terrain tile`, `render` and `fly` over what it makes.
#include <chrono>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/io/exr_image.h"
#include "host/io/height_maps/read_height_map.h"
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
  std::vector<std::string> make_terrain(int posts) const {
    const std::string side_m = std::to_string(10 * (posts - 1)), size = std::to_string(posts);
    const ProgramResult made =
        run_offing({"terrain", "generate", "--posts", size, "--side-m", side_m, "-o", path("ground.r32")});
    EXPECT_EQ(made.exit_code, 0) << made.errors;
    return {path("ground.r32"), "--raw-size", size + "x" + size, "--spacing-m", "10"};
  }
  std::vector<std::string> tile_command(const std::vector<std::string>& terrain,
                                        const std::string& store) const {
    std::vector<std::string> command{"terrain", "tile"};
    command.insert(command.end(), terrain.begin(), terrain.end());
    command.insert(command.end(), {"-o", path(store), "--json"});
    return command;
  }
  ProgramResult tile(const std::vector<std::string>& terrain, const std::string& store) const {
    return run_offing(tile_command(terrain, store));
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
// the same but for rounding (1e-5 of themselves), and colours to 0.1 of 255 on the mean: slopes are kept in
// 512ths.
TEST_F(TerrainTile, AStoreLooksAsItsMap) {
  const std::vector<std::string> terrain = make_terrain(600);
  const ProgramResult tiled = tile(terrain, "store");
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
  render(terrain, "map");
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
  EXPECT_LT(difference, 0.1);
}

// Fails if a walker on a store stands elsewhere than one on its map, on relief or without.
TEST_F(TerrainTile, WalksOnAStoreAsOnItsMap) {
  const std::vector<std::string> terrain = make_terrain(300);
  ASSERT_EQ(tile(terrain, "store").exit_code, 0);
  const auto eye_m = [&](const std::vector<std::string>& input, const std::string& relief) {
    std::vector<std::string> command{"terrain", "render"};
    command.insert(command.end(), input.begin(), input.end());
    command.insert(command.end(), {"-o", path("walk.png"), "--force", "--size", "16x16", "--camera", "walk",
                                   "--relief", relief, "--json"});
    const ProgramResult result = run_offing(command);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return nlohmann::json::parse(result.output)["eye_m"][1].get<double>();
  };
  const double on_map_m = eye_m(terrain, "2");
  EXPECT_NEAR(eye_m({path("store")}, "2"), on_map_m, 0.005);
  EXPECT_GT(std::abs(eye_m({path("store")}, "0") - on_map_m), 0.02);
}

// Fails if a run that was killed leaves something that the next run does not fix: the store must have the
// bytes of one that was made at once.
TEST_F(TerrainTile, GoesOnAfterAKill) {
  const std::vector<std::string> terrain = make_terrain(2049);
  ASSERT_EQ(tile(terrain, "once").exit_code, 0);
  for (int kill = 0; kill < 3; ++kill) {
    OffingProgram program(tile_command(terrain, "killed"));
    std::this_thread::sleep_for(std::chrono::milliseconds(40 + 60 * kill));
    program.send_signal(SIGKILL);
    program.wait();
  }
  const ProgramResult last = run_offing([&] {
    std::vector<std::string> command = tile_command(terrain, "killed");
    command.push_back("--force");  // a quick machine may have finished it
    return command;
  }());
  ASSERT_EQ(last.exit_code, 0) << last.errors;
  EXPECT_EQ(content_of("killed"), content_of("once"));
}

// Fails if info tells another map than that of the store, or flags that say how to read a map are passed
// over.
TEST_F(TerrainTile, TellsOfStores) {
  ASSERT_EQ(tile(make_terrain(300), "store").exit_code, 0);
  const ProgramResult info = run_offing({"terrain", "info", path("store"), "--json"});
  ASSERT_EQ(info.exit_code, 0) << info.errors;
  const auto json = nlohmann::json::parse(info.output);
  EXPECT_EQ(json["columns"], 300);
  EXPECT_EQ(json["spacing_x_m"], 10.0);
  EXPECT_EQ(json["tiles"], 5);
  EXPECT_THAT(run_offing({"terrain", "info", path("store")}).output, ::testing::HasSubstr("300 x 300"));
  const ProgramResult scaled =
      run_offing({"terrain", "height", path("store"), "--at", "5,5", "--scale", "2"});
  EXPECT_EQ(scaled.exit_code, 2);
  EXPECT_THAT(scaled.errors, ::testing::HasSubstr("found a tile store"));
}

// Fails if a store is asked and answers otherwise than its map, to the last digit where heights are read, to
// 1e-3 cells where rays are cast: the tiles that an answer needs are loaded, whatever their level.
TEST_F(TerrainTile, AStoreAnswersAsItsMap) {
  const std::vector<std::string> terrain = make_terrain(1100);
  ASSERT_EQ(tile(terrain, "store").exit_code, 0);
  const auto ask = [&](const std::string& command, const std::vector<std::string>& input,
                       const std::vector<std::string>& question) {
    std::vector<std::string> arguments{"terrain", command};
    arguments.insert(arguments.end(), input.begin(), input.end());
    arguments.insert(arguments.end(), question.begin(), question.end());
    const ProgramResult result = run_offing(arguments);
    EXPECT_EQ(result.exit_code, 0) << command << ": " << result.errors;
    return result.output;
  };
  const std::vector<std::string> store{path("store")};
  for (const auto& [command, question] : std::vector<std::pair<std::string, std::vector<std::string>>>{
           {"height", {"--at", "2560,7777", "--json"}},
           {"height", {"--at", "10990,10990", "--smooth-normals", "--json"}},
           {"profile", {"--from", "0,0", "--to", "10990,9000", "--step-m", "40"}},
           {"los", {"--from", "100,100,2", "--to", "10000,9000,20", "--json"}},
           {"los", {"--from", "100,100,2000", "--to", "10000,9000,20", "--curvature", "--json"}}}) {
    EXPECT_EQ(ask(command, store, question), ask(command, terrain, question)) << command;
  }
  const std::vector<std::string> down{"--from",     "500,3000,500",     "--direction",
                                      "1,-0.3,0.7", "--smooth-normals", "--json"};
  const auto expected = nlohmann::json::parse(ask("ray", terrain, down)),
             found = nlohmann::json::parse(ask("ray", store, down));
  EXPECT_EQ(found["cell"], expected["cell"]);
  EXPECT_NEAR(found["distance_m"].get<double>(), expected["distance_m"].get<double>(), 0.01);
  EXPECT_NEAR(found["normal"][1].get<double>(), expected["normal"][1].get<double>(), 1e-4);
}

// Fails if the viewshed of a store is not that of its map, or does not lie where it lies; or if one that is
// larger than the cache is begun.
TEST_F(TerrainTile, AStoreHasTheViewshedOfItsMap) {
  ASSERT_EQ(
      run_offing({"terrain", "generate", "--posts", "700", "--side-m", "6990", "-o", path("ground.tif")})
          .exit_code,
      0);
  ASSERT_EQ(tile({path("ground.tif")}, "store").exit_code, 0);
  const auto look = [&](const std::string& input, const std::string& name, std::vector<std::string> flags) {
    flags.insert(flags.begin(), {"terrain", "viewshed", path(input), "--observer", "3333,2111",
                                 "--observer-height-m", "30", "-o", path(name), "--json"});
    return run_offing(flags);
  };
  const auto seen = [&](const std::string& name) { return read_height_map(path(name)).map; };
  ASSERT_EQ(look("ground.tif", "map.tif", {}).exit_code, 0);
  ASSERT_EQ(look("store", "all.tif", {}).exit_code, 0);
  EXPECT_EQ(seen("all.tif").heights_m, seen("map.tif").heights_m);
  ASSERT_EQ(look("ground.tif", "near_map.tif", {"--radius-m", "1500"}).exit_code, 0);
  ASSERT_EQ(look("store", "near.tif", {"--radius-m", "1500"}).exit_code, 0);
  const HeightMap whole = seen("near_map.tif"), part = seen("near.tif");
  EXPECT_EQ(part.columns, 302);
  const int right = static_cast<int>(
                std::lround((part.georeference.origin_x - whole.georeference.origin_x) / 10.0)),
            down = static_cast<int>(
                std::lround((whole.georeference.origin_y - part.georeference.origin_y) / 10.0));
  EXPECT_EQ(right, 183);
  EXPECT_EQ(down, 61);
  double visible = 0.0;
  for (int row = 0; row < whole.rows; ++row) {
    for (int column = 0; column < whole.columns; ++column) {
      const int x = column - right, z = row - down;
      const bool is_inside = x >= 0 && x < part.columns && z >= 0 && z < part.rows;
      const float here = is_inside ? part.heights_m[part.index(x, z)] : 0.0f;
      ASSERT_EQ(here, whole.heights_m[whole.index(column, row)]) << column << ", " << row;
      visible += here / 255.0;
    }
  }
  EXPECT_GT(visible, 1000.0);
  ASSERT_EQ(tile(make_terrain(2049), "large").exit_code, 0);
  const ProgramResult refused = look("large", "large.tif", {"--cache-mb", "40"});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, ::testing::HasSubstr("--radius-m, or --cache-mb 49"));
  EXPECT_FALSE(fs::exists(path("large.tif")));
}

// A tile that breaks while a flight is under way, after its first frames: one warning for each that cannot be
// read from then on, no hole, and the flight goes on to its end. Fails if a reader keeps what it has once
// seen, or ends.
TEST_F(TerrainTile, FliesOnWhenTilesBreakUnderWay) {
  const std::vector<std::string> terrain = make_terrain(2049);
  ASSERT_EQ(tile(terrain, "store").exit_code, 0);
  // So small a cache, and so far a way, that tiles are read to the last frame.
  std::vector<std::string> command{"terrain",      "fly",        path("store"), "--frames", "60",
                                   "--every",      "6",          "--size",      "160x90",   "--speed-mps",
                                   "9000",         "--cache-mb", "40",          "--json",   "-o",
                                   path("frames"), "--compare"};
  command.insert(command.end(), terrain.begin(), terrain.end());
  OffingProgram flight(command);
  while (!fs::exists(path("frames/frame.000006.png")) && flight.is_running()) {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
  }
  int broken = 0;
  for (const auto& entry : fs::recursive_directory_iterator(path("store/0"))) {
    if (!entry.is_regular_file()) continue;
    if (++broken % 2 == 0) {
      fs::remove(entry.path());
    } else {
      fs::resize_file(entry.path(), 5000);
    }
  }
  EXPECT_EQ(broken, 64);
  EXPECT_FALSE(fs::exists(path("frames/frame.000054.png"))) << "it was over before";
  const ProgramResult flown = flight.wait();
  ASSERT_EQ(flown.exit_code, 0) << flown.errors;
  const auto json = nlohmann::json::parse(flown.output);
  const int failed = json["tiles"]["failed"].get<int>();
  EXPECT_GT(failed, 0);
  EXPECT_EQ(json["comparison"]["holes_flown"], 0);
  EXPECT_EQ(json["comparison"]["holes_loaded"], 0);
  EXPECT_TRUE(fs::exists(path("frames/frame.000054.png")));
  int warnings = 0;
  for (std::size_t at = flown.errors.find("is shown instead"); at != std::string::npos;
       at = flown.errors.find("is shown instead", at + 1)) {
    ++warnings;
  }
  EXPECT_EQ(warnings, failed) << flown.errors;
}

TEST_F(TerrainTile, KeepsWhatIsThere) {
  const std::vector<std::string> terrain = make_terrain(300);
  ASSERT_EQ(tile(terrain, "store").exit_code, 0);
  const ProgramResult again = tile(terrain, "store");
  EXPECT_EQ(again.exit_code, 2);
  EXPECT_THAT(again.errors, ::testing::HasSubstr("--force"));
  std::vector<std::string> forced = tile_command(terrain, "store");
  forced.push_back("--force");
  const ProgramResult third = run_offing(forced);
  EXPECT_EQ(third.exit_code, 0) << third.errors;
  EXPECT_EQ(nlohmann::json::parse(third.output)["tiles_kept"], 5);
}

// Fails if a store that lies among the maps that it is made of can be made, but not resumed or replaced.
TEST_F(TerrainTile, AStoreMayLieAmongItsMaps) {
  fs::create_directory(path("maps"));
  ASSERT_EQ(run_offing({"terrain", "generate", "--posts", "300", "-o", path("maps/a.tif")}).exit_code, 0);
  ASSERT_EQ(tile({path("maps")}, "maps/store").exit_code, 0);
  fs::remove(path("maps/store/store.toml"));
  const ProgramResult resumed = tile({path("maps")}, "maps/store");
  EXPECT_EQ(resumed.exit_code, 0) << resumed.errors;
  std::vector<std::string> forced = tile_command({path("maps")}, "maps/store");
  forced.push_back("--force");
  const ProgramResult replaced = run_offing(forced);
  EXPECT_EQ(replaced.exit_code, 0) << replaced.errors;
}

// Fails if a source that breaks off half-way costs a finished store anything.
TEST_F(TerrainTile, KeepsAStoreFromABrokenSource) {
  const std::string map = path("ground.tif");
  ASSERT_EQ(run_offing({"terrain", "generate", "--posts", "600", "-o", map}).exit_code, 0);
  ASSERT_EQ(tile({map}, "store").exit_code, 0);
  const auto before = content_of("store");
  ASSERT_EQ(
      run_offing({"terrain", "generate", "--posts", "600", "--seed", "5", "--force", "-o", map}).exit_code,
      0);
  fs::resize_file(map, fs::file_size(map) - fs::file_size(map) / 4);
  std::vector<std::string> forced = tile_command({map}, "store");
  forced.push_back("--force");
  const ProgramResult result = run_offing(forced);
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, ::testing::HasSubstr("ground.tif"));
  EXPECT_EQ(content_of("store"), before);
  EXPECT_FALSE(fs::exists(path("store/.new")));
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

// Fails if somebody's pictures are replaced unasked, or a flight is compared with other ground.
TEST_F(TerrainTile, FlightsKeepPicturesAndKnowTheirMap) {
  const std::vector<std::string> terrain = make_terrain(300);
  ASSERT_EQ(tile(terrain, "store").exit_code, 0);
  const auto fly = [&](std::vector<std::string> more) {
    more.insert(more.begin(), {"terrain", "fly", path("store"), "--frames", "2", "--every", "1", "--size",
                               "16x9", "-o", path("frames")});
    return run_offing(more);
  };
  fs::create_directory(path("frames"));
  std::ofstream(path("frames/frame.000001.png")) << "mine";
  const ProgramResult refused = fly({});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, ::testing::HasSubstr("frame.000001.png: expected a new file"));
  EXPECT_FALSE(fs::exists(path("frames/frame.000000.png")));
  EXPECT_EQ(fs::file_size(path("frames/frame.000001.png")), 4u);
  const ProgramResult sparse = run_offing({"terrain", "fly", path("store"), "--frames", "3", "--every", "2",
                                           "--size", "16x9", "-o", path("frames")});
  EXPECT_EQ(sparse.exit_code, 0) << sparse.errors;
  EXPECT_EQ(fs::file_size(path("frames/frame.000001.png")), 4u);
  const ProgramResult forced = fly({"--force"});
  EXPECT_EQ(forced.exit_code, 0) << forced.errors;
  EXPECT_GT(fs::file_size(path("frames/frame.000001.png")), 4u);
  const ProgramResult other =
      fly({"--force", "--compare", path("ground.r32"), "--raw-size", "300x300", "--spacing-m", "20"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_THAT(other.errors, ::testing::HasSubstr("20 x 20 m apart"));
}

// Fails if a flight shows sky where the map has ground, takes more memory for tiles than it may, or writes
// other pictures than it says.
TEST_F(TerrainTile, FliesOverAStore) {
  const std::vector<std::string> terrain = make_terrain(1500);
  ASSERT_EQ(tile(terrain, "store").exit_code, 0);
  std::vector<std::string> command{"terrain",      "fly",        path("store"), "--frames", "12",
                                   "--every",      "4",          "--size",      "160x90",   "--speed-mps",
                                   "3000",         "--cache-mb", "40",          "--json",   "-o",
                                   path("frames"), "--compare"};
  command.insert(command.end(), terrain.begin(), terrain.end());
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
  const std::vector<std::string> terrain = make_terrain(600);
  ASSERT_EQ(tile(terrain, "store").exit_code, 0);
  fs::remove(path("store/0/0001/0001.tile"));
  fs::resize_file(path("store/0/0001/0002.tile"), 5000);
  std::vector<std::string> command{"terrain", "fly",     path("store"), "--frames", "4",      "--every",  "2",
                                   "--size",  "640x360", "--speed-mps", "100",      "--json", "--compare"};
  command.insert(command.end(), terrain.begin(), terrain.end());
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

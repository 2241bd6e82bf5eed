// Scenes that somebody, or a failing disk, has spoiled.
#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>
#include <regex>
#include <string>
#include <string_view>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/moving_view.h"
#include "host/scene/prepare/own_billboards.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/prepare/scene_terrain.h"
#include "host/scene/prepare/sea.h"
#include "host/scene/schema/parameter_table.h"
#include "tests/io/temporary_folder.h"

namespace offing::scene {
namespace {

// A valid scene with every kind of value and section.
const std::string valid = R"(version = 1
[world]
seed = 42
latitude_deg = -33.9
[time]
fps = 30
[wind]
speed_mps = 12.5
[camera]
y_m = { keys = [{ t = 0, value = 5 }, { t = 2.5, value = 8 }], interpolation = "linear" }
yaw_deg.keys = [{ t = 0, value = 350 }, { t = 9, value = 10 }]
[sun]
time_utc = 2024-06-21T12:30:00+01:00
time_scale = 60
[sky]
ozone_du = 280
[render]
exposure_ev = -0.5
[ocean]
spectrum = "tma"
size = 64
spectrum_file = "buoy.data_spec"
[[ocean.cascade]]
patch_m = 300
[[ocean.swell]]
period_s = 11
direction_deg = 30
[[ocean.raindrop]]
x_m = 2.5
amplitude_m = -0.01
[[light]]
name = "lamp"
colour = { keys = [{ t = 0, value = [1, 0.5, 0] }, { t = 2, value = [0, 0, 1] }] }
[[mesh]]
shape = "head"
colour = [0.5, 0.25, 0]
[[mesh.highlight]]
light = "lamp"
nearest_m = [0, 1, 2]
opacity = { keys = [{ t = 0, value = 0 }, { t = 2, value = 1 }] }
[[mesh.highlight]]
texture = "star"
)";

// What comes of a text: "" for a scene that can be shown, else the message. Anything but Error fails.
std::string outcome(const std::string& text) {
  try {
    const Scene scene = parse_scene(text, "a.toml", "");
    view_at(scene, 1.0);
    lights_at(scene, 1.0);
    mesh_materials_at(scene, 1.0);
    mesh_rules_at(scene, 1.0);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_FALSE(error.hint().empty());
    return error.what();
  }
}

// Fails if a spoiled scene crashes, hangs, throws anything but our error, or is refused without line and
// column. 20,000 scenes with one to four bytes, words or lines changed, doubled, moved or lost; the seed is
// fixed.
TEST(HostileScene, IsReadOrRefusedWithItsPlace) {
  ASSERT_EQ(outcome(valid), "");
  const std::string words[] = {"nan",
                               "-inf",
                               "1e999",
                               "[[",
                               "]]",
                               "{",
                               "}",
                               "\"",
                               "\0\x01",
                               "\n",
                               "keys",
                               "t",
                               "value",
                               "=",
                               "[",
                               "99999999999999999999",
                               "true",
                               "\xff\xfe",
                               "2024-13-45T99:99:99Z",
                               "ocean.swell",
                               "'''",
                               "\\u0000"};
  const std::regex place("a\\.toml:[0-9]+:[0-9]+: [^]*");
  std::mt19937 random(11);
  const auto below = [&](std::size_t count) { return static_cast<std::size_t>(random() % count); };
  int refused = 0;
  for (int trial = 0; trial < 20'000; ++trial) {
    std::string text = valid;
    for (std::size_t change = 0; change <= below(4) && !text.empty(); ++change) {
      const std::size_t at = below(text.size()), length = below(30);
      switch (below(5)) {
        case 0:
          text[at] = static_cast<char>(random());
          break;
        case 1:
          text.erase(at, length);
          break;
        case 2:
          text.insert(at, text.substr(below(text.size()), length));
          break;
        case 3:
          text.insert(at, words[below(std::size(words))]);
          break;
        default:
          text.resize(at + 1);
      }
    }
    const std::string message = outcome(text);
    refused += message.empty() ? 0 : 1;
    ASSERT_TRUE(message.empty() || std::regex_match(message, place)) << message << "\n" << text;
    ASSERT_LT(message.size(), 600u) << message;
    ASSERT_EQ(message.find('\n'), std::string::npos) << message;
  }
  EXPECT_GT(refused, 10'000);  // most changes break something; some fall into numbers
  EXPECT_LT(refused, 20'000);
}

// Fails if a line break of the file gets into the message, which is one line.
TEST(HostileScene, IsRefusedInOneLine) {
  const std::string message = outcome("version = 1\na = f\n.i00rst = 0.0\n");
  EXPECT_NE(message, "");
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

// Fails if many keyframes or elements take more than time in proportion, or more than there may be are taken.
TEST(HostileScene, HoldsItsLimits) {
  const auto keys = [](int count) {
    std::string text = "version = 1\n[camera]\nx_m.keys = [";
    for (int i = 0; i < count; ++i) text += "{ t = " + std::to_string(i) + ", value = 1 },";
    return text + "]\n";
  };
  EXPECT_EQ(outcome(keys(10'000)), "");
  EXPECT_EQ(outcome(keys(10'001)), "a.toml:3:1: camera.x_m: expected 1 ... 10000 keys, found 10001");
}

// Fails if tables or lists in one another end the stack, however they are written: as headers, keys of many
// names, lists and tables of one line, and beside strings and comments that look like them.
TEST(HostileScene, IsRefusedWhereItIsDeep) {
  const auto repeated = [](const std::string& text, int count) {
    std::string all;
    for (int i = 0; i < count; ++i) all += text;
    return all;
  };
  const auto chain = [&](const std::string& name, int count) {
    return name + repeated("." + name, count - 1);
  };
  for (const int count : {33, 40'000}) {
    const std::string names = chain("c", count);
    for (const std::string& deep :
         {"[" + names + "]", "[[" + names + "]]", names + " = 1", "[" + chain("\"a.b\"", count) + "]",
          chain("'#'", count) + " = 1", chain(" a ", count) + " = 1", "a = " + repeated("[", count),
          "a = " + repeated("{b=", count), "a = [ \"\"\"b\"\"\"\"\", {" + names + " = 1} ]",
          "a = '''b''''' # '\n" + names + " = 1", "a = \"\\\"\"\n" + names + " = 1",
          "a = { b = 1, " + names + " = 1 }"}) {
      EXPECT_THAT(outcome("version = 1\n" + deep),
                  ::testing::HasSubstr("expected at most 32 nested names or brackets"))
          << deep.substr(0, 40) << " " << count;
    }
  }
  const std::string looks_deep = repeated("a.[{", 100);
  EXPECT_EQ(outcome("version = 1\n[wind] # " + looks_deep), "");
  for (const char* quote : {"'", "'''", "\"", "\"\"\""}) {
    EXPECT_EQ(outcome("version = 1\n[bench]\nname = " + (quote + looks_deep) + quote), "") << quote;
  }
}

/// A scene whose `key` names a file.
std::string naming(std::string_view key, const std::string& file) {
  std::string text = "version = 1\n";
  const std::string_view section = section_of(key);
  for (std::size_t dot = section.find('.');; dot = section.find('.', dot + 1)) {
    const std::string part(section.substr(0, dot));
    text += find_parameter(key)->section->is_repeated() ? "[[" + part + "]]\n" : "[" + part + "]\n";
    if (dot == std::string_view::npos) break;
  }
  return text + std::string(name_of(key)) + " = '" + file + "'\n";
}

/// What comes of reading it in a folder; "" if it is read.
std::string outcome_in(const std::filesystem::path& folder, const std::string& text, Trust trust) {
  try {
    parse_scene(text, "a.toml", folder, trust);
    return "";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_NE(error.hint(), "");
    return error.what();
  }
}

std::vector<std::string_view> keys_of_files() {
  std::vector<std::string_view> keys;
  for (const Parameter& row : parameter_table()) {
    if (row.rule == ParameterRule::file_name) keys.push_back(row.key);
  }
  return keys;
}

// Fails if a key of a file takes an address, trusted or not.
TEST(HostileScene, NamesNoAddress) {
  ASSERT_GE(keys_of_files().size(), 10u);
  for (const std::string_view key : keys_of_files()) {
    for (const char* address :
         {"https://127.0.0.1/a.tif", "/vsicurl/http://127.0.0.1/a.tif", "/vsimem/a", "s3://a/b"}) {
      EXPECT_THAT(outcome_in(".", naming(key, address), Trust::trusted),
                  ::testing::HasSubstr("got an address"))
          << key << " " << address;
    }
  }
}

// Fails if a key of a file leads an untrusted scene out of its folder, by a name or by a link, or keeps it
// from what lies in it.
TEST(HostileScene, StaysInItsFolderUnlessTrusted) {
  const TemporaryFolder folder;
  const std::filesystem::path own = folder.path() / "own";
  std::filesystem::create_directories(own / "deep");
  std::filesystem::create_directory(folder.path() / "own.other");
  std::filesystem::create_symlink("..", own / "up");
  std::filesystem::create_symlink(own, folder.path() / "link");
  const std::string outside = "file in " + std::filesystem::canonical(own).string() + " or below";
  for (const std::string_view key : keys_of_files()) {
    for (const char* name : {"/etc/passwd", "../a", "deep/../../a", "up/a", "../own.other/a"}) {
      EXPECT_THAT(outcome_in(own, naming(key, name), Trust::untrusted), ::testing::HasSubstr(outside))
          << key << " " << name;
      EXPECT_EQ(outcome_in(own, naming(key, name), Trust::trusted), "") << key << " " << name;
    }
    for (const std::string& name : {std::string("a"), std::string("deep/../a"), (own / "a").string(),
                                    (folder.path() / "link" / "a").string()}) {
      EXPECT_EQ(outcome_in(own, naming(key, name), Trust::untrusted), "") << key << " " << name;
    }
  }
}

// Fails if files that an untrusted scene's files lead to are read from elsewhere, though the names in the
// scene are its own.
TEST(HostileScene, IsNotLedAwayByItsFiles) {
  const TemporaryFolder folder;
  const std::filesystem::path own = folder.path() / "own";
  std::filesystem::create_directories(own / "puffs");
  const auto write = [](const std::filesystem::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
  };
  write(folder.path() / "secret.bin", std::string(36, 'x'));
  write(own / "ship.gltf",
        R"({"asset":{"version":"2.0"},"buffers":[{"uri":"../secret.bin","byteLength":36}]})");
  const auto said = [](const auto& read) -> std::string {
    try {
      read();
      return "";
    } catch (const Error& error) {
      return error.what();
    }
  };
  const auto scene = [&](Trust trust) {
    return parse_scene(naming("mesh.file", "ship.gltf"), "a.toml", own, trust);
  };
  EXPECT_THAT(said([&] { prepare_meshes(scene(Trust::untrusted)); }),
              ::testing::HasSubstr("found one outside"));
  EXPECT_THAT(said([&] { prepare_meshes(scene(Trust::trusted)); }),
              ::testing::Not(::testing::HasSubstr("found one outside")));

  for (int i = 0; i < CLOUD_TEXTURES; ++i) {
    std::filesystem::create_symlink(folder.path() / "secret.bin",
                                    own / "puffs" / (std::to_string(i) + ".png"));
  }
  EXPECT_THAT(said([&] {
                own_billboards(
                    parse_scene(naming("clouds.crisp_billboards", "puffs"), "a.toml", own, Trust::untrusted));
              }),
              ::testing::HasSubstr("found one outside"));

  const std::string header = "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) ... >\n";
  write(own / "buoy.data_spec", header + "2020 06 08 03 50 0.225 0.100 (0.100) 2.000 (0.200)\n");
  std::filesystem::create_symlink(folder.path() / "secret.bin", own / "buoy.swdir");
  EXPECT_THAT(said([&] {
                prepare_sea(parse_scene(naming("ocean.spectrum_file", "buoy.data_spec"), "a.toml", own,
                                        Trust::untrusted));
              }),
              ::testing::HasSubstr("found one outside"));
}

// Fails if each of very many faults is kept, although ten are reported: 100,000 took five seconds.
TEST(HostileScene, IsRefusedAtOnceForManyFaults) {
  std::string text = "version = 1\n";
  for (int i = 0; i < 100'000; ++i) text += "k" + std::to_string(i) + " = 1\n";
  const std::clock_t start = std::clock();
  EXPECT_THROW(parse_scene(text, "a.toml", ""), ErrorList);
  EXPECT_LT(static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC, 2.5);
}

// Fails if a scene may name a VRT, or a person may not.
TEST(HostileScene, NamesNoVrt) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "map.asc")
      << "ncols 2\nnrows 2\nxllcenter 0\nyllcenter 0\ncellsize 30\n1 2\n3 4\n";
  std::ofstream(folder.path() / "map.tif")
      << R"(<VRTDataset rasterXSize="2" rasterYSize="2"><GeoTransform>0,30,0,0,0,-30</GeoTransform>)"
         R"(<VRTRasterBand dataType="Float32" band="1"><SimpleSource><SourceFilename relativeToVRT="1">map.asc)"
         R"(</SourceFilename><SourceBand>1</SourceBand></SimpleSource></VRTRasterBand></VRTDataset>)";
  Scene scene = parse_scene("version = 1\n[terrain]\nfile = 'map.tif'\nhorizontal_unit = 'metre'\n", "a.toml",
                            folder.path());
  try {
    prepare_terrain(scene);
    ADD_FAILURE() << "a VRT was read";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), ::testing::HasSubstr("a.toml:3:8: terrain.file: "));
    EXPECT_THAT(error.what(), ::testing::HasSubstr("found a VRT"));
  }
  scene.named_files.clear();  // as if a flag had named it
  EXPECT_TRUE(prepare_terrain(scene));
}

}  // namespace
}  // namespace offing::scene

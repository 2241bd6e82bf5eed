#include <cmath>
#include <csignal>
#include <fstream>
#include <set>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/io/exr_image.h"
#include "tests/cli/folder_content.h"
#include "tests/cli/offing_program.h"

// `offing ocean bake` as its users run it, at sizes that take moments.

namespace offing::test {
namespace {

using testing::Contains;
using testing::Key;
using testing::UnorderedElementsAre;

constexpr int size = 32;

class Bake : public testing::Test {
 protected:
  std::filesystem::path folder(const char* name) const { return root_.path() / name; }

  /// A small sea of two cascades, baked to `name`.
  std::vector<std::string> command(const char* name, const std::vector<std::string>& more) const {
    std::vector<std::string> arguments = {
        "ocean", "bake",  "--size", "32", "--patch-m",           "200,23",       "--seed",
        "3",     "--fps", "8",      "-o", folder(name).string(), "--foam-onset", "0.9"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return arguments;
  }

  ProgramResult bake(const char* name, const std::vector<std::string>& more) const {
    const ProgramResult result = run_offing(command(name, more));
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return result;
  }

 private:
  TemporaryFolder root_;
};

std::set<std::string> file_names(const std::filesystem::path& folder) {
  std::set<std::string> names;
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    names.insert(entry.path().filename().string());
  }
  return names;
}

template <class Value>
Value attribute(const ExrContent& image, const std::string& name) {
  for (const auto& [key, value] : image.attributes) {
    if (key == name) {
      return std::get<Value>(value);
    }
  }
  ADD_FAILURE() << "no attribute " << name;
  return {};
}

std::set<std::string> channel_names(const ExrContent& image) {
  std::set<std::string> names;
  for (const ExrContent::Channel& channel : image.channels) {
    names.insert(channel.name);
  }
  return names;
}

const std::set<std::string> default_channels = {"displacement.X",
                                                "displacement.Y",
                                                "displacement.Z",
                                                "slope.X",
                                                "slope.Z",
                                                "gradient.XX",
                                                "gradient.XZ",
                                                "gradient.ZZ",
                                                "jacobian",
                                                "jacobian_min_eigenvalue",
                                                "foam"};

// Fails if file names, channel names or header depart from what is documented: scripts and shaders rely on
// them.
TEST_F(Bake, WritesTheDocumentedFiles) {
  bake("out", {"--frames", "4:5"});
  EXPECT_THAT(folder_content(folder("out")),
              UnorderedElementsAre(Key("ocean.c0.0004.exr"), Key("ocean.c0.0005.exr"),
                                   Key("ocean.c1.0004.exr"), Key("ocean.c1.0005.exr"), Key("ocean.json")));
  const ExrContent image = read_exr(folder("out") / "ocean.c1.0005.exr");
  EXPECT_EQ(image.width, size);
  EXPECT_EQ(image.height, size);
  EXPECT_EQ(channel_names(image), default_channels);
  EXPECT_EQ(attribute<double>(image, "time_s"), 5.0 / 8.0);
  EXPECT_EQ(attribute<double>(image, "patch_size_m"), 23.0);
  EXPECT_EQ(attribute<std::string>(image, "seed"), "3");
  EXPECT_EQ(attribute<int>(image, "tileable"), 1);
  EXPECT_EQ(attribute<std::string>(image, "scene_hash").size(), 32u);
  EXPECT_THAT(attribute<std::string>(image, "spectrum"), testing::StartsWith("jonswap"));
  EXPECT_FALSE(attribute<std::string>(image, "offing_version").empty());
}

// Fails if --combined loses a cascade, or its pixels differ from those of single files.
TEST_F(Bake, CombinesCascadesAsLayers) {
  bake("single", {"--frames", "0:0"});
  bake("combined", {"--frames", "0:0", "--combined"});
  EXPECT_THAT(folder_content(folder("combined")),
              UnorderedElementsAre(Key("ocean.0000.exr"), Key("ocean.json")));
  const ExrContent combined = read_exr(folder("combined") / "ocean.0000.exr");
  EXPECT_EQ(combined.channels.size(), 2 * default_channels.size());
  for (const std::string cascade : {"c0", "c1"}) {
    const ExrContent single = read_exr(folder("single") / ("ocean." + cascade + ".0000.exr"));
    for (const std::string& name : default_channels) {
      EXPECT_EQ(combined.channel(cascade + "." + name), single.channel(name)) << cascade << name;
    }
    EXPECT_EQ(attribute<double>(combined, cascade + ".patch_size_m"),
              attribute<double>(single, "patch_size_m"));
  }
}

// Fails if a second run does anything: a bake goes on where it was stopped.
TEST_F(Bake, KeepsFinishedFrames) {
  bake("out", {"--frames", "0:2"});
  const auto before = folder_content(folder("out"));
  const auto time = std::filesystem::last_write_time(folder("out") / "ocean.c0.0001.exr");
  const ProgramResult again = bake("out", {"--frames", "0:2"});
  EXPECT_THAT(again.output, testing::HasSubstr("0 frames written, 3 there already"));
  EXPECT_EQ(folder_content(folder("out")), before);
  EXPECT_EQ(std::filesystem::last_write_time(folder("out") / "ocean.c0.0001.exr"), time);
}

// Fails if a damaged, cut, missing or empty file passes as finished, or is remade differently.
TEST_F(Bake, RemakesDamagedFrames) {
  bake("out", {"--frames", "0:4"});
  const auto before = folder_content(folder("out"));
  std::string flipped = before.at("ocean.c0.0000.exr");
  flipped[flipped.size() / 2] ^= 0x55;
  std::ofstream(folder("out") / "ocean.c0.0000.exr", std::ios::binary) << flipped;
  std::filesystem::resize_file(folder("out") / "ocean.c1.0001.exr", 700);
  std::filesystem::remove(folder("out") / "ocean.c0.0002.exr");
  std::filesystem::resize_file(folder("out") / "ocean.c0.0003.exr", 0);
  const ProgramResult again = bake("out", {"--frames", "0:4"});
  EXPECT_THAT(again.output, testing::HasSubstr("4 frames written, 1 there already"));
  EXPECT_TRUE(folder_content(folder("out")) == before);
}

// Fails if what a killed bake had begun to write stays for ever, or if another program's file goes.
TEST_F(Bake, RemovesWhatKilledBakesLeft) {
  std::filesystem::create_directory(folder("out"));
  for (const char* name :
       {".ocean.c0.0001.exr.0123456789abcdef.partial", ".ocean.0001.png.0123456789abcdef.partial",
        ".contact_sheet.png.0123456789abcdef.partial", ".notes.txt.0123456789abcdef.partial"}) {
    std::ofstream(folder("out") / name) << "half";
  }
  bake("out", {"--frames", "0:0"});
  EXPECT_THAT(file_names(folder("out")),
              UnorderedElementsAre("ocean.json", "ocean.c0.0000.exr", "ocean.c1.0000.exr",
                                   ".notes.txt.0123456789abcdef.partial"));
}

// Fails if frames depend on how they were shared out, or on what was made before them.
TEST_F(Bake, SharesAndOrderDoNotMatter) {
  bake("whole", {"--frames", "0:6"});
  bake("shares", {"--frames", "0:6", "--chunk", "2/3"});
  bake("shares", {"--frames", "0:6", "--chunk", "1/3"});
  bake("shares", {"--frames", "0:6", "--chunk", "3/3"});
  EXPECT_TRUE(folder_content(folder("whole")) == folder_content(folder("shares")));
  bake("late", {"--frames", "6"});
  EXPECT_TRUE(file_content(folder("late") / "ocean.c0.0006.exr") ==
              file_content(folder("whole") / "ocean.c0.0006.exr"));
}

// Fails if two processes at the same folder disturb each other.
TEST_F(Bake, ProcessesShareAFolder) {
  bake("whole", {"--frames", "0:7"});
  OffingProgram first(command("shared", {"--frames", "0:7", "--chunk", "1/2"}));
  OffingProgram second(command("shared", {"--frames", "0:7", "--chunk", "2/2"}));
  EXPECT_EQ(first.wait().exit_code, 0);
  EXPECT_EQ(second.wait().exit_code, 0);
  EXPECT_TRUE(folder_content(folder("whole")) == folder_content(folder("shared")));
}

// Fails if frames of two seas are mixed in silence, or --force leaves one of the old sea's files (contact
// sheet included) beside the new one.
TEST_F(Bake, RefusesOrReplacesAnotherScene) {
  bake("out", {"--frames", "0:1", "--mesh", "ply", "--preview"});
  const ProgramResult refused = run_offing(command("out", {"--frames", "0:1", "--wind-speed-mps", "14"}));
  EXPECT_EQ(refused.exit_code, 2);
  bake("out", {"--frames", "0:1", "--wind-speed-mps", "14", "--force"});
  bake("fresh", {"--frames", "0:1", "--wind-speed-mps", "14"});
  EXPECT_TRUE(folder_content(folder("out")) == folder_content(folder("fresh")));
}

// Fails if --force leaves files of the old sea's further cascades, or of its other layout, beside the new
// frames, or touches frames that it does not make or a file that no bake wrote.
TEST_F(Bake, ReplacesFramesOfMoreCascades) {
  bake("out", {"--frames", "0:1"});
  std::ofstream(folder("out") / "ocean.c2.0000.exr") << "mine";
  const std::vector<std::string> one_cascade = {
      "ocean",    "bake", "--size",  "32", "--patch-m",           "200", "--fps", "8",
      "--frames", "0:0",  "--force", "-o", folder("out").string()};
  ASSERT_EQ(run_offing(one_cascade).exit_code, 0);
  EXPECT_THAT(file_names(folder("out")),
              UnorderedElementsAre("ocean.json", "ocean.c0.0000.exr", "ocean.c0.0001.exr",
                                   "ocean.c1.0001.exr", "ocean.c2.0000.exr"));
  EXPECT_EQ(file_content(folder("out") / "ocean.c2.0000.exr"), "mine");
  bake("out", {"--frames", "1:1", "--combined", "--force"});
  EXPECT_THAT(file_names(folder("out")),
              UnorderedElementsAre("ocean.json", "ocean.c0.0000.exr", "ocean.0001.exr", "ocean.c2.0000.exr"));
}

// Fails if the hash overlooks a parameter that changes pixels, or changes with one that does not.
TEST_F(Bake, HashFollowsWhatShapesPixels) {
  bake("out", {"--frames", "0:0"});
  for (const std::vector<std::string>& more :
       std::vector<std::vector<std::string>>{{"--choppiness", "0.5"},
                                             {"--foam-decay-s", "1"},
                                             {"--fps", "9"},
                                             {"--half"},
                                             {"--velocity"},
                                             {"--compression", "piz"},
                                             {"--loop-period-s", "20"},
                                             {"--depth-m", "9"},
                                             {"--patch-m", "201,23"}}) {
    std::vector<std::string> arguments = command("out", {"--frames", "0:0"});
    arguments.insert(arguments.end(), more.begin(), more.end());
    if (more[0] == "--patch-m") {
      arguments.erase(std::find(arguments.begin(), arguments.end(), "--patch-m"),
                      std::find(arguments.begin(), arguments.end(), "--patch-m") + 2);
    }
    EXPECT_EQ(run_offing(arguments).exit_code, 2) << more[0];
  }
  const ProgramResult same = bake("out", {"--frames", "0:0", "--wind-speed-mps", "10", "--cascades", "2"});
  EXPECT_THAT(same.output, testing::HasSubstr("0 frames written, 1 there already"));
}

// Fails if a wind from 290 degrees is not one that travels toward 20 degrees past east: the hash tells.
TEST_F(Bake, TakesBearings) {
  bake("out", {"--frames", "0:0", "--wind-direction-deg", "20"});
  const ProgramResult same = bake("out", {"--frames", "0:0", "--wind-direction-deg", "290", "--compass"});
  EXPECT_THAT(same.output, testing::HasSubstr("0 frames written, 1 there already"));
}

// Fails if optional outputs are missing, or spoil the maps.
TEST_F(Bake, WritesMeshesPicturesAndVelocity) {
  bake("plain", {"--frames", "0:1"});
  bake("out", {"--frames", "0:1", "--mesh", "obj", "--preview"});
  const auto content = folder_content(folder("out"));
  EXPECT_THAT(content, Contains(Key("ocean.0001.obj")));
  EXPECT_THAT(content, Contains(Key("ocean.0001.png")));
  EXPECT_THAT(content, Contains(Key("contact_sheet.png")));
  EXPECT_TRUE(content.at("ocean.c0.0001.exr") == file_content(folder("plain") / "ocean.c0.0001.exr"));
  bake("velocity", {"--frames", "0:0", "--channels", "displacement", "--velocity"});
  EXPECT_THAT(channel_names(read_exr(folder("velocity") / "ocean.c0.0000.exr")),
              UnorderedElementsAre("displacement.X", "displacement.Y", "displacement.Z", "velocity.X",
                                   "velocity.Y", "velocity.Z"));
}

// Fails if the depth of the velocity is ignored, not told in the header, or overlooked by the hash. Swell of
// 8 s in deep water, k = w^2 / g = 0.0629 rad/m, moves e^{-10 k} = 0.533 as fast 10 m down; its modes lie up
// to 12 % of k apart on this patch, thus within 0.45 ... 0.62.
TEST_F(Bake, WritesVelocityAtDepth) {
  const auto swell = [&](const char* name, const char* depth_m) {
    return std::vector<std::string>{"ocean",
                                    "bake",
                                    "--size",
                                    "32",
                                    "--patch-m",
                                    "800",
                                    "--spectrum",
                                    "swell",
                                    "--swell-period-s",
                                    "8",
                                    "--frames",
                                    "0:0",
                                    "--velocity-depth-m",
                                    depth_m,
                                    "-o",
                                    folder(name).string()};
  };
  const auto speed_mps = [&](const char* name) {
    double sum = 0.0;
    const ExrContent image = read_exr(folder(name) / "ocean.c0.0000.exr");
    for (const char* channel : {"velocity.X", "velocity.Y", "velocity.Z"}) {
      for (const float value : image.channel(channel)) {
        sum += static_cast<double>(value) * value;
      }
    }
    return std::sqrt(sum / (size * size));
  };
  ASSERT_EQ(run_offing(swell("top", "0")).exit_code, 0);
  ASSERT_EQ(run_offing(swell("deep", "10")).exit_code, 0);
  EXPECT_EQ(attribute<double>(read_exr(folder("deep") / "ocean.c0.0000.exr"), "velocity_depth_m"), 10.0);
  EXPECT_GT(speed_mps("deep") / speed_mps("top"), 0.45);
  EXPECT_LT(speed_mps("deep") / speed_mps("top"), 0.62);
  EXPECT_EQ(run_offing(swell("deep", "9")).exit_code, 2);
}

// Fails if the pictures or the contact sheet depend on which process made a frame, and thus on whether it is
// read back.
TEST_F(Bake, PicturesDoNotDependOnResuming) {
  bake("whole", {"--frames", "0:30", "--preview"});
  const auto whole = folder_content(folder("whole"));
  EXPECT_THAT(whole, Contains(Key("contact_sheet.png")));
  bake("shares", {"--frames", "0:30", "--preview", "--chunk", "2/2"});
  bake("shares", {"--frames", "0:30", "--preview", "--chunk", "1/2"});
  EXPECT_TRUE(folder_content(folder("shares")) == whole);
  std::filesystem::remove(folder("whole") / "contact_sheet.png");
  for (const char* name : {"ocean.0000.png", "ocean.0030.png", "ocean.c1.0013.exr"})
    std::filesystem::remove(folder("whole") / name);
  const ProgramResult again = bake("whole", {"--frames", "0:30", "--preview"});
  EXPECT_THAT(again.output, testing::HasSubstr("3 frames written, 28 there already"));
  EXPECT_TRUE(folder_content(folder("whole")) == whole);
}

// Fails if pictures asked for later are not added to finished frames.
TEST_F(Bake, AddsWhatIsAskedLater) {
  bake("out", {"--frames", "0:1"});
  bake("out", {"--frames", "0:1", "--mesh", "ply"});
  EXPECT_THAT(folder_content(folder("out")), Contains(Key("ocean.0000.ply")));
}

// Fails if the exported spectrum cannot lie in the folder that the bake makes, or is written beside a folder
// that the bake then refuses.
TEST_F(Bake, ExportsOnceTheFolderIsThere) {
  bake("out", {"--frames", "0:0", "--export-spectrum", (folder("out") / "sea.spec").string()});
  EXPECT_THAT(file_names(folder("out")), Contains("sea.spec"));
  const ProgramResult refused = run_offing(command(
      "out", {"--frames", "0:0", "--wind-speed-mps", "14", "--export-spectrum", folder("b.spec").string()}));
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_FALSE(std::filesystem::exists(folder("b.spec")));
}

// Fails if windows of wakes are not those that queries answer from, or lie elsewhere: at texels of the
// window, heights with and without it in the scene differ by the map's, to the float's digits of 10 cm waves
// on metres.
TEST_F(Bake, WakeWindowsHaveTheirPlace) {
  const std::string sea =
      "version = 1\n[ocean]\nsize = 32\nhs_m = 0.3\ntp_s = 4\nchoppiness = 0\n[time]\nfps = 8\n";
  std::ofstream(folder("open.toml")) << sea;
  std::ofstream(folder("wake.toml"))
      << sea << "[[ocean.wake]]\nlength_m = 64\ncells = 64\nx_m = 100\nz_m = -30\nhistory_s = 4\n"
      << "[[ocean.wake.hull]]\nlength_m = 10\nx_m = 100\nz_m = -30\nspeed_mps = 3\n";
  const auto bake_scene = [&](const char* name, const std::vector<std::string>& more) {
    std::vector<std::string> arguments = {"ocean",   "bake", folder("wake.toml").string(), "--frames", "4:5",
                                          "--wakes", "-o",   folder(name).string()};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return run_offing(arguments);
  };
  ASSERT_EQ(bake_scene("out", {"--velocity"}).exit_code, 0);
  const ExrContent window = read_exr(folder("out") / "ocean.w0.0005.exr");
  ASSERT_EQ(window.width, 64);
  const double x_m = attribute<double>(window, "origin_x_m"), z_m = attribute<double>(window, "origin_z_m");
  EXPECT_EQ(attribute<double>(window, "texel_m"), 1.0);
  EXPECT_EQ(attribute<double>(window, "time_s"), 0.625);
  double highest_m = 0.0;
  std::ofstream points(folder("points.csv"));
  for (int row = 4; row < 60; row += 5) {
    for (int column = 4; column < 60; column += 5) points << x_m + column << ',' << z_m + row << '\n';
  }
  points.close();
  const auto heights_m = [&](const char* scene) {
    const ProgramResult result =
        run_offing({"ocean", "query", folder(scene).string(), "--points", folder("points.csv").string(),
                    "--times", "0.5:0.625:0.125", "--exact"});
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    std::vector<double> heights;
    std::istringstream lines(result.output);
    std::string line;
    for (std::getline(lines, line); std::getline(lines, line);) {
      std::istringstream cells(line);
      std::string cell;
      for (int i = 0; i < 4; ++i) std::getline(cells, cell, ',');
      heights.push_back(std::stod(cell));
    }
    heights.erase(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(heights.size() / 2));
    return heights;
  };
  const std::vector<double> with = heights_m("wake.toml"), without = heights_m("open.toml");
  ASSERT_EQ(with.size(), 144u);
  ASSERT_EQ(without.size(), 144u);
  std::size_t point = 0;
  for (std::size_t row = 4; row < 60; row += 5) {
    for (std::size_t column = 4; column < 60; column += 5, ++point) {
      const double height_m = window.channel("height")[64 * row + column];
      EXPECT_NEAR(with[point] - without[point], height_m, 1e-5) << row << ' ' << column;
      highest_m = std::max(highest_m, std::abs(height_m));
    }
  }
  EXPECT_GT(highest_m, 0.01);
  EXPECT_THAT(window.channel("rise"), testing::SizeIs(64u * 64u));

  // Shares of the frames hold the same wake.
  ASSERT_EQ(bake_scene("share", {"--velocity", "--chunk", "2/2"}).exit_code, 0);
  EXPECT_EQ(read_exr(folder("share") / "ocean.w0.0005.exr").channel("height"), window.channel("height"));

  ASSERT_EQ(bake_scene("rgb", {"--layout", "rgb", "--axes", "z-up"}).exit_code, 0);
  const ExrContent height = read_exr(folder("rgb") / "ocean.w0_height.0005.exr");
  EXPECT_EQ(height.channel("Y"), window.channel("height"));
  EXPECT_EQ(attribute<double>(height, "origin_y_m"), -z_m);
  const auto description = nlohmann::json::parse(std::ifstream(folder("rgb") / "ocean.json"));
  EXPECT_EQ(description["wakes"][0]["texel_m"], 1.0);
  EXPECT_EQ(description["wakes"][0]["maps"]["foam"]["file"], "ocean.w0_foam.%04d.exr");
  EXPECT_TRUE(description["left_out"].empty());
  EXPECT_THAT(run_offing(command("none", {"--frames", "0:0", "--wakes"})).errors,
              testing::HasSubstr("--wakes: expected a scene with [[ocean.wake]], found none"));
}

// Fails if a bake that refuses an exported file of another sea leaves a folder behind.
TEST_F(Bake, RefusesAnOtherExportAtOnce) {
  std::ofstream(folder("b.spec")) << "another";
  const ProgramResult refused =
      run_offing(command("fresh", {"--frames", "0:0", "--export-spectrum", folder("b.spec").string()}));
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_EQ(refused.output, "");
  EXPECT_FALSE(std::filesystem::exists(folder("fresh")));
}

// Fails if a loop does not return to its first frame, bit by bit: foam too, whose past lies in the loop
// before.
TEST_F(Bake, LoopsExactly) {
  bake("out", {"--frames", "0:0", "--loop-period-s", "2"});
  bake("out", {"--frames", "16:16", "--loop-period-s", "2"});
  const ExrContent first = read_exr(folder("out") / "ocean.c0.0000.exr");
  const ExrContent again = read_exr(folder("out") / "ocean.c0.0016.exr");
  for (const std::string& name : default_channels) {
    EXPECT_EQ(first.channel(name), again.channel(name)) << name;
  }
}

// Fails if 16-bit files differ from 32-bit ones by more than the rounding of a half: 2^-11 relative, 2^-25
// absolute.
TEST_F(Bake, HalvesRound) {
  bake("full", {"--frames", "0:0"});
  bake("half", {"--frames", "0:0", "--half"});
  const ExrContent full = read_exr(folder("full") / "ocean.c0.0000.exr");
  const ExrContent half = read_exr(folder("half") / "ocean.c0.0000.exr");
  for (const std::string& name : default_channels) {
    for (std::size_t i = 0; i < full.channel(name).size(); ++i) {
      ASSERT_NEAR(half.channel(name)[i], full.channel(name)[i],
                  std::abs(full.channel(name)[i]) / 2048 + 3e-8f);
    }
  }
}

// Fails if the scene's time span is not what a bake without --frames makes: [start, end) in frames.
TEST_F(Bake, TakesFramesFromTheScene) {
  const auto scene = folder("a.toml");
  std::ofstream(scene) << "version = 1\n[time]\nfps = 4\nstart_s = 0.5\nend_s = 1.25\n[ocean]\nsize = 16\n"
                          "cascade_count = 1\n";
  const ProgramResult result = run_offing({"ocean", "bake", scene.string(), "-o", folder("out").string()});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(folder_content(folder("out")),
              UnorderedElementsAre(Key("ocean.json"), Key("ocean.c0.0002.exr"), Key("ocean.c0.0003.exr"),
                                   Key("ocean.c0.0004.exr")));
}

// Fails if the summary for scripts is not JSON, or if the shares of energy do not add up to the spectrum's.
TEST_F(Bake, SummarisesForScripts) {
  const ProgramResult result = bake("out", {"--frames", "0:0", "--json", "--quiet"});
  EXPECT_EQ(result.errors, "");
  const nlohmann::json json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["frames_written"], 1);
  double sum = json["out_of_band_m2"].get<double>();
  for (const auto& cascade : json["cascades"]) {
    sum += cascade["m0_m2"].get<double>();
  }
  EXPECT_NEAR(sum, json["m0_m2"].get<double>(), 1e-4 * sum);
}

// Fails if Ctrl-C loses finished frames, leaves partial ones, or if the bake cannot go on afterwards.
TEST_F(Bake, StopsCleanly) {
  bake("whole", {"--frames", "0:40"});
  OffingProgram program(command("out", {"--frames", "0:40"}));
  while (program.is_running() && !std::filesystem::exists(folder("out") / "ocean.c1.0001.exr")) {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  program.send_signal(SIGINT);
  const ProgramResult stopped = program.wait();
  ASSERT_EQ(stopped.exit_code, 130) << stopped.errors;
  EXPECT_THAT(stopped.errors, testing::HasSubstr("error: "));
  EXPECT_THAT(stopped.errors, testing::HasSubstr("hint: run the same command again"));
  const auto whole = folder_content(folder("whole"));
  for (const auto& [name, bytes] : folder_content(folder("out"))) {
    ASSERT_THAT(whole, Contains(Key(name)));
    EXPECT_TRUE(whole.at(name) == bytes) << name;
  }
  bake("out", {"--frames", "0:40"});
  EXPECT_TRUE(folder_content(folder("out")) == whole);
}

}  // namespace
}  // namespace offing::test

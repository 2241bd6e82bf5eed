// The rule for outputs that all programs share; output_flags_test.py tries it at each flag.
#include "host/command_line/new_output.h"

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/io/atomic_file.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/expect_error.h"

namespace offing {
namespace {

namespace fs = std::filesystem;

class NewOutput : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string leave(const std::string& name) const {
    std::ofstream(path(name)) << "left";
    return path(name);
  }

  TemporaryFolder folder_;
};

// Fails if what a killed run has begun to write stays for ever, or what a living one writes goes, or a file
// of another output.
TEST_F(NewOutput, RemovesWhatKilledRunsLeft) {
  const std::string killed = leave(".out.csv.0123456789abcdef.partial"),
                    other = leave(".other.csv.0123456789abcdef.partial"),
                    frame = leave(".out_0003.png.0123456789abcdef.partial");
  const AtomicFile living(path("out.csv"));
  require_new(path("out.csv"), Existing::keep);
  EXPECT_FALSE(fs::exists(killed));
  EXPECT_TRUE(fs::exists(living.temporary()));
  EXPECT_TRUE(fs::exists(other));
  EXPECT_TRUE(fs::exists(frame));
  require_new_frames({"--record", path("out_%04d.png"), ""}, {0, 9}, Existing::keep, {});
  EXPECT_FALSE(fs::exists(frame));
}

// Fails if a frame that exists is missed, if one beyond the range is counted, or if each of ten million
// frames is looked up, which takes a minute.
TEST_F(NewOutput, LooksForFramesInTheFolder) {
  const FrameName names("--record", path("out_%04d.png"), "");
  leave("out_0007.png");
  leave("out_7.png");
  require_new_frames(names, {8, 9'999'999}, Existing::keep, {});
  require_new_frames(names, {0, 6}, Existing::keep, {});
  test::expect_error(ErrorKind::bad_usage, "out_0007.png: expected a new file", [&] {
    require_new_frames(names, {0, 7}, Existing::keep, {});
  });
  require_new_frames(names, {0, 7}, Existing::replace, {});
  require_new_frames(names, {0, 7}, Existing::keep, {}, 2);
  test::expect_error(ErrorKind::bad_usage, "out_0007.png: expected a new file", [&] {
    require_new_frames(names, {1, 7}, Existing::keep, {}, 2);
  });
  const GivenInputs inputs{{path("out_0007.png")}};
  test::expect_error(ErrorKind::bad_usage, "an input of this command", [&] {
    require_new_frames(names, {0, 7}, Existing::replace, inputs);
  });
  fs::create_directories(path("3"));
  leave("3/a.png");
  test::expect_error(ErrorKind::bad_usage, "3/a.png", [&] {
    require_new_frames({"--record", path("%d/a.png"), ""}, {3, 4}, Existing::keep, {});
  });
}

// Fails if a folder counts as a file that --force would replace.
TEST_F(NewOutput, ReplacesNoFolders) {
  fs::create_directories(path("folder.csv"));
  for (const Existing existing : {Existing::keep, Existing::replace}) {
    test::expect_error(ErrorKind::file, "expected a file name, found a folder",
                       [&] { require_new(path("folder.csv"), existing); });
  }
}

// Fails if a file of a folder that is read can be written over, at any depth of a tile store; or if one can
// not that lies deeper below a folder of maps, where nothing is read.
TEST_F(NewOutput, KeepsFilesOfFoldersThatAreRead) {
  fs::create_directories(path("maps/west"));
  leave("maps/a.tif");
  leave("maps/west/a.tif");
  const auto expect_input = [&](const char* name) {
    test::expect_error(ErrorKind::bad_usage, "an input of this command",
                       [&] { require_new(path(name), Existing::replace, {{path("maps")}}); });
  };
  expect_input("maps/a.tif");
  require_new(path("maps/west/a.tif"), Existing::replace, {{path("maps")}});
  require_new(path("maps/b.tif"), Existing::replace, {{path("maps")}});
  leave("maps/store.toml");
  expect_input("maps/west/a.tif");
}

// Fails if a link that leads nowhere is replaced without --force: it is somebody's, as a file is.
TEST_F(NewOutput, KeepsLinksThatLeadNowhere) {
  fs::create_symlink("gone", path("out.csv"));
  test::expect_error(ErrorKind::bad_usage, "out.csv: expected a new file",
                     [&] { require_new(path("out.csv"), Existing::keep); });
  require_new(path("out.csv"), Existing::replace);
  fs::create_symlink("gone", path("out_0003.png"));
  test::expect_error(ErrorKind::bad_usage, "out_0003.png: expected a new file", [&] {
    require_new_frames({"--record", path("out_%04d.png"), ""}, {0, 9}, Existing::keep, {});
  });
}

// Fails if two flags may name one file, by whatever way, or may not name two.
TEST_F(NewOutput, RefusesOneFileForTwoFlags) {
  fs::create_directories(path("folder"));
  fs::create_directory_symlink("folder", path("link"));
  test::expect_error(ErrorKind::bad_usage, "--b: expected a different file from that of --a, found ", [&] {
    require_distinct({{"--a", path("folder/x.png")}, {"--b", path("link/../link/x.png")}});
  });
  require_distinct({{"--a", path("x.png")}, {"--b", path("folder/x.png")}, {"--c", ""}, {"--d", ""}});
}

// A glTF whose first buffer is missing, as JSON and as a .glb whose JSON follows another chunk. Fails if the
// others are not known for that.
TEST_F(NewOutput, KeepsFilesOfGltfsThatAreDamaged) {
  const std::string json =
      R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":9,"uri":"none.bin"},7,{"byteLength":9,"uri":"b.bin"}],)"
      R"("images":[{"uri":"data:image/png;base64,AAAA"},{"uri":"a%20b.png"}]}  )";
  const auto word = [](std::size_t value) {
    std::string bytes;
    for (int i = 0; i < 4; ++i) bytes += static_cast<char>(value >> 8 * i & 0xff);
    return bytes;
  };
  std::ofstream(path("a.gltf"), std::ios::binary) << json;
  std::ofstream(path("a.glb"), std::ios::binary)
      << "glTF" << word(2) << word(12 + 8 + 4 + 8 + json.size()) << word(4) << "MORE"
      << "abcd" << word(json.size()) << "JSON" << json;
  for (const char* input : {"a.gltf", "a.glb"}) {
    for (const char* name : {"b.bin", "a b.png"}) {
      test::expect_error(ErrorKind::bad_usage, "an input of this command",
                         [&] { require_new(leave(name), Existing::replace, {{path(input)}}); });
    }
  }
}

// Fails if a directional file that is read beside a compressed spectrum can be written over.
TEST_F(NewOutput, KeepsCompanionsOfPackedSpectra) {
  const std::string spectrum = leave("46042w2020.txt.gz");
  for (const char* name : {"46042d2020.txt", "46042k2020.txt.gz"}) {
    test::expect_error(ErrorKind::bad_usage, "an input of this command",
                       [&] { require_new(leave(name), Existing::replace, {{spectrum}}); });
  }
}

}  // namespace
}  // namespace offing

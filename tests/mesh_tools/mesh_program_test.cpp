// The program offing-mesh, run as its users do.

#include <csignal>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>

#include "host/io/meshes/read_mesh.h"
#include "host/io/meshes/write_mesh.h"
#include "tests/cli/folder_content.h"
#include "tests/cli/offing_program.h"
#include "tests/io/meshes/mesh_samples.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

using ::testing::HasSubstr;
using ::testing::MatchesRegex;

const std::vector<std::string> maker_flags = {"repair", "remesh --faces 100", "simplify --faces 10",
                                              "subdivide"};

std::vector<std::string> words(const std::string& text) {
  std::vector<std::string> result;
  std::istringstream stream(text);
  for (std::string word; stream >> word;) result.push_back(word);
  return result;
}

class MeshProgram : public ::testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  void write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
  }

  /// Expects one line that names the file, a hint, the exit code, no output and no new file.
  void expect_refusal(const std::vector<std::string>& arguments, const std::string& name,
                      int exit_code) const {
    const auto before = folder_content(folder_.path());
    const ProgramResult result = run_offing(arguments);
    EXPECT_EQ(result.exit_code, exit_code) << name << ", " << arguments[0] << ": " << result.errors;
    EXPECT_THAT(result.errors, MatchesRegex("error: [^\n]+\nhint: [^\n]+\n")) << name << ", " << arguments[0];
    EXPECT_THAT(result.errors, HasSubstr(name)) << arguments[0];
    EXPECT_EQ(result.output, "") << name << ", " << arguments[0];
    EXPECT_EQ(folder_content(folder_.path()), before) << name << ", " << arguments[0];
  }

  std::vector<std::string> maker(const std::string& flags, const std::string& input,
                                 const std::string& output) const {
    std::vector<std::string> arguments = words(flags);
    arguments.insert(arguments.end(), {path(input), "-o", path(output), "--quiet"});
    return arguments;
  }

  TemporaryFolder folder_;
};

// Fails if scripts find other keys than promised, or a wrong count.
TEST_F(MeshProgram, CheckGivesItsKeys) {
  write("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 9 9 9\nf 1 2 3\nf 2 1 4\nf 1 2 5\nf 3 1 2\nl 1 2\n");
  const ProgramResult result = run_offing({"check", path("a.obj"), "--json"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_THAT(result.errors, HasSubstr("left out: 1 lines"));
  const nlohmann::ordered_json expected = {
      {"vertices", 5},           {"faces", 4},
      {"components", 1},         {"boundary_loops", 1},
      {"non_manifold_edges", 1}, {"non_manifold_vertices", 0},
      {"degenerate_faces", 0},   {"duplicate_faces", 1},
      {"isolated_vertices", 0},  {"orientable", true},
      {"turned_edges", 2},       {"self_intersections", 0},
      {"format", "OBJ"},         {"cut_into_triangles", 0},
      {"merged_corners", 0},     {"left_out", {{{"what", "lines"}, {"count", 1}}}}};
  EXPECT_EQ(nlohmann::ordered_json::parse(result.output), expected);
  const ProgramResult text = run_offing({"check", path("a.obj")});
  EXPECT_THAT(text.output, HasSubstr("left out               1 lines\n"));
  EXPECT_THAT(text.output, HasSubstr("non-manifold edges     1\n"));
}

// Fails if a command takes a mesh that none can use, ends otherwise than with a line and a hint, or leaves a
// file behind.
TEST_F(MeshProgram, BadInputGetsOneLineAndWritesNothing) {
  const std::vector<std::pair<std::string, std::string>> files = {
      {"empty.obj", ""},
      {"words.ply", "these are no triangles"},
      {"points.off", "OFF\n1 0 0\n0 0 0\n"},
      {"nan.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
      {"huge.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4000000000\n"},
      {"cut.stl", std::string(100, '\x7f')},
      {"cut.glb", "glTF"},
      {"odd\x01name\n.obj", "?"}};
  for (const auto& [name, content] : files) {
    write(name, content);
    const std::string shown = name.starts_with("odd") ? "odd\\x01name\\x0a.obj" : name;
    expect_refusal({"check", path(name)}, shown, 2);
    for (const std::string& flags : maker_flags) expect_refusal(maker(flags, name, "out.ply"), shown, 2);
  }
  expect_refusal({"check", path("none.obj")}, "none.obj", 2);
  expect_refusal({"check", folder_.path().string()}, folder_.path().filename().string(), 2);
}

// Fails if an output is replaced unasked, written under a name that no format fits, or not where asked.
TEST_F(MeshProgram, Outputs) {
  write_mesh(path("in.off"), random_mesh(1));
  for (const std::string& flags : maker_flags) {
    for (const std::string name : {"out.ply", "out.obj", "out.off", "out.stl"}) {
      const ProgramResult result = run_offing(maker(flags, "in.off", name));
      ASSERT_EQ(result.exit_code, 0) << flags << ' ' << name << ": " << result.errors;
      EXPECT_EQ(result.output, "") << "--quiet";
      EXPECT_FALSE(read_mesh(path(name)).faces.empty());
      expect_refusal(maker(flags, "in.off", name), name, 2);  // exists
      std::vector<std::string> forced = maker(flags, "in.off", name);
      forced.insert(forced.end(), {"--force", "--json"});
      const ProgramResult replaced = run_offing(forced);
      EXPECT_EQ(replaced.exit_code, 0) << replaced.errors;
      EXPECT_EQ(nlohmann::json::parse(replaced.output)["file"], path(name));
      std::filesystem::remove(path(name));
    }
    std::vector<std::string> in_place = maker(flags, "in.off", "in.off");
    in_place.push_back("--force");
    expect_refusal(in_place, "in.off", 2);
    expect_refusal(maker(flags, "in.off", "out.txt"), "out.txt", 2);
    expect_refusal(maker(flags, "in.off", "none/out.ply"), "none/out.ply", 1);
  }
}

// Fails if a limit of file sizes ends the program without a word, or leaves half a file.
TEST_F(MeshProgram, SaysThatAFileIsTooLarge) {
  rlimit usual{};
  getrlimit(RLIMIT_FSIZE, &usual);
  const rlimit small{.rlim_cur = 20'000, .rlim_max = usual.rlim_max};
  setrlimit(RLIMIT_FSIZE, &small);
  const ProgramResult result = run_offing({"generate", "sphere", "-o", path("big.ply")});
  setrlimit(RLIMIT_FSIZE, &usual);
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.errors, HasSubstr("ulimit -f"));
  EXPECT_TRUE(folder_content(folder_.path()).empty());
}

// Fails if repair does not say what it changed.
TEST_F(MeshProgram, RepairTellsItsChanges) {
  write("a.obj",
        "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 9 9 9\nf 1 3 2\nf 2 1 4\nf 1 3 4\nf 2 3 4\nf 3 1 2\n");
  const ProgramResult result =
      run_offing({"repair", path("a.obj"), "-o", path("b.ply"), "--json", "--outward"});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  const nlohmann::json json = nlohmann::json::parse(result.output);
  EXPECT_EQ(json["changed"]["removed_duplicate_faces"], 1);
  EXPECT_EQ(json["changed"]["removed_vertices"], 1);
  EXPECT_EQ(json["before"]["isolated_vertices"], 1);
  EXPECT_EQ(json["after"]["boundary_loops"], 0);
  EXPECT_EQ(json["after"]["faces"], 4);
}

// Fails if values out of range, flags that exclude each other or misspelt commands are taken.
TEST_F(MeshProgram, BadUsage) {
  write_mesh(path("in.off"), random_mesh(1));
  const std::vector<std::pair<std::string, std::string>> wrong = {
      {"remesh", "--edge-m or --faces"},         {"remesh --faces 2", "--faces"},
      {"remesh --edge-m 0", "--edge-m"},         {"remesh --edge-m 1e-6", "fewer than 1e8 faces"},
      {"remesh --edge-m nan", "--edge-m"},       {"remesh --edge-m 1 --faces 10", "excludes"},
      {"simplify", "--edge-m or --faces"},       {"simplify --faces many", "--faces"},
      {"subdivide --method cubic", "--method"},  {"subdivide --levels 99", "--levels"},
      {"repair --fill-edges -1", "--fill-edges"}};
  for (const auto& [flags, name] : wrong) expect_refusal(maker(flags, "in.off", "out.ply"), name, 2);
  expect_refusal({"remesh", path("in.off"), "--faces", "9", "-o", ""}, "-o: expected a value, got \"\"", 2);
  expect_refusal({"check", path("in.off"), ""}, "offing-mesh check: expected no empty argument", 2);
  const ProgramResult misspelt = run_offing({"chek", path("in.off")});
  EXPECT_EQ(misspelt.exit_code, 2);
  EXPECT_THAT(misspelt.errors, HasSubstr("did you mean check?"));
}

// Fails if a surface without an area, of which no edge length follows, is remeshed for ever.
TEST_F(MeshProgram, RemeshNeedsAnArea) {
  write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3\n");
  expect_refusal(maker("remesh --faces 100", "line.obj", "out.ply"), "expected faces with an area, got none",
                 2);
}

// Fails if a signal does not end long work with its own code (128 + 2 where it comes before the program
// listens), or leaves a file behind.
TEST_F(MeshProgram, EndsOnSignals) {
  write_mesh(path("in.off"), random_mesh(1, 200, 200));
  const auto before = folder_content(folder_.path());
  OffingProgram program(maker("remesh --faces 1000000 --rounds 100", "in.off", "out.ply"));
  program.send_signal(SIGINT);
  EXPECT_EQ(program.wait().exit_code, 130);
  EXPECT_EQ(folder_content(folder_.path()), before);
}

}  // namespace
}  // namespace offing::test

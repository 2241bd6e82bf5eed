// `offing scene new`, `import`, `check` and `keys`; scene_schema_test.py has `schema`.
#include <filesystem>
#include <fstream>
#include <iterator>
#include <set>
#include <sstream>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "host/cli/scene/starter_scene.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/schema/key_tables.h"
#include "host/scene/schema/parameter_table.h"
#include "host/scene/schema/scene_elements.h"
#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

class SceneCommands : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }
  std::string write(const std::string& name, const std::string& text) const {
    std::ofstream(path(name)) << text;
    return path(name);
  }
  static std::string read(const std::string& file) {
    std::ifstream stream(file);
    return {std::istreambuf_iterator<char>(stream), {}};
  }

  TemporaryFolder folder_;
};

// Fails if the starter scene is wrong, has warnings, replaces a file without --force, or differs on standard
// output by more than its name.
TEST_F(SceneCommands, NewWritesASceneWithoutFaults) {
  const std::string file = path("harbour.toml");
  ASSERT_EQ(run_offing({"scene", "new", file}).exit_code, 0);
  const ProgramResult check = run_offing({"scene", "check", file});
  EXPECT_EQ(check.exit_code, 0);
  EXPECT_EQ(check.output, file + ": no errors, no warnings\n");
  EXPECT_EQ(read(file), cli::starter_scene("harbour.toml"));
  EXPECT_EQ(run_offing({"scene", "new"}).output, cli::starter_scene("scene.toml"));
  EXPECT_EQ(run_offing({"scene", "new", "-"}).output, cli::starter_scene("scene.toml"));
  write("harbour.toml", "mine");
  const ProgramResult refused = run_offing({"scene", "new", file});
  EXPECT_EQ(refused.exit_code, 2);
  EXPECT_THAT(refused.errors, HasSubstr("--force"));
  EXPECT_EQ(read(file), "mine");
  EXPECT_EQ(run_offing({"scene", "new", file, "--force", "--quiet"}).output, "");
  EXPECT_EQ(read(file), cli::starter_scene("harbour.toml"));
  EXPECT_EQ(run_offing({"scene", "new", path("harbour.txt")}).exit_code, 2);
}

// Its comments are those of the rows, and so are its values but for the seven that it states. Fails if one is
// written twice, or if the part in comments is no scene.
TEST_F(SceneCommands, NewHasDefaultsAndStatedValues) {
  const std::string text = cli::starter_scene("a.toml");
  const scene::Scene starter = scene::parse_scene(text, "a.toml", "");
  std::set<std::string> stated;
  for (const auto& [place, where] : starter.set_at) {
    const scene::Parameter& row = *scene::find_parameter(place.key);
    EXPECT_THAT(text, HasSubstr(fmt::format("# {}: {}; default {}\n{} = ", row.help, expected_text(row),
                                            default_text(row), scene::name_of(row.key))));
    if (!is_same_value(row, struct_at(&starter, *row.section, place.element), default_struct(*row.section)))
      stated.insert(std::string(row.key));
  }
  EXPECT_EQ(starter.set_at.size(), 13u);
  EXPECT_THAT(stated, ElementsAre("camera.pitch_deg", "camera.y_m", "camera.yaw_deg", "sun.azimuth_deg",
                                  "sun.elevation_deg", "wind.direction_deg", "wind.speed_mps"));
  std::string whole;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    whole += line.starts_with('#') && !line.starts_with("# ") ? line.substr(1) : line;
    whole += '\n';
  }
  const scene::Scene with_swell = scene::parse_scene(whole, "a.toml", "");
  ASSERT_EQ(with_swell.ocean.swells.size(), 1u);
  EXPECT_EQ(with_swell.ocean.swells[0].tp_s, 11.0);
}

// Fails if a glTF gives a scene with faults, if what it could not take is not one line each, or if a file
// that is there is replaced.
TEST_F(SceneCommands, ImportMakesASceneOfAGltf) {
  const std::string glb = path("pan.glb"), file = path("pan.toml");
  std::filesystem::copy_file(OFFING_SCENES "/../tests/fuzz/corpus/gltf_stage/stage", glb);
  const ProgramResult result = run_offing({"scene", "import", glb, "-o", file});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
  EXPECT_EQ(result.output, file + ": no mesh files, 3 lights, no bookmarks, 3 values with keyframes, 1 s\n");
  for (const char* const what :
       {"1 orthographic cameras", "1 cones of spot lights", "1 ranges of lights", "1 materials"})
    EXPECT_THAT(result.errors, HasSubstr("pan.glb: left out: " + std::string(what) + "\n"));
  EXPECT_EQ(run_offing({"scene", "check", file}).output, file + ": no errors, no warnings\n");
  EXPECT_THAT(run_offing({"scene", "import", glb, "-o", file}).errors, HasSubstr("--force"));
  const ProgramResult wrong =
      run_offing({"scene", "import", glb, "-o", file, "--force", "--animation", "walk"});
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_THAT(wrong.errors,
              HasSubstr("error: " + glb +
                        ": expected an animation \"walk\", got \"pan\"\nhint: give one of these names"));
  EXPECT_EQ(run_offing({"scene", "import", glb, "-o", glb, "--force"}).exit_code, 2);
}

// Fails if a fault is left out, comes out of order, or has the wrong place.
TEST_F(SceneCommands, CheckNamesEachOf25Faults) {
  std::string text = "version = 1\n";
  for (int i = 0; i < 25; ++i) text += "[[light]]\nx_m = \"left\"\n";
  const std::string file = write("lights.toml", text), good = write("good.toml", "version = 1\n");
  const ProgramResult result = run_offing({"scene", "check", file, good});
  EXPECT_EQ(result.exit_code, 2);
  std::size_t at = 0;
  for (int i = 0; i < 25; ++i) {
    at = result.output.find(fmt::format("error: {}:{}:7: light.x_m: expected a number", file, 2 * i + 3), at);
    ASSERT_NE(at, std::string::npos) << i;
  }
  EXPECT_THAT(result.output, HasSubstr("\nhint: write x_m = 0\n"));
  EXPECT_THAT(result.output, HasSubstr(file + ": 25 errors, no warnings\n"));
  EXPECT_THAT(result.output, HasSubstr(good + ": no errors, no warnings\n"));
  EXPECT_EQ(result.errors,
            "error: expected scenes without errors, found errors in 1 of 2\n"
            "hint: fix the errors that are listed\n");
}

// Fails if a part of a message is lost or a warning counts as an error.
TEST_F(SceneCommands, CheckPrintsPartsOfMessages) {
  const std::string warned = write("warned.toml", "version = 1\n[ocean]\nspectrum = \"pm\"\ngamma = 5\n"),
                    wrong = write("wrong.toml", "[wind]\nspeed_mps = 200\n[[mesh]]\nfile = \"none.ply\"\n"),
                    lost = write("lost.toml", "version = 1\n[[mesh]]\nfile = \"none.ply\"\n"),
                    broken = write("broken.toml", "version = 1\n[wind\n");
  const ProgramResult fine = run_offing({"scene", "check", warned, "--json"});
  EXPECT_EQ(fine.exit_code, 0);
  const auto warnings = nlohmann::json::parse(fine.output).at(0).at("warnings");
  ASSERT_EQ(warnings.size(), 1u);
  EXPECT_EQ(warnings[0].at("line"), 4);
  EXPECT_EQ(warnings[0].at("column"), 9);
  EXPECT_EQ(warnings[0].at("key"), "ocean.gamma");
  EXPECT_THAT(warnings[0].at("message").get<std::string>(), testing::StartsWith("not used: "));

  const ProgramResult result =
      run_offing({"scene", "check", "--json", wrong, lost, broken, path("absent.toml")});
  EXPECT_EQ(result.exit_code, 2);
  const auto files = nlohmann::json::parse(result.output);
  ASSERT_EQ(files.size(), 4u);
  ASSERT_EQ(files[0].at("errors").size(), 2u);
  EXPECT_EQ(files[0]["errors"][0].at("key"), "version");
  EXPECT_EQ(files[0]["errors"][1],
            (nlohmann::json{{"line", 2},
                            {"column", 13},
                            {"key", "wind.speed_mps"},
                            {"message", "expected a number in m/s within [0.1, 60], got 200"},
                            {"hint", "write speed_mps = 60"}}));
  ASSERT_EQ(files[1].at("errors").size(), 1u);
  EXPECT_EQ(files[1]["errors"][0].at("key"), "mesh.file");
  EXPECT_EQ(files[1]["errors"][0].at("line"), 3);
  EXPECT_EQ(files[2].at("errors").at(0).at("line"), 2);
  EXPECT_EQ(files[3].at("errors").at(0).at("line"), 0);
  for (const auto& file : files) {
    for (const auto& error : file.at("errors")) EXPECT_NE(error.at("hint"), "") << error;
  }
}

// Fails if strangers' scenes may name files outside their folder.
TEST_F(SceneCommands, CheckTakesUntrusted) {
  write("ball.ply", "ply");
  std::filesystem::create_directory(path("inner"));
  const std::string file = write("inner/a.toml", "version = 1\n[[mesh]]\nfile = \"../ball.ply\"\n");
  EXPECT_EQ(run_offing({"scene", "check", file}).exit_code, 0);
  EXPECT_EQ(run_offing({"scene", "check", file, "--untrusted"}).exit_code, 2);
}

// Fails if a pattern lists too much, or a misspelt one gives no hint.
TEST_F(SceneCommands, KeysAreListed) {
  EXPECT_EQ(run_offing({"scene", "keys", "--format", "markdown"}).output,
            scene::key_page(scene::parameter_table()));
  const auto swell =
      nlohmann::json::parse(run_offing({"scene", "keys", "swell.*_m", "--format", "json"}).output);
  ASSERT_EQ(swell.size(), 3u);
  EXPECT_EQ(swell[1].at("key"), "ocean.swell.amplitude_m");
  EXPECT_EQ(swell[1].at("unit"), "m");
  EXPECT_EQ(swell[1].at("high"), 100);
  EXPECT_EQ(swell[1].at("default"), 0.5);
  const auto all = nlohmann::json::parse(run_offing({"scene", "keys", "--format", "json"}).output);
  EXPECT_EQ(all.size(), scene::parameter_table().size());
  EXPECT_THAT(
      run_offing({"scene", "keys", "fetch"}).output,
      HasSubstr("ocean.fetch_m\n    fetch: distance over water that the wind has blown (jonswap, tma)\n"
                "    a number in m within [100, 10000000]; default 100000; --fetch-m\n"));
  const ProgramResult none = run_offing({"scene", "keys", "fetchm"});
  EXPECT_EQ(none.exit_code, 2);
  EXPECT_THAT(none.errors, HasSubstr("hint: did you mean fetch_m?"));
  EXPECT_THAT(none.output, IsEmpty());
}

}  // namespace
}  // namespace offing::test

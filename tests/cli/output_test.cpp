// What commands print, and where to.
#include <chrono>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/stat.h>

#include "tests/cli/offing_program.h"

namespace offing::test {
namespace {

using testing::HasSubstr;

class OutputTest : public testing::Test {
 protected:
  std::string path(const std::string& name) const { return (folder_.path() / name).string(); }

  TemporaryFolder folder_;
};

// Fails if a command that was told to be quiet prints what it wrote, or does not print what it was asked for.
TEST_F(OutputTest, QuietCommandsPrintResultsAlone) {
  const std::string map = path("map.tif");
  const std::vector<std::vector<std::string>> writing = {
      {"terrain", "generate", "--posts", "17", "-o", map},
      {"terrain", "tile", map, "-o", path("store")},
      {"terrain", "profile", map, "--from", "0,0", "--to", "100,100", "-o", path("profile.csv")},
      {"terrain", "viewshed", map, "--observer", "100,100", "-o", path("seen.tif")},
      {"terrain", "render", map, "--size", "16x9", "--samples", "1", "-o", path("picture.png")},
      {"ocean", "query", "--size", "16", "--cascades", "1", "--at", "0,0", "-o", path("query.csv")},
      {"ocean", "bake", "--size", "16", "--cascades", "1", "--frames", "0", "-o", path("frames")}};
  for (std::vector<std::string> arguments : writing) {
    arguments.push_back("--quiet");
    const ProgramResult result = run_offing(arguments);
    EXPECT_EQ(result.exit_code, 0) << arguments[1] << ": " << result.errors;
    EXPECT_EQ(result.output, "") << arguments[1];
    EXPECT_EQ(result.errors, "") << arguments[1];
  }
  const ProgramResult asked = run_offing({"terrain", "height", map, "--at", "100,100", "--quiet"});
  EXPECT_THAT(asked.output, HasSubstr("height"));
}

// Fails if a pipe in the place of an exported spectrum is read, which waits for whoever writes to it, or if
// two outputs of a command may take one name.
TEST_F(OutputTest, ExportsSpectraToFilesOfTheirOwn) {
  const auto bake = [&](const std::string& folder, const std::string& file) {
    return std::vector<std::string>{
        "ocean",    "bake", "--size", "16",         "--cascades",        "1",
        "--frames", "0:3",  "-o",     path(folder), "--export-spectrum", path(file)};
  };
  ASSERT_EQ(mkfifo(path("pipe.spec").c_str(), 0600), 0);
  OffingProgram program(bake("a", "pipe.spec"));
  for (int wait = 0; wait < 600 && program.is_running(); ++wait) {
    std::this_thread::sleep_for(std::chrono::milliseconds(100));
  }
  ASSERT_FALSE(program.is_running()) << "it reads the pipe";
  const ProgramResult piped = program.wait();
  EXPECT_EQ(piped.exit_code, 1);
  EXPECT_THAT(piped.errors, HasSubstr("pipe.spec: cannot write: expected a file name"));
  const ProgramResult frame = run_offing(bake("b", "b/ocean.c0.0002.exr"));
  EXPECT_EQ(frame.exit_code, 2);
  EXPECT_THAT(frame.errors, HasSubstr("--export-spectrum: expected a different file from that of -o"));
  EXPECT_FALSE(std::filesystem::exists(path("b")));
  const ProgramResult plot =
      run_offing({"ocean", "spectrum", OFFING_SCENES "/example_sea.data_spec", "--record", "0", "--plot",
                  path("a.png"), "--export-spectrum", path("./a.png")});
  EXPECT_EQ(plot.exit_code, 2);
  EXPECT_THAT(plot.errors, HasSubstr("--export-spectrum: expected a different file from that of --plot"));
}

// Fails if "-" makes a file of that name, text does not go to standard output, or something else goes with
// it.
TEST_F(OutputTest, AMinusIsStandardOutput) {
  const std::string map = path("map.tif"), records = OFFING_SCENES "/example_sea.data_spec";
  ASSERT_EQ(run_offing({"terrain", "generate", "--posts", "17", "-o", map}).exit_code, 0);
  const std::vector<std::string> profile = {"terrain", "profile", map, "--from", "0,0", "--to", "100,100"};
  std::vector<std::string> to_output = profile;
  to_output.insert(to_output.end(), {"-o", "-"});
  EXPECT_EQ(run_offing(to_output).output, run_offing(profile).output);
  const ProgramResult query =
      run_offing({"ocean", "query", "--size", "16", "--cascades", "1", "--at", "0,0", "-o", "-"});
  EXPECT_EQ(query.exit_code, 0) << query.errors;
  EXPECT_THAT(query.output, testing::StartsWith("time_s,"));
  EXPECT_THAT(query.output, testing::Not(HasSubstr("written")));
  const ProgramResult spectrum =
      run_offing({"ocean", "spectrum", records, "--record", "0", "--export-spectrum", "-"});
  EXPECT_EQ(spectrum.exit_code, 0) << spectrum.errors;
  EXPECT_THAT(spectrum.output, testing::StartsWith("'WAVEWATCH III SPECTRA'"));
  for (const std::vector<std::string>& no_text :
       {std::vector<std::string>{"terrain", "generate", "--posts", "17", "-o", "-"},
        {"terrain", "tile", map, "-o", "-"},
        {"terrain", "render", map, "-o", "-"},
        {"ocean", "spectrum", records, "--plot", "-"},
        {"ocean", "bake", "--size", "16", "--cascades", "1", "--frames", "0", "-o", "-"}}) {
    const ProgramResult result = run_offing(no_text);
    EXPECT_EQ(result.exit_code, 2) << no_text[1];
    EXPECT_THAT(result.errors, HasSubstr("hint: ")) << no_text[1];
  }
  EXPECT_FALSE(std::filesystem::exists("-"));
}

// Fails if a damaged EXR height map is taken for a frame of a bake.
TEST_F(OutputTest, ADamagedMapIsNoFrame) {
  std::ofstream(path("map.exr"), std::ios::binary)
      << std::string("\x76\x2f\x31\x01\x02\0\0\0 and no more", 20);
  const ProgramResult result = run_offing({"terrain", "info", path("map.exr"), "--spacing-m", "10"});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.errors, HasSubstr("map.exr: not a whole EXR file"));
  EXPECT_THAT(result.errors, HasSubstr("hint: make or copy the file again"));
}

// Fails if too few open files are taken for a fault of a driver: with 4 there was "no OpenCL platform".
TEST_F(OutputTest, TooFewOpenFilesAreToldAsThat) {
  const ProgramResult result =
      OffingProgram({"-c", "ulimit -n 8; exec \"$0\" devices", OFFING_PROGRAM}, "/bin/sh").wait();
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_THAT(result.errors, HasSubstr("this process may have 8"));
  EXPECT_THAT(result.errors, HasSubstr("hint: raise the limit with ulimit -n 1024"));
}

}  // namespace
}  // namespace offing::test

#include <cmath>
#include <fstream>
#include <functional>
#include <regex>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include "host/base/error.h"
#include "host/cli/ocean/frame_files.h"
#include "tests/cli/offing_program.h"
#include "tests/ocl/scoped_environment.h"

// Bad inputs, each through the whole program: one `error:` line with the place, one `hint:` line, the right
// exit code.

namespace offing::test {
namespace {

void write(const std::filesystem::path& path, const std::string& text) {
  std::ofstream(path, std::ios::binary) << text;
}

/// A valid record, to be spoiled: NDBC realtime form.
const std::string header =
    "#YY  MM DD hh mm Sep_Freq  < spec_1 (freq_1) spec_2 (freq_2) spec_3 (freq_3) ... >\n";
const std::string record = "2020 06 08 03 50 0.225 0.100 (0.100) 2.000 (0.200) 0.500 (0.300)\n";

struct BadInput {
  const char* name;
  std::function<void(const std::filesystem::path& folder)> prepare;
  std::vector<std::string> arguments;  ///< `@` stands for a folder of this test
  int exit_code;
  const char* error;      ///< regular expression that the whole error line must match
  const char* hint = "";  ///< what the hint says too
};

const auto nothing = [](const std::filesystem::path&) {};

std::function<void(const std::filesystem::path&)> file(const char* name, const std::string& text) {
  return [=](const std::filesystem::path& folder) { write(folder / name, text); };
}

void bake_other_scene(const std::filesystem::path& folder) {
  const ProgramResult result = run_offing({"ocean", "bake", "--size", "16", "--cascades", "1", "--seed", "5",
                                           "--frames", "0:0", "-o", (folder / "out").string()});
  ASSERT_EQ(result.exit_code, 0) << result.errors;
}

/// The picture of another share's frame.
void link_image_to_itself(const std::filesystem::path& folder) {
  std::filesystem::create_directory(folder / "out");
  std::filesystem::create_symlink("ocean.0001.png", folder / "out" / "ocean.0001.png");
}

std::vector<std::string> stats(std::vector<std::string> more) {
  std::vector<std::string> arguments = {"ocean", "stats", "--size", "16", "--seeds", "1"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

std::vector<std::string> bake(std::vector<std::string> more) {
  std::vector<std::string> arguments = {"ocean",      "bake", "--size",   "16",
                                        "--cascades", "1",    "--frames", "0:0"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

const std::vector<BadInput> bad_inputs = {
    // The command line.
    {"no_command", nothing, {}, 2, "offing: .*[Ss]ubcommand.*"},
    {"unknown_command", nothing, {"ocaen"}, 2, "offing: .*\"ocaen\".*"},
    {"command_without_its_group",
     nothing,
     {"bake"},
     2,
     "offing: .*\"bake\".*",
     "did you mean offing ocean bake?"},
    {"missing_spectrum_of_a_scene",
     file("s.toml", "version = 1\n[ocean]\nspectrum_file = \"none.spec\"\n"),
     {"ocean", "query", "@/s.toml", "--at", "0,0"},
     2,
     ".*/s.toml:3:17: ocean.spectrum_file: expected a wave spectrum file, got no such file, .*/none.spec"},
    {"unknown_flag", nothing, stats({"--wind-sped-mps", "5"}), 2,
     "offing ocean stats: .*\"--wind-sped-mps\".*"},
    {"flag_without_value",
     nothing,
     {"ocean", "stats", "--seeds"},
     2,
     "offing ocean stats: --seeds: expected a value, found none"},
    {"no_output_folder", nothing, bake({}), 2, "offing ocean bake: .*--output.*required.*"},
    {"size_not_power_of_two",
     nothing,
     {"ocean", "stats", "--size", "500"},
     2,
     "--size: expected a power of two within \\[16, 4096\\], got \"500\""},
    {"size_too_large",
     nothing,
     {"ocean", "stats", "--size", "8192"},
     2,
     "--size: expected a power of two .*"},
    {"negative_depth", nothing, stats({"--depth-m", "-5"}), 2,
     "--depth-m: expected a number in m within \\[0.1, 12000\\], got \"-5\""},
    {"nan_wind", nothing, stats({"--wind-speed-mps", "nan"}), 2,
     "--wind-speed-mps: expected a number .*got \"nan\""},
    {"infinite_fetch", nothing, stats({"--fetch-m", "inf"}), 2, "--fetch-m: expected a number .*got \"inf\""},
    {"minus_infinite_gamma", nothing, stats({"--gamma", "-inf"}), 2,
     "--gamma: expected a number .*got \"-inf\""},
    {"unknown_spectrum", nothing, stats({"--spectrum", "jonswop"}), 2,
     "--spectrum: expected one of .*\"jonswop\""},
    {"no_seeds",
     nothing,
     {"ocean", "stats", "--seeds", "0"},
     2,
     "--seeds: expected a whole number .*got \"0\""},
    {"equal_patches", nothing, stats({"--patch-m", "100,100"}), 2, ".*patch_m.*100.*"},
    {"too_many_patches", nothing, stats({"--patch-m", "9,8,7,6,5"}), 2,
     "--patch-m: expected at most 4 values.*"},
    {"backward_frames",
     nothing,
     {"ocean", "bake", "--frames", "9:0", "-o", "@/out"},
     2,
     "--frames: expected A:B .*got \"9:0\""},
    {"empty_frames",
     nothing,
     {"ocean", "bake", "--frames", "", "-o", "@/out"},
     2,
     "--frames: expected a value, got \"\"",
     "give --frames a value"},
    {"empty_file_flag", nothing, stats({"--spectrum-file", ""}), 2,
     "--spectrum-file: expected a value, got \"\"", "leave it out"},
    {"empty_value_after_equals_sign",
     nothing,
     {"ocean", "query", "--at", "0,0", "--times="},
     2,
     "--times: expected a value, got \"\"",
     "give --times a value"},
    {"empty_output",
     nothing,
     {"ocean", "query", "--at", "0,0", "-o", ""},
     2,
     "-o: expected a value, got \"\"",
     "give -o a value"},
    {"empty_scene",
     nothing,
     {"ocean", "stats", "--json", ""},
     2,
     "offing ocean stats: expected no empty argument, got \"\" as argument 4",
     "leave it out"},
    {"share_beyond_count", nothing, bake({"--chunk", "3/2", "-o", "@/out"}), 2,
     "--chunk: expected i/n .*got \"3/2\""},
    {"unknown_channel", nothing, bake({"--channels", "height", "-o", "@/out"}), 2,
     "--channels: .*got \"height\""},
    {"velocity_below_the_bed", nothing, bake({"--depth-m", "20", "--velocity-depth-m", "21", "-o", "@/out"}),
     2, "--velocity-depth-m: expected a number in m within \\[0, 20\\], got \"21\""},
    {"unknown_compression", nothing, bake({"--compression", "jpeg", "-o", "@/out"}), 2,
     "--compression: .*got \"jpeg\""},
    {"unknown_device", nothing, stats({"--device", "abacus"}), 3, ".*abacus.*"},

    // Scene files.
    {"scene_missing", nothing, stats({"@/none.toml"}), 2, ".*/none.toml: cannot open scene: No such file.*"},
    {"scene_is_folder", nothing, stats({"@"}), 2, ".*: expected a scene file, found a folder"},
    {"scene_not_toml", file("a.toml", "version = 1\n[ocean\n"), stats({"@/a.toml"}), 2,
     ".*/a.toml:2:7: expected TOML.*"},
    {"scene_is_binary",
     file("a.toml", std::string("\x7f"
                                "ELF\0\1\2\3\xff",
                                9)),
     stats({"@/a.toml"}), 2, ".*/a.toml:1:.*: expected TOML.*"},
    {"scene_unknown_key", file("a.toml", "version = 1\n[ocean]\nwind_sped_mps = 5\n"), stats({"@/a.toml"}), 2,
     ".*/a.toml:3:1: ocean.wind_sped_mps: expected a known key.*"},
    {"scene_wrong_type", file("a.toml", "version = 1\n[ocean]\nwind_speed_mps = \"17 kn\"\n"),
     stats({"@/a.toml"}), 2,
     ".*/a.toml:3:18: ocean.wind_speed_mps: expected a number in m/s within \\[0.1, 60\\], got \"17 kn\""},
    {"scene_not_finite", file("a.toml", "version = 1\n[ocean]\ndepth_m = -inf\n"), stats({"@/a.toml"}), 2,
     ".*/a.toml:3:11: ocean.depth_m: .*got -inf"},
    {"scene_ends_before_start",
     file("a.toml", "version = 1\n[time]\nstart_s = 3\nend_s = 2\n"),
     {"ocean", "bake", "@/a.toml", "--size", "16", "-o", "@/out"},
     2,
     "time: expected frames 0 to 9999999 between .*"},

    // Spectrum files.
    {"spectrum_missing", nothing, stats({"--spectrum-file", "@/none.spec"}), 2,
     "--spectrum-file: expected a wave spectrum file, got no such file, .*/none.spec"},
    {"spectrum_empty", file("a.data_spec", ""), stats({"--spectrum-file", "@/a.data_spec"}), 2,
     ".*/a.data_spec.*"},
    {"spectrum_of_zeros", file("a.data_spec", std::string(4096, '\0')),
     stats({"--spectrum-file", "@/a.data_spec"}), 2, ".*/a.data_spec.*"},
    {"spectrum_truncated", file("a.data_spec", header + record.substr(0, 40)),
     stats({"--spectrum-file", "@/a.data_spec"}), 2, ".*/a.data_spec:2.*"},
    {"spectrum_with_nan",
     file("a.data_spec", header + "2020 06 08 03 50 0.225 0.1 (0.1) nan (0.2) 0.5 (0.3)\n"),
     stats({"--spectrum-file", "@/a.data_spec"}), 2, ".*/a.data_spec:2.*"},
    {"spectrum_negative",
     file("a.data_spec", header + "2020 06 08 03 50 0.225 0.1 (0.1) -2.0 (0.2) 0.5 (0.3)\n"),
     stats({"--spectrum-file", "@/a.data_spec"}), 2, ".*/a.data_spec:2.*"},
    {"spectrum_without_energy",
     file("a.data_spec", header + "2020 06 08 03 50 0.225 0.0 (0.1) 0.0 (0.2) 0.0 (0.3)\n"),
     stats({"--spectrum-file", "@/a.data_spec"}), 2, ".*energy.*"},
    // Both once led to a division by zero and a write outside the table.
    {"spectrum_of_one_frequency",
     file("a.data_spec", header + "2020 06 08 03 50 0.225 1.0 (0.05) 1.0 (0.05000000000000001)\n"),
     stats({"--spectrum-file", "@/a.data_spec"}), 2,
     "measured spectrum: expected frequencies .*found 0.05000000000000001 Hz after 0.05 Hz"},
    {"spectrum_of_endless_waves",
     file("a.data_spec", header + "2020 06 08 03 50 0.225 1.0 (1e-200) 1.0 (0.1)\n"),
     stats({"--spectrum-file", "@/a.data_spec"}), 2,
     "measured spectrum: expected frequencies .*found 1e-200 Hz first"},
    {"spectrum_hostile_name", nothing, stats({"--spectrum-file", "@/a\nb\x1b[2J}.spt"}), 2,
     ".*/a\\\\x0ab\\\\x1b\\[2J\\}\\.spt.*"},
    {"record_out_of_range", file("a.data_spec", header + record),
     stats({"--spectrum-file", "@/a.data_spec", "--record", "1"}), 2,
     ".*/a.data_spec: expected a record within \\[0, 0\\], got 1"},
    {"listing_record_out_of_range",
     file("a.data_spec", header + record),
     {"ocean", "spectrum", "@/a.data_spec", "--record", "7"},
     2,
     "--record: expected a whole number .*got \"7\""},

    {"plot_of_many_records",
     file("a.data_spec", header + record + "2020 06 08 04 50" + record.substr(16)),
     {"ocean", "spectrum", "@/a.data_spec", "--plot", "@/a.png"},
     2,
     "--plot: expected --record to choose one of the 2 records, found none"},
    {"plot_that_is_no_png",
     file("a.data_spec", header + record),
     {"ocean", "spectrum", "@/a.data_spec", "--plot", "@/a.jpg"},
     2,
     ".*/a.jpg: expected a name that ends in .png"},

    // Output.
    {"plot_in_no_folder",
     file("a.data_spec", header + record),
     {"ocean", "spectrum", "@/a.data_spec", "--plot", "@/none/a.png", "--export-spectrum", "@/a.spec"},
     1,
     ".*/none/a.png: cannot create: No such file or directory"},
    {"force_without_output",
     nothing,
     {"ocean", "query", "--at", "0,0", "--force"},
     2,
     "--force: expected -o, .*"},
    {"folder_is_a_file", file("out", "x"), bake({"-o", "@/out"}), 1, ".*/out: cannot write frames there: .*"},
    {"folder_not_writable", nothing, bake({"-o", "/proc/offing"}), 1,
     "/proc/offing: cannot write frames there: .*"},
    {"folder_name_too_long", nothing, bake({"-o", "@/" + std::string(300, 'o')}), 1,
     ".*/o+: cannot write frames there: .*[Nn]ame too long"},
    {"picture_links_to_itself",
     link_image_to_itself,
     {"ocean", "bake", "--size", "16", "--frames", "1:1", "--chunk", "2/2", "--preview", "-o", "@/out"},
     1,
     ".*/out/ocean.0001.png: cannot be looked up: .*"},
    {"folder_of_another_scene", bake_other_scene, bake({"--seed", "6", "-o", "@/out"}), 2,
     ".*/out: expected only frames of this scene .*found ocean.c0.0000.exr of another"},
    {"export_not_writable", nothing, bake({"--export-spectrum", "/proc/a.spec", "-o", "@/out"}), 1,
     "/proc/a.spec.*"},
};

class BadInputs : public testing::TestWithParam<BadInput> {};

// Each fails if the fault is accepted, crashes the program, or is told without its place or fix.
TEST_P(BadInputs, EndInTwoLinesAndACode) {
  const TemporaryFolder folder;
  GetParam().prepare(folder.path());
  std::vector<std::string> arguments = GetParam().arguments;
  for (std::string& argument : arguments) {
    if (argument.starts_with('@')) {
      argument = folder.path().string() + argument.substr(1);
    }
  }
  const ProgramResult result = run_offing(arguments);
  EXPECT_EQ(result.exit_code, GetParam().exit_code) << result.errors;
  std::vector<std::string> errors, hints;
  std::istringstream lines(result.errors);
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("error: ")) {
      errors.push_back(line.substr(7));
    } else if (line.starts_with("hint: ")) {
      hints.push_back(line.substr(6));
    } else {
      EXPECT_TRUE(line.starts_with("warning: ") || line.starts_with("info: ")) << line;
    }
  }
  ASSERT_EQ(errors.size(), 1u) << result.errors;
  EXPECT_TRUE(std::regex_match(errors[0], std::regex(GetParam().error))) << errors[0];
  ASSERT_EQ(hints.size(), 1u) << result.errors;
  EXPECT_GT(hints[0].size(), 10u);
  EXPECT_NE(hints[0].find(GetParam().hint), std::string::npos) << hints[0];
}

INSTANTIATE_TEST_SUITE_P(CommandLine, BadInputs, testing::ValuesIn(bad_inputs),
                         [](const auto& tested) { return std::string(tested.param.name); });

// Fails if a folder that cannot be listed ends the program with anything but an Error that names it. This one
// may open no file meanwhile, which holds for root too.
TEST(UnlistableFolder, IsAnError) {
#if defined(__SANITIZE_ADDRESS__)
  GTEST_SKIP() << "sanitizers look at objects through a pipe, which no open files allow";
#endif
  const TemporaryFolder folder;
  cli::BakeSettings settings;
  settings.folder = folder.path();
  const cli::FrameFiles files(settings, 1, "hash");
  rlimit usual{};
  ASSERT_EQ(getrlimit(RLIMIT_NOFILE, &usual), 0);
  const rlimit none{0, usual.rlim_max};
  ASSERT_EQ(setrlimit(RLIMIT_NOFILE, &none), 0);
  std::string told;
  try {
    files.prepare_folder();
  } catch (const Error& error) {
    told = error.what();
  } catch (const std::exception& error) {
    told = std::string("not an Error: ") + error.what();
  }
  setrlimit(RLIMIT_NOFILE, &usual);
  EXPECT_THAT(told, testing::StartsWith(folder.path().string() + ": cannot write frames there: "));
}

// Fails if garbage among the cached programs stops the program instead of being built anew.
TEST(BadCache, IsRebuilt) {
  const TemporaryFolder cache;
  const ScopedEnvironment environment("OFFING_CACHE_DIR", cache.path().string());
  const std::vector<std::string> arguments = stats({"--cascades", "1", "--json"});
  const ProgramResult first = run_offing(arguments);
  ASSERT_EQ(first.exit_code, 0) << first.errors;
  int entries = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(cache.path())) {
    if (entry.is_regular_file()) {
      write(entry.path(), "garbage");
      ++entries;
    }
  }
  EXPECT_GT(entries, 0);
  const ProgramResult second = run_offing(arguments);
  EXPECT_EQ(second.exit_code, 0) << second.errors;
  EXPECT_EQ(second.output, first.output);
}

// Fails if the faults of a scene are told one a run, or not in the order of the file.
TEST(BadScene, HasItsFaultsToldAtOnce) {
  const TemporaryFolder folder;
  const std::filesystem::path scene = folder.path() / "a.toml";
  write(scene, "version = 1\n[wind]\nspeed_mps = 200\n[ocean]\nsize = 100\nspectrum = \"jonswop\"\n");
  const ProgramResult result = run_offing({"ocean", "stats", scene.string()});
  EXPECT_EQ(result.exit_code, 2);
  const std::string place = scene.string();
  EXPECT_EQ(
      result.errors,
      "error: " + place + ":3:13: wind.speed_mps: expected a number in m/s within [0.1, 60], got 200\n" +
          "hint: write speed_mps = 60\n" + "error: " + place +
          ":5:8: ocean.size: expected a power of two within [16, 4096], got 100\nhint: write size = 128\n" +
          "error: " + place +
          ":6:12: ocean.spectrum: expected one of phillips, pm, jonswap, tma, swell, got \"jonswop\"\n" +
          "hint: write spectrum = \"jonswap\"\n");
}

class FullOutput : public testing::Test {
 protected:
  void SetUp() override {
    if (access("/dev/full", W_OK) != 0) {
      GTEST_SKIP() << "no /dev/full here";
    }
  }

  /// Exit code of the program, -1 if a signal ended it.
  int run(const std::string& arguments) const {
    const int status = std::system(("\"" + std::string(OFFING_PROGRAM) + "\" " + arguments).c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  TemporaryFolder folder_;
};

// Fails if results that cannot be written are taken for written, or the error does not say so: where a short
// text stays in its buffer to the end, and where a long one fills it half-way.
TEST_F(FullOutput, IsAnError) {
  std::string records = header;
  for (int i = 0; i < 200; ++i) {
    records += record;
  }
  const std::filesystem::path list = folder_.path() / "a.data_spec", errors = folder_.path() / "errors";
  write(list, records);
  for (const std::string& arguments : {std::string("--help"), "ocean spectrum --quiet " + list.string()}) {
    EXPECT_EQ(run(arguments + " > /dev/full 2> " + errors.string()), 1) << arguments;
    std::ifstream file(errors);
    std::string line;
    std::getline(file, line);
    EXPECT_EQ(line, "error: standard output: cannot be written") << arguments;
  }
}

// Fails if messages that cannot be written end the program by a signal, or stop a bake.
TEST_F(FullOutput, OfMessagesIsNone) {
  EXPECT_EQ(run("ocean stats --size 500 2> /dev/full"), 2);
  EXPECT_EQ(run("ocean bake --size 16 --cascades 1 --frames 0:0 -o " + (folder_.path() / "out").string() +
                " > /dev/null 2> /dev/full"),
            0);
}

}  // namespace
}  // namespace offing::test

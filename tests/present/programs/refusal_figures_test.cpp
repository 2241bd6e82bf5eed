// Whether the time and the memory that refusals name are what the work takes: each scene is refused under a
// small limit, then drawn without one and measured.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/cli/offing_program.h"

namespace offing::test {
namespace {

class RefusalFigures : public testing::Test {
 protected:
  void SetUp() override {
    unsetenv("DISPLAY");
    unsetenv("WAYLAND_DISPLAY");
  }

  /// Under a limit in kB of the memory that the program itself asks for; 0: none.
  static ProgramResult run(const std::vector<std::string>& words, int limit_kb = 0) {
    const std::string limit = limit_kb > 0 ? fmt::format("ulimit -d {}; ", limit_kb) : "";
    std::vector<std::string> arguments{"-c", limit + "exec \"$@\"", "sh"};
    arguments.insert(arguments.end(), words.begin(), words.end());
    return OffingProgram(arguments, "/bin/sh").wait();
  }

  ProgramResult draw(const std::string& scene, int limit_kb = 0) const {
    std::ofstream(scene_) << "version = 1\n" << scene;
    return run({OFFING_VIEW_PROGRAM, scene_, "--headless", "--size", "48x27", "--detail", "low", "--quiet",
                "--force", "-o", picture_},
               limit_kb);
  }

  /// The first three frames of a sea of size x size samples.
  ProgramResult bake(int size, int limit_kb = 0) const {
    const std::string folder = (folder_.path() / "frames").string();
    std::filesystem::remove_all(folder);
    return run({OFFING_MAIN_PROGRAM, "ocean", "bake", "--size", fmt::format("{}", size), "--foam-decay-s",
                "1", "--foam-step-s", "1", "-o", folder, "--frames", "0:2", "--quiet"},
               limit_kb);
  }

  struct Drawn {
    double seconds;
    std::size_t peak_bytes;
  };

  Drawn drawn(const std::string& scene) const {
    setenv("OFFING_LONGEST_WAIT_S", "3600", 1);
    const auto begin = std::chrono::steady_clock::now();
    const ProgramResult result = draw(scene);
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count(),
            result.peak_bytes};
  }

  /// What a larger scene takes more than a small one of the same kind, which compiles and starts as it does.
  Drawn added(const std::string& small, const std::string& large) const {
    drawn(small);  // compiles
    const Drawn before = drawn(small), after = drawn(large);
    return {after.seconds - before.seconds, after.peak_bytes - std::min(before.peak_bytes, after.peak_bytes)};
  }

  static double named_s(const ProgramResult& result) {
    static const std::regex pattern("would take about (?:([0-9]+) min )?([0-9]+) s here");
    std::smatch found;
    EXPECT_TRUE(std::regex_search(result.errors, found, pattern)) << result.errors;
    return found.empty() ? 0.0 : (found[1].matched ? 60.0 * std::stod(found[1]) : 0.0) + std::stod(found[2]);
  }

  static double named_bytes(const ProgramResult& result) {
    static const std::regex pattern("need ([0-9.]+) GB of memory");
    std::smatch found;
    EXPECT_TRUE(std::regex_search(result.errors, found, pattern)) << result.errors;
    return found.empty() ? 0.0 : 1e9 * std::stod(found[1]);
  }

  /// The time that is named lies within a factor of 2 of what it takes: other programs come and go.
  void expect_right_time(const std::string& small, const std::string& large) const {
    setenv("OFFING_LONGEST_WAIT_S", "1", 1);
    const double named = named_s(draw(large)), taken = added(small, large).seconds;
    fmt::print("named {:.0f} s, taken {:.1f} s\n", named, taken);
    EXPECT_LT(named, 2.0 * taken);
    EXPECT_GT(named, 0.5 * taken);
  }

 private:
  TemporaryFolder folder_;
  std::string scene_ = (folder_.path() / "scene.toml").string(),
              picture_ = (folder_.path() / "a.exr").string();
};

std::string wake(double history_s) {
  return fmt::format(
      "[ocean]\nsize = 16\n[[ocean.wake]]\ncells = 1024\nhistory_s = {}\n[[ocean.wake.hull]]\nspeed_mps = "
      "3\n",
      history_s);
}

std::string made_terrain(int posts) {
  return fmt::format("[terrain]\nposts = {}\n", posts);
}

std::string sampled_cloud(int particles) {
  return fmt::format(
      "[[cloud]]\ngenus = \"stratus\"\nmodelling = \"sampled\"\ntarget_particles = "
      "{}\n[[cloud.ball]]\nradius_m = "
      "100\n",
      particles);
}

// Foam of 41 past instants. An estimate needs two seconds of them and looks before half are done: at 4096 each
// takes a quarter of a second or more.
std::string wide_sea(int size) {
  return fmt::format("[ocean]\nsize = {}\nfoam.decay_s = 10\nfoam.step_s = 1\n", size);
}

TEST_F(RefusalFigures, TimeOfSampledCloudsIsRight) {
  expect_right_time(sampled_cloud(1000), sampled_cloud(60'000));
}

TEST_F(RefusalFigures, TimeOfFoamIsRight) {
  expect_right_time(wide_sea(16), wide_sea(4096));
}

TEST_F(RefusalFigures, TimeOfWakesIsRight) {
  expect_right_time(wake(0.1), wake(20.0));
}

TEST_F(RefusalFigures, TimeOfMadeGroundIsRight) {
  expect_right_time(made_terrain(65), made_terrain(6144));
}

// Fails if ground is begun that the kernel would kill the program for, or the figure is off by more than a
// quarter: that of a device that keeps its memory in the machine's.
TEST_F(RefusalFigures, MemoryOfMadeGroundIsRight) {
  setenv("OFFING_LONGEST_WAIT_S", "3600", 1);
  constexpr int limit_kb = 340'000, posts = 6144;
  const ProgramResult refused = draw(made_terrain(posts), limit_kb);
  EXPECT_EQ(refused.exit_code, 1);
  const double named = named_bytes(refused);
  const auto taken = static_cast<double>(added(made_terrain(65), made_terrain(posts)).peak_bytes);
  fmt::print("named {:.3g} GB, taken {:.3g} GB\n", named / 1e9, taken / 1e9);
  EXPECT_LT(named, 1.25 * taken);
  EXPECT_GT(named, 0.8 * taken);
}

// Fails if a bake that the kernel would kill is begun, or the figure is off by more than a half.
TEST_F(RefusalFigures, MemoryOfBakesIsRight) {
  setenv("OFFING_LONGEST_WAIT_S", "3600", 1);
  bake(1024);  // compiles, which takes as much memory as the bake
  // The program itself and its driver take some 110 MB of the limit, the bake 220 MB.
  const ProgramResult refused = bake(1024, 300'000);
  EXPECT_EQ(refused.exit_code, 1);
  const double named = named_bytes(refused);
  const ProgramResult small = bake(32), large = bake(1024);
  ASSERT_EQ(small.exit_code, 0) << small.errors;
  ASSERT_EQ(large.exit_code, 0) << large.errors;
  const double taken = static_cast<double>(large.peak_bytes) - static_cast<double>(small.peak_bytes);
  fmt::print("named {:.3g} GB, taken {:.3g} GB\n", named / 1e9, taken / 1e9);
  EXPECT_LT(named, 1.5 * taken);
  EXPECT_GT(named, taken / 1.5);
}

}  // namespace
}  // namespace offing::test

// Bakes that are killed or run out of disk: what stands under a final name is whole, and going on gives the
// files of an uninterrupted bake, byte for byte.
#include <chrono>
#include <csignal>
#include <memory>
#include <random>
#include <thread>

#include <gtest/gtest.h>
#include <sys/mount.h>

#include "tests/cli/folder_content.h"
#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

using Content = std::map<std::string, std::string>;
using Clock = std::chrono::steady_clock;

constexpr int kills = 20;
constexpr unsigned seed =
    20261;  // of the moments; they differ from run to run all the same, with the machine's load

std::vector<std::string> bake_arguments(const std::filesystem::path& folder) {
  return {"ocean", "bake",  "--size", "128",    "--patch-m", "400,60", "--frames",
          "0:39",  "--fps", "24",     "--seed", "3",         "-o",     folder.string()};
}

bool is_partial(const std::string& name) {
  return name.starts_with('.');
}

// Fails if a file under a final name is anything but the finished one.
void expect_whole_files(const Content& found, const Content& expected) {
  for (const auto& [name, bytes] : found) {
    if (is_partial(name)) continue;
    ASSERT_TRUE(expected.contains(name)) << name;
    EXPECT_TRUE(bytes == expected.at(name))
        << name << " is partial: " << bytes.size() << " bytes of " << expected.at(name).size();
  }
}

void expect_same_files(const Content& found, const Content& expected) {
  EXPECT_EQ(found.size(), expected.size());
  for (const auto& [name, bytes] : expected) {
    ASSERT_TRUE(found.contains(name)) << name;
    EXPECT_TRUE(found.at(name) == bytes) << name;
  }
}

class InterruptedBake : public testing::Test {
 protected:
  void SetUp() override {
    const TemporaryFolder folder;
    const auto start = Clock::now();
    const ProgramResult result = run_offing(bake_arguments(folder.path()));
    whole_bake_ = Clock::now() - start;
    ASSERT_EQ(result.exit_code, 0) << result.errors;
    expected_ = folder_content(folder.path());
  }

  // Starts the bake anew after each kill, as `processes` processes that share the frames.
  void kill_again_and_again(int processes) {
    const TemporaryFolder folder;
    std::mt19937 generator(seed + static_cast<unsigned>(processes));
    // So short that twenty of them do not finish the bake, so long that some write frames.
    std::uniform_real_distribution<double> moment_s(0.0, whole_bake_.count() / 6.0);
    int killed = 0;
    for (int attempt = 0; attempt < kills; ++attempt) {
      std::vector<std::unique_ptr<OffingProgram>> programs;
      for (int i = 1; i <= processes; ++i) programs.push_back(start(folder.path(), i, processes));
      std::this_thread::sleep_for(std::chrono::duration<double>(moment_s(generator)));
      for (const auto& program : programs) {
        program->send_signal(SIGKILL);
        if (program->wait().exit_code == 128 + SIGKILL) ++killed;
      }
      expect_whole_files(folder_content(folder.path()), expected_);
    }
    EXPECT_GT(killed, kills / 2) << "the bake was over before the kills: make it longer";
    for (int i = 1; i <= processes; ++i) EXPECT_EQ(start(folder.path(), i, processes)->wait().exit_code, 0);
    expect_same_files(folder_content(folder.path()), expected_);
  }

  static std::unique_ptr<OffingProgram> start(const std::filesystem::path& folder, int chunk, int chunks) {
    std::vector<std::string> arguments = bake_arguments(folder);
    if (chunks > 1) {
      arguments.insert(arguments.end(), {"--chunk", std::to_string(chunk) + "/" + std::to_string(chunks)});
    }
    return std::make_unique<OffingProgram>(arguments);
  }

  Content expected_;
  std::chrono::duration<double> whole_bake_{};
};

TEST_F(InterruptedBake, GoesOnAfterKills) {
  kill_again_and_again(1);
}

TEST_F(InterruptedBake, GoesOnAfterKillsOfTwoProcesses) {
  kill_again_and_again(2);
}

// A small file system that fills up: one clear error, exit 1, and the frames that fitted are whole.
TEST_F(InterruptedBake, SaysThatTheDiskIsFull) {
  std::size_t all_bytes = 0;
  for (const auto& [name, bytes] : expected_) all_bytes += bytes.size();
  const TemporaryFolder folder;
  const std::string options = "size=" + std::to_string(all_bytes / 2);
  if (mount("offing-test", folder.path().c_str(), "tmpfs", 0, options.c_str()) != 0) {
    GTEST_SKIP() << "only root can mount a small file system to fill";
  }
  const ProgramResult result = run_offing(bake_arguments(folder.path()));
  const Content found = folder_content(folder.path());
  umount(folder.path().c_str());
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_NE(result.errors.find("error: "), std::string::npos) << result.errors;
  EXPECT_NE(result.errors.find("No space left"), std::string::npos) << result.errors;
  EXPECT_NE(result.errors.find("hint: "), std::string::npos) << result.errors;
  expect_whole_files(found, expected_);
  EXPECT_GT(found.size(), 5u);
  for (const auto& [name, bytes] : found) EXPECT_FALSE(is_partial(name)) << name;
}

}  // namespace
}  // namespace offing::test

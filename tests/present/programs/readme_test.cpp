// The commands of README.md, as a newcomer pastes them after `./dev demo`.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <sstream>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"
#include "tests/present/virtual_display.h"
#include "tests/present/window/hands.h"

namespace offing::test {
namespace {

using ::testing::ElementsAre;

/// Commands of all blocks of a page, indented or between fences of the language sh, but for `./dev ...`.
std::vector<std::string> commands_of(const std::string& page) {
  std::vector<std::string> commands;
  std::istringstream lines(page);
  bool is_fenced = false, is_shell = false, goes_on = false;
  for (std::string line; std::getline(lines, line);) {
    if (line.starts_with("```")) {
      is_fenced = !is_fenced;
      is_shell = line == "```sh";
      continue;
    }
    if (!is_fenced && !line.starts_with("    ")) continue;
    const std::size_t first = line.find_first_not_of(' ');
    if ((is_fenced && !is_shell) || first == std::string::npos) continue;
    line.erase(0, first);
    const bool continues = line.ends_with('\\');
    if (continues) line.pop_back();
    if (goes_on) {
      commands.back() += line;
    } else if (!line.starts_with('#') && !line.starts_with("./dev")) {
      commands.push_back(line);
    } else {
      continue;
    }
    goes_on = continues;
  }
  return commands;
}

/// The files of a checkout, without builds and what Git keeps.
void copy_checkout(const std::filesystem::path& to) {
  for (const auto& entry : std::filesystem::directory_iterator(OFFING_SOURCES)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with('.') || name.starts_with("build") || name == "out") continue;
    std::filesystem::copy(entry.path(), to / name, std::filesystem::copy_options::recursive);
  }
}

/// Whether a command opens a window, which waits for its user.
bool opens_window(const std::string& command) {
  return command.starts_with("offing-view") && command.find(" --headless") == command.npos &&
         command.find(" --record") == command.npos && command.find(" --video") == command.npos;
}

// Fails if a block is overlooked, a line that goes on is cut, or a comment is run.
TEST(ReadmeTest, FindsEveryCommand) {
  EXPECT_THAT(
      commands_of("text\n\n    ./dev demo  # first\n    offing a \\\n        --b\n    # no\ntext `offing c`\n"
                  "```sh\noffing d\n```\n```cmake\nfind_package(Offing)\n```\n```python\nimport "
                  "offing\n```\n\n    offing-view\n"),
      ElementsAre("offing a --b", "offing d", "offing-view"));
}

// Fails if a command of README.md does not run as it is written, in order, in a fresh checkout with build/bin
// on PATH, or a window does not open and close. Some minutes: its bakes and recordings are whole ones.
TEST(ReadmeTest, EveryCommandRuns) {
  unsetenv("WAYLAND_DISPLAY");
  std::string reason;
  const auto display = VirtualDisplay::start(reason);
  if (!display) GTEST_SKIP() << reason;
  Hands hands;
  const TemporaryFolder checkout;
  copy_checkout(checkout.path());
  std::filesystem::current_path(checkout.path());
  setenv("PATH", fmt::format("{}:{}", OFFING_PROGRAMS, std::getenv("PATH")).c_str(), 1);
  std::ifstream file("README.md");
  const std::vector<std::string> commands = commands_of({std::istreambuf_iterator<char>(file), {}});
  ASSERT_GT(commands.size(), 15u);
  for (const std::string& command : commands) {
    using Clock = std::chrono::steady_clock;
    const Clock::time_point start = Clock::now();
    OffingProgram shell({"-e", "-o", "pipefail", "-c", command});
    bool had_window = false;
    while (shell.is_running()) {
      ASSERT_LT(Clock::now() - start, std::chrono::minutes(20)) << command;
      std::this_thread::sleep_for(std::chrono::milliseconds(300));
      if (!hands.has_window()) continue;
      had_window = true;
      hands.key("Control_L", Hands::Motion::down);
      hands.press("q");
      hands.key("Control_L", Hands::Motion::up);
    }
    const ProgramResult result = shell.wait();
    fmt::print("{:6.1f} s  {}\n", std::chrono::duration<double>(Clock::now() - start).count(), command);
    EXPECT_EQ(result.exit_code, 0) << command << "\n" << result.errors;
    EXPECT_EQ(had_window, opens_window(command)) << command << "\n" << result.errors;
  }
  std::filesystem::current_path("/");
}

}  // namespace
}  // namespace offing::test

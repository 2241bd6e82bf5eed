#include <sstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/offing_program.h"

// The help of each command, as a terminal shows it.

namespace offing::test {
namespace {

using testing::HasSubstr;

using Command = std::vector<std::string>;

/// The lines of a text.
std::vector<std::string> lines_of(const std::string& text) {
  std::istringstream stream(text);
  std::vector<std::string> lines;
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// Adds a command and all below it, which its help lists, and checks the lines of each help.
void check_lines(Command command, std::vector<Command>& checked) {
  checked.push_back(command);
  command.emplace_back("--help");
  const ProgramResult help = run_offing(command);
  EXPECT_EQ(help.exit_code, 0);
  bool is_list = false;
  for (const std::string& line : lines_of(help.output)) {
    EXPECT_LE(line.size(), 110u) << line;
    if (is_list && !line.empty()) {
      std::istringstream(line) >> command.back();
      check_lines(command, checked);
    }
    is_list = line == "Subcommands:" || (is_list && !line.empty());
  }
}

// Fails if a line is longer than terminals are wide, which break it anywhere then.
TEST(Help, LinesAreShort) {
  std::vector<Command> checked;
  check_lines({}, checked);
  for (const Command& command : {Command{"scene", "import"}, {"terrain", "viewshed"}, {"clouds", "build"}})
    EXPECT_THAT(checked, testing::Contains(command)) << "its help does not list all commands";
}

// Fails if a flag loses its unit, range or default.
TEST(Help, FlagsHaveUnitsRangesAndDefaults) {
  const std::string help = run_offing({"ocean", "bake", "--help"}).output;
  EXPECT_THAT(help, HasSubstr("--fetch-m X "));
  EXPECT_THAT(help, HasSubstr(" a number in m within [100, 10000000]; default 100000\n"));
  EXPECT_THAT(help, HasSubstr(" one of phillips, pm, jonswap, tma, swell; default jonswap\n"));
  EXPECT_THAT(help, HasSubstr("-o,--output DIR (required)"));
}

}  // namespace
}  // namespace offing::test

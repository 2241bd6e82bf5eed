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

const std::vector<std::vector<std::string>> commands = {{},
                                                        {"bodies"},
                                                        {"bodies", "info"},
                                                        {"bodies", "motion"},
                                                        {"bodies", "rao"},
                                                        {"devices"},
                                                        {"highlights"},
                                                        {"ocean"},
                                                        {"ocean", "bake"},
                                                        {"ocean", "query"},
                                                        {"ocean", "spectrum"},
                                                        {"ocean", "stats"},
                                                        {"scene"},
                                                        {"scene", "check"},
                                                        {"scene", "keys"},
                                                        {"scene", "new"},
                                                        {"scene", "schema"}};

// Fails if a line is longer than terminals are wide, which break it anywhere then.
TEST(Help, LinesAreShort) {
  for (std::vector<std::string> arguments : commands) {
    arguments.push_back("--help");
    const ProgramResult help = run_offing(arguments);
    EXPECT_EQ(help.exit_code, 0);
    std::istringstream lines(help.output);
    for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 110u) << line;
  }
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

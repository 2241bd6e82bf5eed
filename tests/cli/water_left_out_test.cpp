// Water of a scene that its sea alone does not have.
#include <fstream>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "tests/cli/offing_program.h"
#include "tests/io/temporary_folder.h"

namespace offing::test {
namespace {

// Fails if wakes, bodies or shores of a scene are left out without a word by a bake, or shores by a query, or
// if a scene of none is warned of; a query has wakes and bodies.
TEST(WaterLeftOut, HasAWarning) {
  const TemporaryFolder folder;
  const auto scene = folder.path() / "a.toml", alone = folder.path() / "b.toml";
  const std::string sea = "version = 1\n[ocean]\nsize = 16\ncascade_count = 1\n";
  std::ofstream(alone) << sea;
  std::ofstream(scene) << sea +
                              "[[ocean.wake]]\n[[ocean.wake]]\n[[mesh]]\nname = \"hull\"\nshape = \"ship\"\n"
                              "[[body]]\nname = \"ferry\"\nmesh = \"hull\"\n[terrain]\nposts = 33\n";
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"bake", "--frames", "0:0", "-o", (folder.path() / "out").string(),
                                 "--force"},
        {"query", "--at", "0,0"}}) {
    const auto errors_of = [&](const std::string& file) {
      std::vector<std::string> arguments = {"ocean", command[0], file};
      arguments.insert(arguments.end(), command.begin() + 1, command.end());
      const ProgramResult result = run_offing(arguments);
      EXPECT_EQ(result.exit_code, 0) << result.errors;
      return result.errors;
    };
    const std::string errors = errors_of(scene.string());
    const std::string results = command[0] == "bake" ? "frames" : "answers";
    for (const char* part : {"[[ocean.wake]] 1", "[[ocean.wake]] 2", "[[body]] \"ferry\"", "[terrain]"}) {
      const auto warning = testing::HasSubstr(std::string(part) + ": " + results + " leave out ");
      if (command[0] == "bake" || std::string(part) == "[terrain]") {
        EXPECT_THAT(errors, warning) << command[0];
      } else {
        EXPECT_THAT(errors, testing::Not(warning));
      }
    }
    EXPECT_THAT(errors_of(alone.string()), testing::Not(testing::HasSubstr("leave out"))) << command[0];
  }
}

}  // namespace
}  // namespace offing::test

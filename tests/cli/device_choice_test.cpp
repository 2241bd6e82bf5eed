#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/cli/folder_content.h"
#include "tests/cli/offing_program.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::test {
namespace {

using testing::HasSubstr;
using testing::Not;

std::vector<std::string> bake(const std::filesystem::path& folder, const std::vector<std::string>& more) {
  std::vector<std::string> arguments = {"ocean",    "bake", "--size",    "16", "--cascades",   "1",
                                        "--frames", "0:7",  "--verbose", "-o", folder.string()};
  arguments.insert(arguments.end(), more.begin(), more.end());
  return arguments;
}

// Fails if OFFING_DEVICE=all does not do what --device all does, or either leaves a device idle. PoCL offers
// its CPU twice here, and both compile alike, so that frames are equal to the bit.
TEST(DeviceChoice, BakesOnAllDevices) {
  const ScopedEnvironment two_devices("POCL_DEVICES", "pthread basic");
  const auto devices = nlohmann::json::parse(run_offing({"devices", "--json"}).output);
  if (devices.size() < 2) {
    GTEST_SKIP() << "there is one OpenCL device, and PoCL does not offer a second";
  }
  const TemporaryFolder root;
  const ProgramResult one = run_offing(bake(root.path() / "one", {"--device", "0"}));
  EXPECT_THAT(one.errors, Not(HasSubstr("device 1:")));
  const ProgramResult by_flag = run_offing(bake(root.path() / "flag", {"--device", "all"}));
  const ScopedEnvironment all("OFFING_DEVICE", "all");
  const ProgramResult by_environment = run_offing(bake(root.path() / "environment", {}));
  for (const ProgramResult& result : {by_flag, by_environment}) {
    EXPECT_EQ(result.exit_code, 0) << result.errors;
    EXPECT_THAT(result.errors, HasSubstr("device 0:"));
    EXPECT_THAT(result.errors, HasSubstr("device 1:"));
  }
  EXPECT_TRUE(folder_content(root.path() / "one") == folder_content(root.path() / "flag"));
  EXPECT_TRUE(folder_content(root.path() / "one") == folder_content(root.path() / "environment"));
}

// Fails if a command that uses one device takes "all" for a name, or does not say who asked for it.
TEST(DeviceChoice, RefusesAllForOneDevice) {
  const std::vector<std::string> stats = {"ocean",      "stats", "--size",  "16",
                                          "--cascades", "1",     "--seeds", "1"};
  std::vector<std::string> by_flag = stats;
  by_flag.insert(by_flag.end(), {"--device", "all"});
  const ProgramResult flag = run_offing(by_flag);
  EXPECT_EQ(flag.exit_code, 2);
  EXPECT_THAT(flag.errors,
              HasSubstr("error: --device: expected one device, got \"all\"\nhint: name a device"));

  const ScopedEnvironment all("OFFING_DEVICE", "all");
  const ProgramResult environment = run_offing(stats);
  EXPECT_EQ(environment.exit_code, 2);
  EXPECT_THAT(environment.errors,
              HasSubstr("error: OFFING_DEVICE: expected one device, got \"all\"\nhint: "));
  EXPECT_EQ(run_offing({"ocean", "stats", "--size", "16", "--seeds", "1", "--device", "0"}).exit_code, 0);
  const ProgramResult listing = run_offing({"devices"});
  EXPECT_EQ(listing.exit_code, 0);
  EXPECT_THAT(listing.errors, HasSubstr("warning: OFFING_DEVICE: expected one device"));
  const ProgramResult quiet = run_offing({"devices", "--quiet"});
  EXPECT_EQ(quiet.exit_code, 0);
  EXPECT_EQ(quiet.output, listing.output);
  EXPECT_EQ(quiet.errors, "");
}

}  // namespace
}  // namespace offing::test

#include <string>

#include <CLI/App.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/cli/commands.h"
#include "tests/cli/option_faults.h"

namespace offing::test {
namespace {

using testing::IsEmpty;
using testing::SizeIs;

// Fails if somebody adds an option that takes a number, or makes a choice, without a row: its range, unit and
// default are written by hand then and drift apart from the help, the message or the scene.
TEST(OptionRows, AreThereForEachNumberOfOffing) {
  const CancelToken cancel;
  cli::GlobalOptions options{.device = {}, .cancel = cancel};
  CLI::App app;
  cli::add_commands(app, options);
  const OptionReport report = report_options(
      app, {"FILE",       "PATTERN",    "SCENE",           "STORE",    "channels", "colour", "compare",
            "depth",      "device",     "export-spectrum", "grid",     "layer",    "needed", "output",
            "plot",       "points",     "preset",          "shares",   "swell",    "union",  "body",
            "canopy-map", "directions", "periods",         "horizons", "masks",    "step"});
  EXPECT_THAT(report.faults, IsEmpty());
  EXPECT_THAT(report.numbers, SizeIs(testing::Gt(100u)));
}

// Fails if the walk takes an option without a row for one that has it.
TEST(OptionRows, AreMissedInOptionsWrittenByHand) {
  CLI::App app{"", "program"};
  std::string text;
  app.add_subcommand("command")->add_option("--step-m", text, "a number in m within [0, 1]; default 1");
  EXPECT_THAT(
      report_options(app, {"output"}).faults,
      testing::ElementsAre("program command step-m: expected a row, found an option written by hand"));
}

}  // namespace
}  // namespace offing::test

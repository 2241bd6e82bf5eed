#include <CLI/App.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "mesh_tools/commands/mesh_commands.h"
#include "tests/cli/option_faults.h"

namespace offing::mesh_tools {
namespace {

// Fails if a command takes a number or makes a choice without a row of a schema.
TEST(MeshOptions, HaveRows) {
  const CancelToken cancel;
  Options options{.cancel = cancel};
  CLI::App app;
  add_commands(app, options);
  const test::OptionReport report = test::report_options(app, {"FILE", "output"});
  EXPECT_THAT(report.faults, testing::IsEmpty());
  EXPECT_THAT(report.numbers, testing::SizeIs(testing::Gt(50u)));
}

}  // namespace
}  // namespace offing::mesh_tools

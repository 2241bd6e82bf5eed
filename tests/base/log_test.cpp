#include "host/base/log.h"

#include <string>
#include <utility>

#include <gtest/gtest.h>

namespace offing {
namespace {

// What a line of each level leaves on stdout and stderr.
std::pair<std::string, std::string> printed(Verbosity verbosity) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  configure_log(verbosity);
  spdlog::debug("details");
  spdlog::info("progress");
  spdlog::warn("doubt");
  spdlog::error("fault");
  spdlog::default_logger()->flush();
  std::string errors = testing::internal::GetCapturedStderr();
  return {testing::internal::GetCapturedStdout(), std::move(errors)};
}

// Fails if a verbosity shows too much or too little, if lines lose their form "level: text" that scripts
// read, or if one of them lands among the results on stdout.
TEST(LogTest, ShowsWhatTheVerbosityAsksFor) {
  const std::pair<Verbosity, const char*> expected[] = {
      {Verbosity::quiet, "error: fault\n"},
      {Verbosity::normal, "info: progress\nwarning: doubt\nerror: fault\n"},
      {Verbosity::verbose, "debug: details\ninfo: progress\nwarning: doubt\nerror: fault\n"}};
  for (const auto& [verbosity, lines] : expected) {
    const auto [results, log] = printed(verbosity);
    EXPECT_EQ(log, lines);
    EXPECT_EQ(results, "");
  }
  configure_log(Verbosity::normal);
}

}  // namespace
}  // namespace offing

#include "host/base/work.h"

#include <csignal>

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing {
namespace {

CancelToken token_of_handler;

// Fails if a token that nobody cancelled stops work, or a cancelled one lets it go on, once or later.
TEST(CancelTokenTest, StopsWorkFromTheFirstCancelOn) {
  CancelToken token;
  EXPECT_FALSE(token.cancelled());
  EXPECT_NO_THROW(token.throw_if_cancelled());
  for (int i = 0; i < 2; ++i) {
    token.cancel();
    EXPECT_TRUE(token.cancelled());
    try {
      token.throw_if_cancelled();
      ADD_FAILURE() << "work goes on";
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::cancelled);
      EXPECT_FALSE(error.hint().empty());
      EXPECT_EQ(exit_code(error.kind()), 130);
    }
  }
}

// Fails if Ctrl-C does not reach the work: the handler is all that may run between two instructions.
TEST(CancelTokenTest, IsSetBySignalHandlers) {
  const auto previous = std::signal(SIGINT, [](int) { token_of_handler.cancel(); });
  ASSERT_EQ(std::raise(SIGINT), 0);
  std::signal(SIGINT, previous);
  EXPECT_TRUE(token_of_handler.cancelled());
}

}  // namespace
}  // namespace offing

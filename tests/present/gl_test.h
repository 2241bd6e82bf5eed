#pragma once

#include <optional>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "present/gl/gl_context.h"

namespace offing::test {

/// A test with a headless OpenGL context; skips, with the reason, where there is none. No case may leave an
/// OpenGL error behind.
class GlTest : public testing::Test {
 protected:
  void SetUp() override {
    try {
      context_.emplace(present::GlContext::headless());
    } catch (const Error& error) {
      GTEST_SKIP() << "no OpenGL here: " << error.what();
    }
    RecordProperty("renderer", context_->capabilities().renderer);
  }
  void TearDown() override {
    if (!context_) return;
    EXPECT_NO_THROW(present::require_no_gl_error("end of the test"));
  }

  std::optional<present::GlContext> context_;
};

}  // namespace offing::test

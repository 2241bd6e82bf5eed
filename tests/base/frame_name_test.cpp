#include "host/base/frame_name.h"

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing {
namespace {

FrameName named(const char* pattern) {
  return {"--record", pattern, "out_%04d.png"};
}

// Fails if numbers lose their zeros, or long ones their digits.
TEST(FrameNameTest, NumbersFrames) {
  EXPECT_EQ(named("a/out_%04d.png").of(7), "a/out_0007.png");
  EXPECT_EQ(named("out_%04d.exr").of(123456), "out_123456.exr");
  EXPECT_EQ(named("%d.png").of(12), "12.png");
}

// Fails if a pattern is taken by which frames would overwrite each other, or that printf would take for more.
TEST(FrameNameTest, RefusesOtherPatterns) {
  for (const char* pattern : {"out.png", "%04d_%04d.png", "out_%s.png", "out_%99d.png"}) {
    EXPECT_THROW(named(pattern), Error) << pattern;
  }
}

}  // namespace
}  // namespace offing

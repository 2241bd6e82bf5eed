#include "host/io/frame_name.h"

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

// Fails if a file of a sequence is missed, or another file is taken for one.
TEST(FrameNameTest, KnowsItsFrames) {
  const FrameName padded = named("a/out_%04d.png");
  EXPECT_EQ(padded.frame_of("out_0007.png"), 7);
  EXPECT_EQ(padded.frame_of("out_123456.png"), 123456);
  for (const char* other : {"out_7.png", "out_00007.png", "out_.png", "out_-007.png", "out_0007.png.bak",
                            "xout_0007.png", "out_99999999999999.png", "a/out_0007.png"}) {
    EXPECT_EQ(padded.frame_of(other), std::nullopt) << other;
  }
  EXPECT_EQ(padded.prefix(), "out_");
  EXPECT_TRUE(padded.is_one_folder());
  EXPECT_EQ(named("%d.png").frame_of("12.png"), 12);
  EXPECT_FALSE(named("%d/a.png").is_one_folder());
  EXPECT_EQ(padded.in("b").of(7), "b/a/out_0007.png");
}

// Fails if a pattern is taken by which frames would overwrite each other, or that printf would take for more.
TEST(FrameNameTest, RefusesOtherPatterns) {
  for (const char* pattern : {"out.png", "%04d_%04d.png", "out_%s.png", "out_%99d.png"}) {
    EXPECT_THROW(named(pattern), Error) << pattern;
  }
}

}  // namespace
}  // namespace offing

#include "host/base/argument.h"

#include <algorithm>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/cli/ocean/bake_settings.h"
#include "tests/ocl/expect_error.h"

namespace offing::cli {
namespace {

// Fails if either end of a range of frames is lost, or a single frame is not a range.
TEST(Argument, ReadsFrameRanges) {
  const FrameRange range = read_frame_range("--frames", "3:12");
  EXPECT_EQ(range.first, 3);
  EXPECT_EQ(range.last, 12);
  EXPECT_EQ(read_frame_range("--frames", "5").first, 5);
  EXPECT_EQ(read_frame_range("--frames", "5").last, 5);
}

// Fails if a text that is no range is taken for one.
TEST(Argument, RefusesOtherFrameRanges) {
  for (const char* text : {"", ":", "1:", ":2", "9:0", "-1:3", "1:2:3", "a:b", "0x1:2",
                           "1:99999999999999999999", " 1:2", "0:10000000", "1.5:2"}) {
    test::expect_error(ErrorKind::bad_usage, "--frames: expected A:B with 0 <= A <= B <= 9999999, got",
                       [&] { read_frame_range("--frames", text); });
  }
}

// Fails if an end of the range is refused, or a text that is no number taken for one.
TEST(Argument, ReadsLengths) {
  EXPECT_EQ(read_number("--velocity-depth-m", "0", "m", 0.0, 20.0, "2.5"), 0.0);
  EXPECT_EQ(read_number("--velocity-depth-m", "20", "m", 0.0, 20.0, "2.5"), 20.0);
  EXPECT_EQ(read_number("--velocity-depth-m", "1.25e1", "m", 0.0, 20.0, "2.5"), 12.5);
  for (const char* text : {"", "-1", "20.001", "2 m", "nan", "inf", "0x2", " 2"}) {
    test::expect_error(ErrorKind::bad_usage, "--velocity-depth-m: expected a number in m within [0, 20], got",
                       [&] { read_number("--velocity-depth-m", text, "m", 0.0, 20.0, "2.5"); });
  }
}

// Fails if shares are counted from 0 outside or from 1 inside.
TEST(Argument, ReadsShares) {
  const Share share = read_share("--chunk", "2/8");
  EXPECT_EQ(share.index, 1);
  EXPECT_EQ(share.count, 8);
  for (const char* text : {"0/4", "5/4", "1/0", "1", "/", "-1/2", "1/100001"}) {
    test::expect_error(ErrorKind::bad_usage, "--chunk: expected i/n", [&] { read_share("--chunk", text); });
  }
}

// Fails if a frame is in two shares or in none, or shares differ by more than a frame.
TEST(Argument, SharesPartitionTheFrames) {
  const FrameRange range{7, 29};
  for (const int count : {1, 2, 3, 5, 23, 40}) {
    std::vector<int> all;
    std::size_t fewest = 1000, most = 0;
    for (int index = 0; index < count; ++index) {
      const std::vector<int> own = frames_in_share(range, {index, count});
      all.insert(all.end(), own.begin(), own.end());
      fewest = std::min(fewest, own.size());
      most = std::max(most, own.size());
    }
    std::sort(all.begin(), all.end());
    ASSERT_EQ(all.size(), 23u) << count;
    for (int i = 0; i < 23; ++i) {
      EXPECT_EQ(all[i], 7 + i);
    }
    EXPECT_LE(most - fewest, 1u);
  }
}

// Fails if a channel name is mixed up, or an unknown or empty one passes.
TEST(Argument, ReadsChannels) {
  const ChannelGroups groups = read_channels("--channels", "displacement,foam");
  EXPECT_TRUE(groups.test(static_cast<std::size_t>(ChannelGroup::displacement)));
  EXPECT_TRUE(groups.test(static_cast<std::size_t>(ChannelGroup::foam)));
  EXPECT_EQ(groups.count(), 2u);
  for (const char* text : {"", "foam,", "height", "Foam"}) {
    test::expect_error(ErrorKind::bad_usage, "--channels: expected names from",
                       [&] { read_channels("--channels", text); });
  }
}

// Fails if two ways of writing a frame have the same canonical text: their hashes would mix.
TEST(Argument, CanonicalTextTellsSettingsApart) {
  BakeSettings settings;
  std::vector<std::string> texts = {canonical_text(settings)};
  settings.layout = FileLayout::combined;
  texts.push_back(canonical_text(settings));
  settings.pixel_type = PixelType::half_16;
  texts.push_back(canonical_text(settings));
  settings.compression = ExrCompression::piz;
  texts.push_back(canonical_text(settings));
  settings.channels.set(3);
  texts.push_back(canonical_text(settings));
  std::sort(texts.begin(), texts.end());
  EXPECT_EQ(std::unique(texts.begin(), texts.end()), texts.end());
}

}  // namespace
}  // namespace offing::cli

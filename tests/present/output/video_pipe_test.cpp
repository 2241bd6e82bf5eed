#include "present/output/video_pipe.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"
#include "tests/present/output/stand_in_ffmpeg.h"

namespace offing::present {
namespace {

using test::StandInFfmpeg;
using ::testing::HasSubstr;

/// A picture of one hue that grows lighter to the right, a little otherwise in each frame.
RgbImage frame(int number, int width = 64, int height = 48) {
  RgbImage image{.width = width, .height = height, .rgb = {}};
  for (int row = 0; row < height; ++row) {
    for (int column = 0; column < width; ++column) {
      const auto light = static_cast<std::uint8_t>(60 + 2 * column + number);
      image.rgb.insert(image.rgb.end(),
                       {light, static_cast<std::uint8_t>(light - 20), static_cast<std::uint8_t>(light - 40)});
    }
  }
  return image;
}

std::vector<std::uint8_t> bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::size_t count_of(const std::filesystem::path& folder) {
  return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

class VideoPipeTest : public testing::Test {
 protected:
  void expect_fault(const std::function<void()>& deed, ErrorKind kind, const std::string& what) const {
    try {
      deed();
      ADD_FAILURE() << "expected: " << what;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), kind) << error.what();
      EXPECT_THAT(error.what(), HasSubstr(what));
      EXPECT_FALSE(error.hint().empty());
    }
    EXPECT_EQ(count_of(folder_.path()), 0u) << "a part of a video is left behind";
  }

  TemporaryFolder folder_;
  std::filesystem::path webm_ = folder_.path() / "배 ü; $(x).webm";
};

// Fails if ffmpeg gets other frames than there are, or other words about them; if the file is there before it
// is whole, or under a name that a shell has changed.
TEST_F(VideoPipeTest, PassesFramesAsTheyAre) {
  const StandInFfmpeg ffmpeg;
  VideoPipe pipe(webm_, 23.976, Existing::replace);
  std::vector<std::uint8_t> all;
  for (int i = 0; i < 3; ++i) {
    const RgbImage image = frame(i);
    pipe.write(image);
    all.insert(all.end(), image.rgb.begin(), image.rgb.end());
    EXPECT_FALSE(std::filesystem::exists(webm_));
  }
  pipe.finish();
  EXPECT_TRUE(bytes_of(webm_) == all);
  EXPECT_EQ(count_of(folder_.path()), 1u);
  EXPECT_THAT(ffmpeg.arguments(), HasSubstr("-video_size\n64x48\n-framerate\n23.976\n-i\npipe:0\n"));
  EXPECT_THAT(ffmpeg.arguments(), HasSubstr("libvpx-vp9"));
}

// Fails if a recording that ends early leaves a part of a video, or ffmpeg running.
TEST_F(VideoPipeTest, LeavesNoPartOfAVideo) {
  const StandInFfmpeg ffmpeg;
  {
    VideoPipe pipe(webm_, 24.0, Existing::replace);
    pipe.write(frame(0));
  }
  EXPECT_EQ(count_of(folder_.path()), 0u);
}

// Fails if ffmpeg's own end ends this program, is not told of, or its words are lost; larger frames than
// fit between the two programs are written by then.
TEST_F(VideoPipeTest, TellsWhyFfmpegGaveUp) {
  const StandInFfmpeg ffmpeg("head -c 10 > /dev/null; echo 'no such coder: libx264' >&2; echo >&2; exit 1");
  expect_fault(
      [&] {
        VideoPipe pipe(folder_.path() / "a.mp4", 24.0, Existing::replace);
        for (int i = 0; i < 3; ++i) pipe.write(frame(i, 640, 480));
        pipe.finish();
      },
      ErrorKind::file, "a.mp4: ffmpeg failed: no such coder: libx264");
  // Closed before it says why, and in a line longer than a buffer.
  const StandInFfmpeg slow(
      "exec < /dev/null; sleep 0.3; printf '%0600d' 0 >&2; sleep 0.1; echo ' is the end' >&2; exit 1");
  expect_fault(
      [&] {
        VideoPipe pipe(folder_.path() / "a.mp4", 24.0, Existing::replace);
        for (int i = 0; i < 3; ++i) pipe.write(frame(i, 640, 480));
        pipe.finish();
      },
      ErrorKind::file, "ffmpeg failed: " + std::string(600, '0') + " is the end");
  const StandInFfmpeg other("cat > /dev/null; exit 3");
  expect_fault(
      [&] {
        VideoPipe pipe(webm_, 24.0, Existing::replace);
        pipe.write(frame(0));
        pipe.finish();
      },
      ErrorKind::file, "ffmpeg failed");
}

// Fails if what cannot become a video is found out after the work.
TEST_F(VideoPipeTest, WhatCannotBeIsToldBeforehand) {
  const StandInFfmpeg ffmpeg;
  require_video(webm_);
  require_video_size(webm_, 63, 47);
  expect_fault([&] { require_video(folder_.path() / "a.avi"); }, ErrorKind::bad_usage,
               "expected a name that ends in .webm or .mp4");
  expect_fault([&] { require_video_size(folder_.path() / "a.mp4", 63, 48); }, ErrorKind::bad_usage,
               "expected an even width and height, which .mp4 needs, got 63x48");
  ffmpeg.take_away();
  expect_fault([&] { require_video(webm_); }, ErrorKind::file,
               "expected the program ffmpeg on PATH, found none");
}

// Fails if frames of another size shift the picture.
TEST_F(VideoPipeTest, FramesHaveOneSize) {
  const StandInFfmpeg ffmpeg;
  expect_fault(
      [&] {
        VideoPipe pipe(webm_, 24.0, Existing::replace);
        pipe.write(frame(0));
        pipe.write(frame(1, 32, 48));
      },
      ErrorKind::bad_usage, "expected frames of one size, 64x48, got one of 32x48");
}

// Fails if ffmpeg itself does not take the arguments, frames are lost, upside down or of other colours, or
// equal frames do not give equal bytes. Coded colours differ by rounding to 8 bits of luma and chroma and by
// what the coder leaves out: measured 1.4 of 255 in the mean, gate 3.
TEST_F(VideoPipeTest, FfmpegMakesAVideo) {
  const auto ffmpeg = find_program("ffmpeg");
  if (!ffmpeg) GTEST_SKIP() << "ffmpeg is not installed";
  for (const char* name : {"a.webm", "a.mp4"}) {
    const std::filesystem::path video = folder_.path() / name, raw = folder_.path() / "raw";
    std::vector<std::uint8_t> first;
    for (int run = 0; run < 2; ++run) {
      VideoPipe pipe(video, 10.0, Existing::replace);
      for (int i = 0; i < 5; ++i) pipe.write(frame(i));
      pipe.finish();
      if (run == 0) first = bytes_of(video);
    }
    EXPECT_TRUE(bytes_of(video) == first) << name << " differs from run to run";
    FedProgram decoder(
        *ffmpeg, {"-loglevel", "error", "-i", "file:" + video.string(), "-vf", "scale=in_color_matrix=bt709",
                  "-pix_fmt", "rgb24", "-f", "rawvideo", "-y", "file:" + raw.string()});
    ASSERT_TRUE(decoder.finish()) << decoder.last_words();
    const std::vector<std::uint8_t> bytes = bytes_of(raw);
    ASSERT_EQ(bytes.size(), 5 * frame(0).rgb.size()) << name;
    double difference = 0.0;
    for (int i = 0; i < 5; ++i) {
      const RgbImage expected = frame(i);
      for (std::size_t k = 0; k < expected.rgb.size(); ++k) {
        difference +=
            std::abs(bytes[static_cast<std::size_t>(i) * expected.rgb.size() + k] - expected.rgb[k]);
      }
    }
    const double mean = difference / static_cast<double>(bytes.size());
    RecordProperty(name, std::to_string(mean));
    EXPECT_LT(mean, 3.0) << name;
  }
}

}  // namespace
}  // namespace offing::present

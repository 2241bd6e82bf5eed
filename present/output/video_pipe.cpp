#include "present/output/video_pipe.h"

#include <string>
#include <vector>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/file_extension.h"

namespace offing::present {
namespace {

constexpr const char* program = "ffmpeg";

std::filesystem::path found_ffmpeg(const std::filesystem::path& file) {
  if (auto found = find_program(program)) return *found;
  throw Error(ErrorKind::file,
              fmt::format("{}: expected the program ffmpeg on PATH, found none", file.string()),
              "install ffmpeg, or write pictures, such as out_%04d.png");
}

bool is_mp4(const std::filesystem::path& file) {
  return file.extension() == ".mp4";
}

/// What ffmpeg makes of sRGB pictures: samples of BT.709 at half the resolution of colour, which all players
/// know, and nothing in the file that differs from run to run.
std::vector<std::string> arguments_of(const std::filesystem::path& file, const std::filesystem::path& output,
                                      double frames_per_second, int width, int height) {
  std::vector<std::string> arguments{"-hide_banner",
                                     "-loglevel",
                                     "error",
                                     "-f",
                                     "rawvideo",
                                     "-pixel_format",
                                     "rgb24",
                                     "-video_size",
                                     fmt::format("{}x{}", width, height),
                                     "-framerate",
                                     fmt::format("{}", frames_per_second),
                                     "-i",
                                     "pipe:0",
                                     "-an",
                                     "-vf",
                                     "scale=out_color_matrix=bt709:out_range=tv,format=yuv420p",
                                     "-colorspace",
                                     "bt709",
                                     "-color_primaries",
                                     "bt709",
                                     "-color_trc",
                                     "iec61966-2-1",
                                     "-color_range",
                                     "tv",
                                     "-map_metadata",
                                     "-1",
                                     "-fflags",
                                     "+bitexact",
                                     "-flags:v",
                                     "+bitexact"};
  const std::vector<std::string> mp4{"-c:v", "libx264", "-preset", "medium",    "-crf",
                                     "16",   "-f",      "mp4",     "-movflags", "+faststart"};
  const std::vector<std::string> webm{"-c:v",      "libvpx-vp9", "-crf",    "20", "-b:v", "0",
                                      "-cpu-used", "4",          "-row-mt", "1",  "-f",   "webm"};
  const std::vector<std::string>& coder = is_mp4(file) ? mp4 : webm;
  arguments.insert(arguments.end(), coder.begin(), coder.end());
  // The file is there already, empty. Without the protocol a name could be taken for an address or an option.
  arguments.insert(arguments.end(), {"-y", "file:" + output.string()});
  return arguments;
}

}  // namespace

bool is_video_name(const std::filesystem::path& file) {
  return is_mp4(file) || file.extension() == ".webm";
}

bool has_ffmpeg() {
  return find_program(program).has_value();
}

void require_video(const std::filesystem::path& file) {
  require_extension(file, {".webm", ".mp4"});
  found_ffmpeg(file);
}

void require_video_size(const std::filesystem::path& file, int width, int height) {
  if (fitting_side(file, width) == width && fitting_side(file, height) == height) return;
  throw Error(ErrorKind::bad_usage,
              fmt::format("{}: expected an even width and height, which .mp4 needs, got {}x{}", file.string(),
                          width, height),
              fmt::format("--size {}x{}, or a video in .webm", width + width % 2, height + height % 2));
}

int fitting_side(const std::filesystem::path& file, int side) {
  return is_mp4(file) && side > 1 ? side - side % 2 : side;
}

void VideoPipe::start(int width, int height) {
  require_video_size(file_, width, height);
  width_ = width;
  height_ = height;
  const std::filesystem::path ffmpeg = found_ffmpeg(file_);
  target_.emplace(file_, existing_);
  ffmpeg_.emplace(ffmpeg, arguments_of(file_, target_->temporary(), frames_per_second_, width, height));
}

void VideoPipe::write(const RgbImage& frame) {
  if (!ffmpeg_) start(frame.width, frame.height);
  if (frame.width != width_ || frame.height != height_) {
    throw Error(ErrorKind::bad_usage,
                fmt::format("{}: expected frames of one size, {}x{}, got one of {}x{}", file_.string(),
                            width_, height_, frame.width, frame.height),
                "do not resize the window while it records, or record without --window");
  }
  if (!ffmpeg_->feed(frame.rgb)) fail();
}

void VideoPipe::finish() {
  if (!ffmpeg_ || !ffmpeg_->finish()) fail();
  target_->commit();
}

void VideoPipe::fail() const {
  const std::string words = ffmpeg_ ? ffmpeg_->last_words() : "";
  throw Error(
      ErrorKind::file, fmt::format("{}: ffmpeg failed{}{}", file_.string(), words.empty() ? "" : ": ", words),
      is_mp4(file_)
          ? "check that this ffmpeg has libx264 and that the disk has free space, or record a .webm"
          : "check that this ffmpeg has libvpx-vp9 and that the disk has free space, or record an .mp4");
}

}  // namespace offing::present

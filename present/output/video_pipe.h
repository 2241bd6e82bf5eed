#pragma once

#include <filesystem>
#include <optional>
#include <utility>

#include "host/io/atomic_file.h"
#include "host/io/png_image.h"
#include "present/output/fed_program.h"

namespace offing::present {

/// Whether a name is that of a video: it ends in .mp4 or .webm.
bool is_video_name(const std::filesystem::path& file);

/// Whether the program ffmpeg is there, which makes videos.
bool has_ffmpeg();
/// Throws, before any work is done, Error(bad_usage) for what is no name of a video, Error(file) where the
/// program ffmpeg is not found.
void require_video(const std::filesystem::path& file);
/// Throws Error(bad_usage) for a size that this video cannot have: mp4 takes even sides alone.
void require_video_size(const std::filesystem::path& file, int width, int height);
/// The longest side up to this one that it can have.
int fitting_side(const std::filesystem::path& file, int side);

/// A video that ffmpeg makes of the frames that it is fed: H.264 in .mp4, VP9 in .webm, of near to no visible
/// loss. Equal frames give equal bytes where ffmpeg does. The file is there once it is whole.
class VideoPipe {
 public:
  VideoPipe(std::filesystem::path file, double frames_per_second, Existing existing)
      : file_(std::move(file)), frames_per_second_(frames_per_second), existing_(existing) {}

  /// The next frame, sRGB, the first row at the top. Throws Error(bad_usage) for one of another size than the
  /// first, Error(file) where ffmpeg has ended, with what it says.
  void write(const RgbImage& frame);
  /// Waits for ffmpeg and puts the file in its place. Throws Error(file).
  void finish();

 private:
  void start(int width, int height);
  [[noreturn]] void fail() const;

  std::filesystem::path file_;
  double frames_per_second_;
  Existing existing_;
  int width_ = 0, height_ = 0;
  // In this order: ffmpeg ends before the file goes that it writes to.
  std::optional<AtomicFile> target_;
  std::optional<FedProgram> ffmpeg_;
};

}  // namespace offing::present

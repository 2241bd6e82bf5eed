#pragma once

#include <optional>

#include "present/output/recording.h"
#include "present/output/video_pipe.h"
#include "present/passes/frame.h"

namespace offing::present {

/// Writes the frames of a recording: a picture each, a video of all, or both.
class Recorder {
 public:
  explicit Recorder(const Recording& recording);

  /// The next frame, as it was drawn last at that time and exposure. Throws Error(file).
  void write(const Frame& drawn, double time_s, double exposure);
  /// How many were written.
  int count() const { return count_; }
  bool is_complete() const { return count_ == recording_.count(); }
  /// Ends the video after the last frame; Error(file) where it cannot be made.
  void finish();

 private:
  Recording recording_;
  std::optional<VideoPipe> video_;
  int count_ = 0;
};

}  // namespace offing::present

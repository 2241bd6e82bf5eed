#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/command_line/input_files.h"
#include "host/io/atomic_file.h"
#include "host/io/frame_name.h"
#include "present/output/highlight_layer.h"
#include "present/output/video_pipe.h"
#include "present/passes/frame.h"

namespace offing::present {

/// Frames to be written: a picture each, a video of all, or both.
struct Recording {
  std::optional<FrameName> name = {};  ///< of the pictures; absent: none are written
  std::filesystem::path video = {};    ///< empty: none
  FrameRange frames;
  double frames_per_second = 24.0;  ///< frame i shows time i / frames_per_second
  Existing existing = Existing::keep;

  int count() const { return frames.last - frames.first + 1; }
  double first_s() const { return frames.first / frames_per_second; }
};

/// How far a recording is.
struct RecordingProgress {
  bool has_begun = false;  ///< before that, its scene is being prepared
  int written = 0, count = 0;
  double left_s = 0.0;  ///< until its end, if the frames to come take as long as those before
};

/// Throws, before any work is done, for what may not or cannot be written.
void require_recording(const Recording& recording, const GivenInputs& inputs);

/// What is written, a line a kind: "out_0000.png ... out_0023.png", "out.webm".
std::string shown_outputs(const Recording& recording);

/// Error(cancelled) of a recording that was stopped after so many frames; the hint says how to go on.
Error stopped_recording(const Recording& recording, int written);

/// Writes the frames of a recording: a picture each, a video of all, or both.
class Recorder {
 public:
  explicit Recorder(const Recording& recording);

  /// The next frame, as it was drawn last at that time and exposure. Throws Error(file).
  void write(const Frame& drawn, double time_s, double exposure);
  /// The same of its highlights, for recordings without a video.
  void write(const HighlightLayer& layer, double time_s, double exposure);
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

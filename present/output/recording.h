#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/base/existing.h"
#include "host/base/frame_name.h"

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

/// What is written, a line a kind: "out_0000.png ... out_0023.png", "out.webm".
std::string shown_outputs(const Recording& recording);

/// Error(cancelled) of a recording that was stopped after so many frames; the hint says how to go on.
Error stopped_recording(const Recording& recording, int written);

}  // namespace offing::present

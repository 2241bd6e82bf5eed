#pragma once

#include "host/base/argument.h"
#include "host/base/error.h"
#include "host/base/frame_name.h"

namespace offing::present {

/// Frames to be written, one file each.
struct Recording {
  FrameName name;
  FrameRange frames;
  double frames_per_second = 24.0;  ///< frame i shows time i / frames_per_second

  int count() const { return frames.last - frames.first + 1; }
};

/// Error(cancelled) of a recording that was stopped after so many frames; the hint says how to go on.
Error stopped_recording(const Recording& recording, int written);

}  // namespace offing::present

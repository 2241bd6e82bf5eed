#include "present/recording.h"

#include <fmt/format.h>

namespace offing::present {

Error stopped_recording(const Recording& recording, int written) {
  const FrameRange& frames = recording.frames;
  return Error(ErrorKind::cancelled,
               fmt::format("{} ...: stopped with {} of {} frames written",
                           recording.name.of(frames.first).string(), written, recording.count()),
               fmt::format("--frames {}:{} makes the others", frames.first + written, frames.last));
}

}  // namespace offing::present

#include "present/output/recording.h"

#include <fmt/format.h>

namespace offing::present {

std::string shown_outputs(const Recording& recording) {
  std::string pictures;
  if (recording.name) {
    pictures = fmt::format("{} ... {}", recording.name->of(recording.frames.first).string(),
                           recording.name->of(recording.frames.last).string());
  }
  if (recording.video.empty()) return pictures;
  return pictures.empty() ? recording.video.string() : pictures + '\n' + recording.video.string();
}

Error stopped_recording(const Recording& recording, int written) {
  const FrameRange& frames = recording.frames;
  const std::string what = recording.name ? fmt::format("{} ...", recording.name->of(frames.first).string())
                                          : recording.video.string();
  return Error(ErrorKind::cancelled,
               fmt::format("{}: stopped with {} of {} frames written", what, written, recording.count()),
               recording.video.empty()
                   ? fmt::format("--frames {}:{} makes the others", frames.first + written, frames.last)
                   : fmt::format("the video is not made: start it again, of --frames {}:{}", frames.first,
                                 frames.last));
}

}  // namespace offing::present

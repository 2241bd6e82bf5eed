#include "present/output/recorder.h"

#include <fmt/format.h>

#include "host/command_line/new_output.h"
#include "present/output/image_file.h"

namespace offing::present {

void require_recording(const Recording& recording, const GivenInputs& inputs) {
  if (recording.name) require_new_frames(*recording.name, recording.frames, recording.existing, inputs);
  if (recording.video.empty()) return;
  require_video(recording.video);
  require_new(recording.video.string(), recording.existing, inputs);
}

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
                   : fmt::format("the video was not made: run the same command again, with --frames {}:{}",
                                 frames.first, frames.last));
}

Recorder::Recorder(const Recording& recording) : recording_(recording) {
  if (!recording.video.empty()) {
    video_.emplace(recording.video, recording.frames_per_second, recording.existing);
  }
}

void Recorder::write(const Frame& drawn, double time_s, double exposure) {
  const int frame = recording_.frames.first + count_;
  if (recording_.name) {
    write_image(recording_.name->of(frame), drawn, time_s, exposure, recording_.existing);
  }
  if (video_) video_->write(shown_image(drawn));
  ++count_;
}

void Recorder::write(const HighlightLayer& layer, double time_s, double exposure) {
  write_layer(recording_.name->of(recording_.frames.first + count_), layer, time_s, exposure,
              recording_.existing);
  ++count_;
}

void Recorder::finish() {
  if (video_) video_->finish();
}

}  // namespace offing::present

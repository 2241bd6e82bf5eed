#include "present/output/recorder.h"

#include "present/output/image_file.h"

namespace offing::present {

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

void Recorder::finish() {
  if (video_) video_->finish();
}

}  // namespace offing::present

#include "present/output/recording_job.h"

#include <utility>

#include "host/base/error.h"
#include "present/background_work.h"

namespace offing::present {

RecordingJob::RecordingJob(ViewOptions options, Record record) : options_(std::move(options)) {
  progress_.count = recording().count();
  const Error no_memory(ErrorKind::out_of_memory,
                        "recording: this machine's memory is too small for a second copy of the scene",
                        "save the scene, and record it by offing-view --record");
  ended_ = run_in_background("recording", no_memory, [this, record = std::move(record)] {
    record(options_, cancel_, [this](int written) { note(written); });
  });
}

void RecordingJob::note(int written) {
  const std::lock_guard lock(mutex_);
  if (!std::exchange(progress_.has_begun, true)) begun_ = std::chrono::steady_clock::now();
  progress_.written = written;
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun_;
  if (written > 0) progress_.left_s = taken.count() * (progress_.count - written) / written;
}

RecordingProgress RecordingJob::progress() const {
  const std::lock_guard lock(mutex_);
  return progress_;
}

bool RecordingJob::has_ended() const {
  return ended_.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
}

}  // namespace offing::present

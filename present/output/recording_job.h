#pragma once

#include <chrono>
#include <functional>
#include <future>
#include <mutex>

#include "host/base/work.h"
#include "present/output/headless.h"
#include "present/output/recorder.h"
#include "present/view_options.h"

namespace offing::present {

/// Records a scene while a window goes on: on a thread of its own, with a world, a queue of the device and
/// OpenGL of its own, as the command line would.
class RecordingJob {
 public:
  using Record =
      std::function<void(const ViewOptions&, const CancelToken&, const std::function<void(int written)>&)>;

  /// Of the options' recording, by a function like record_frames(). Throws Error(out_of_memory) where no
  /// thread can be started.
  explicit RecordingJob(ViewOptions options, Record record = record_frames);
  RecordingJob(const RecordingJob&) = delete;
  RecordingJob& operator=(const RecordingJob&) = delete;
  /// Stops it, and waits for the end of the frame in progress.
  ~RecordingJob() { cancel_.cancel(); }

  const Recording& recording() const { return *options_.recording; }
  RecordingProgress progress() const;
  /// It ends after the frame in progress.
  void cancel() { cancel_.cancel(); }
  bool has_ended() const;
  /// Waits for its end. Throws an Error where it ended early, Error(cancelled) after cancel(). Call it once.
  void take() { ended_.get(); }

 private:
  void note(int written);

  const ViewOptions options_;
  CancelToken cancel_;
  mutable std::mutex mutex_;
  RecordingProgress progress_;
  std::chrono::steady_clock::time_point begun_;
  std::future<void> ended_;  // last: it waits for the thread, which uses the others
};

}  // namespace offing::present

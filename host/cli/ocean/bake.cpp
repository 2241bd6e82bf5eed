#include "host/cli/ocean/bake.h"

#include <atomic>
#include <exception>
#include <mutex>
#include <optional>
#include <system_error>
#include <thread>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/cli/ocean/bounded_queue.h"
#include "host/cli/ocean/frame_maker.h"

namespace offing::cli {

namespace {

/// Frames that wait for a writer. One is enough to keep makers and writers busy; more would take memory.
constexpr std::size_t waiting_frames = 1;

class Bake {
 public:
  Bake(const scene::Sea& sea, const BakeSettings& settings, const FrameFiles& files, FrameWriter& writer,
       Progress& progress, const CancelToken& cancel, const std::vector<ocl::DeviceInfo>& devices,
       const scene::Scene& scene)
      : devices_(devices),
        sea_(sea),
        settings_(settings),
        files_(files),
        writer_(writer),
        progress_(progress),
        cancel_(cancel),
        scene_(scene),
        frames_(frames_in_share(settings.frames, settings.share)) {}

  BakeSummary run() {
    {
      // Each is waited for in the opposite order: the makers, then the writers, whose queue ends in between
      // on every way out.
      std::vector<std::jthread> writers;
      const ClosedAtEnd closing{queue_};
      for (std::size_t i = 0; i < writer_count(); ++i) {
        writers.push_back(start([this] { write_frames(); }));
      }
      std::vector<std::jthread> makers;
      for (const ocl::DeviceInfo& info : devices_) {
        makers.push_back(start([this, &info] { make_frames(info); }));
      }
    }
    if (fault_) {
      std::rethrow_exception(fault_);
    }
    const BakeSummary summary{written_, kept_};
    if (cancel_.cancelled() && std::cmp_less(summary.written + summary.kept, frames_.size())) {
      throw Error(ErrorKind::cancelled,
                  fmt::format("{}: interrupted with {} of {} frames done", settings_.folder.string(),
                              summary.written + summary.kept, frames_.size()),
                  "run the same command again to make the others");
    }
    return summary;
  }

 private:
  struct ClosedAtEnd {
    BoundedQueue<BakedFrame>& queue;
    ~ClosedAtEnd() { queue.close(); }
  };

  /// A thread for this work. Throws Error(out_of_memory), and stops those that run, if the system gives none.
  template <class Work>
  std::jthread start(Work work) {
    try {
      return std::jthread(std::move(work));
    } catch (const std::system_error& error) {
      failed_ = true;
      throw Error(
          ErrorKind::out_of_memory,
          fmt::format("{}: cannot start a thread: {}", settings_.folder.string(), error.code().message()),
          "raise the limits of processes and memory (ulimit -u, -v), or name one device with --device");
    }
  }

  void make_frames(const ocl::DeviceInfo& info) noexcept {
    try {
      std::optional<FrameMaker> maker;  // made when the first frame is due: a finished bake needs no device
      while (!cancel_.cancelled() && !failed_) {
        const std::size_t index = next_frame_.fetch_add(1);
        if (index >= frames_.size()) {
          return;
        }
        if (files_.is_done(frames_[index])) {
          ++kept_;
          progress_.skip();
          continue;
        }
        if (!maker) {
          std::call_once(has_room_, [this] { require_host_room(settings_, sea_, devices_); });
          maker.emplace(ocl::Device::open(info), sea_, settings_, scene_);
        }
        if (!queue_.push(maker->make(frames_[index]))) {
          return;
        }
      }
    } catch (...) {
      fail(std::current_exception());
    }
  }

  void write_frames() noexcept {
    try {
      while (std::optional<BakedFrame> frame = queue_.pop()) {
        writer_.write(std::move(*frame));
        ++written_;
        progress_.advance();
      }
    } catch (const Error& error) {
      if (error.kind() != ErrorKind::cancelled) fail(std::current_exception());  // run() tells of a stop
      queue_.close();
    } catch (...) {
      fail(std::current_exception());
      queue_.close();
    }
  }

  void fail(std::exception_ptr fault) {
    const std::lock_guard lock(fault_mutex_);
    if (!fault_) {
      fault_ = std::move(fault);
    }
    failed_ = true;
  }

  const std::vector<ocl::DeviceInfo>& devices_;
  const scene::Sea& sea_;
  const BakeSettings& settings_;
  const FrameFiles& files_;
  FrameWriter& writer_;
  Progress& progress_;
  const CancelToken& cancel_;
  const scene::Scene& scene_;
  const std::vector<int> frames_;
  BoundedQueue<BakedFrame> queue_{waiting_frames};
  std::atomic<std::size_t> next_frame_{0};
  std::atomic<int> written_{0};
  std::atomic<int> kept_{0};
  std::atomic<bool> failed_{false};
  std::once_flag has_room_;  // looked at when the first frame is due
  std::mutex fault_mutex_;
  std::exception_ptr fault_;
};

}  // namespace

BakeSummary bake(const std::vector<ocl::DeviceInfo>& devices, const scene::Sea& sea,
                 const BakeSettings& settings, const FrameFiles& files, FrameWriter& writer,
                 Progress& progress, const CancelToken& cancel, const scene::Scene& scene) {
  return Bake(sea, settings, files, writer, progress, cancel, devices, scene).run();
}

}  // namespace offing::cli

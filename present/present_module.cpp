// The module `present`: pictures of scenes for programs that do not link OpenGL.
#include <algorithm>
#include <condition_variable>
#include <exception>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/work.h"
#include "host/io/module.h"
#include "host/scene/prepare/scene_renderer.h"
#include "present/output/image_file.h"
#include "present/output/scene_images.h"

namespace offing::present {
namespace {

/// A thread that runs the tasks of other threads, one at a time: a context of OpenGL belongs to one thread.
class TaskThread {
 public:
  TaskThread() : thread_([this] { serve(); }) {}
  TaskThread(const TaskThread&) = delete;
  TaskThread& operator=(const TaskThread&) = delete;
  ~TaskThread() {
    {
      const std::lock_guard lock(mutex_);
      is_ending_ = true;
    }
    changed_.notify_all();
    thread_.join();
  }

  /// Waits for the task; throws what it threw. One caller at a time.
  void run(std::function<void()> task) {
    std::unique_lock lock(mutex_);
    task_ = std::move(task);
    failure_ = nullptr;
    changed_.notify_all();
    changed_.wait(lock, [this] { return !task_; });
    if (failure_) std::rethrow_exception(failure_);
  }

 private:
  void serve() {
    std::unique_lock lock(mutex_);
    for (;;) {
      changed_.wait(lock, [this] { return task_ || is_ending_; });
      if (!task_) return;
      lock.unlock();
      std::exception_ptr failure;
      try {
        task_();
      } catch (...) {
        failure = std::current_exception();
      }
      lock.lock();
      failure_ = failure;
      task_ = nullptr;
      changed_.notify_all();
    }
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::function<void()> task_;
  std::exception_ptr failure_;
  bool is_ending_ = false;
  std::thread thread_;
};

class Renderer : public scene::SceneRenderer {
 public:
  Renderer(const scene::Scene& scene, const ocl::DeviceInfo& device) {
    task_thread_.run(
        [&] { images_.emplace(scene, device, frame_settings(Detail::high, std::nullopt), cancel_); });
  }
  ~Renderer() override {
    task_thread_.run([this] { images_.reset(); });
  }

  void draw(const scene::PictureRequest& request) override {
    constexpr int longest_px = scene::longest_picture_px;
    if (std::min(request.width_px, request.height_px) < 1 ||
        std::max(request.width_px, request.height_px) > longest_px) {
      throw Error(ErrorKind::bad_usage,
                  fmt::format("picture: expected sides within [1, {}], got {} x {}", longest_px,
                              request.width_px, request.height_px),
                  "ask for a size such as 1280 x 720");
    }
    const std::size_t values =
        3 * static_cast<std::size_t>(request.width_px) * static_cast<std::size_t>(request.height_px);
    for (const std::size_t size : {request.rgb.size(), request.light.size()}) {
      if (size == 0 || size == values) continue;
      throw Error(ErrorKind::bad_usage,
                  fmt::format("picture: expected room for {} values, got {}", values, size),
                  "a picture has height x width x 3 values");
    }
    task_thread_.run([&] { draw_here(request); });
  }

 private:
  void draw_here(const scene::PictureRequest& request) {
    images_->draw(request.time_s, request.time_s, {request.width_px, request.height_px}, cancel_);
    if (!request.rgb.empty()) {
      const RgbImage shown = shown_image(images_->frame());
      std::copy(shown.rgb.begin(), shown.rgb.end(), request.rgb.begin());
    }
    if (request.light.empty()) return;
    const std::vector<float> light = images_->frame().light().read();
    const auto width = static_cast<std::size_t>(request.width_px),
               height = static_cast<std::size_t>(request.height_px);
    for (std::size_t row = 0; row < height; ++row) {
      for (std::size_t column = 0; column < width; ++column) {
        const float* const from =
            &light[4 * ((height - 1 - row) * width + column)];  // OpenGL's first row is at the bottom
        std::copy(from, from + 3, &request.light[3 * (row * width + column)]);
      }
    }
  }

  CancelToken cancel_;
  std::optional<SceneImages> images_;
  TaskThread task_thread_;
};

std::unique_ptr<scene::SceneRenderer> make_renderer(const scene::Scene& scene,
                                                    const ocl::DeviceInfo& device) {
  return std::make_unique<Renderer>(scene, device);
}

constexpr scene::PresentModule table{.make_renderer = make_renderer};

}  // namespace
}  // namespace offing::present

OFFING_MODULE(offing::present::table);

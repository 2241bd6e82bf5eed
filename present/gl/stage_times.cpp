#include "present/gl/stage_times.h"

#include <algorithm>
#include <numeric>
#include <utility>

#include "host/ocl/event.h"

namespace offing::present {
namespace {

double milliseconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

std::string_view to_string(Stage stage) {
  constexpr std::array<std::string_view, stage_count> names{
      "simulate", "terrain", "transfer", "sky", "water", "meshes", "clouds", "tone", "panels"};
  return names[static_cast<std::size_t>(stage)];
}

StageTimes::StageTimes() {
  for (auto& frame : queries_) {
    for (auto& stage : frame) {
      for (GlQuery& query : stage) query = GlQuery::make();
    }
  }
}

StageTimes::Scope::Scope(StageTimes& times, Stage stage)
    : times_(times), stage_(stage), start_(std::chrono::steady_clock::now()) {
  std::size_t& part = times_.asked_[times_.slot_][index(stage)];
  // Those who never end a frame ask no times of it.
  is_queried_ = part < most_parts;
  if (!is_queried_) return;
  glBeginQuery(GL_TIME_ELAPSED, times_.queries_[times_.slot_][index(stage)][part].name());
  ++part;
}

StageTimes::Scope::~Scope() {
  if (is_queried_) glEndQuery(GL_TIME_ELAPSED);
  if (times_.waits_) glFinish();
  times_.current_ms_[index(stage_)] += milliseconds_since(start_);
}

void StageTimes::append(History& history, double value) {
  std::rotate(history.begin(), history.begin() + 1, history.end());
  history.back() = static_cast<float>(value);
}

double StageTimes::mean_of(const History& history) {
  constexpr std::size_t frames = 30;
  return std::accumulate(history.end() - frames, history.end(), 0.0) / frames;
}

void StageTimes::end_frame() {
  append(frame_ms_, milliseconds_since(frame_start_));
  frame_start_ = std::chrono::steady_clock::now();
  slot_ = (slot_ + 1) % latency;
  for (std::size_t i = 0; i < stage_count; ++i) {
    append(cpu_ms_[i], current_ms_[i]);
    current_ms_[i] = 0.0;
    double measured_ms = added_ms_[i];
    const std::size_t parts = std::exchange(asked_[slot_][i], 0);
    for (std::size_t part = 0; part < parts; ++part) {
      // The oldest frame's: done by now.
      GLuint64 nanoseconds = 0;
      glGetQueryObjectui64v(queries_[slot_][i][part].name(), GL_QUERY_RESULT, &nanoseconds);
      measured_ms += 1e-6 * static_cast<double>(nanoseconds);
    }
    append(device_ms_[i], measured_ms);
    added_ms_[i] = 0.0;
  }
}

double StageTimes::frames_per_second() const {
  const double mean_ms = mean_of(frame_ms_);
  return mean_ms > 0.0 ? 1000.0 / mean_ms : 0.0;
}

void run_stage(StageTimes& times, Stage stage, const ocl::Device& device, const std::function<void()>& work) {
  const StageTimes::Scope scope(times, stage);
  const ocl::Event start = device.mark();
  work();
  const ocl::Event end = device.mark();
  device.finish();
  if (device.is_profiling()) times.add_device_ms(stage, 1e3 * (end.end_s() - start.end_s()));
}

}  // namespace offing::present

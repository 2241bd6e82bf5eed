#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <functional>
#include <string_view>

#include "host/ocl/device.h"
#include "present/gl/gl_objects.h"

namespace offing::present {

/// Parts of a frame whose time is shown.
enum class Stage { simulate, terrain, transfer, sky, water, meshes, clouds, tone, panels };
inline constexpr std::size_t stage_count = 9;
std::string_view to_string(Stage stage);

/// Who measures a stage: the CPU's clock, or that of the device that works: OpenCL's events, OpenGL's
/// queries.
enum class TimeSource { cpu, device };

/// Milliseconds of each stage, over the last frames.
class StageTimes {
 public:
  static constexpr std::size_t history_length = 120;

  StageTimes();

  /// Measures one stage from here to its end, or a part of it: up to three in a frame add up. Stages do not
  /// nest. Both clocks run: the CPU's and OpenGL's timer queries.
  class Scope {
   public:
    Scope(StageTimes& times, Stage stage);
    Scope(const Scope&) = delete;
    Scope& operator=(const Scope&) = delete;
    ~Scope();

   private:
    StageTimes& times_;
    Stage stage_;
    std::chrono::steady_clock::time_point start_;
    bool is_queried_ = false;
  };

  /// Ends a frame: its times enter the history. Queries are read a few frames later, so that nobody waits.
  void end_frame();

  /// Time that a device measured itself: OpenCL's events.
  void add_device_ms(Stage stage, double milliseconds) { added_ms_[index(stage)] += milliseconds; }

  /// From now on a stage lasts until OpenGL has done what it was asked for there: exact on the CPU's clock,
  /// for measurements, where drivers that draw on the CPU put work off.
  void wait_for_stages() { waits_ = true; }

  /// Milliseconds of a stage, the oldest frame first.
  const std::array<float, history_length>& history_ms(Stage stage, TimeSource source) const {
    return (source == TimeSource::cpu ? cpu_ms_ : device_ms_)[index(stage)];
  }
  /// Mean of the last 30 frames.
  double mean_ms(Stage stage, TimeSource source) const { return mean_of(history_ms(stage, source)); }
  double frames_per_second() const;

 private:
  using History = std::array<float, history_length>;
  static constexpr std::size_t latency = 4, most_parts = 3;

  static std::size_t index(Stage stage) { return static_cast<std::size_t>(stage); }
  static double mean_of(const History& history);
  static void append(History& history, double value);

  std::array<History, stage_count> cpu_ms_{}, device_ms_{};
  History frame_ms_{};
  std::array<double, stage_count> current_ms_{}, added_ms_{};
  std::array<std::array<std::array<GlQuery, most_parts>, stage_count>, latency> queries_;
  std::array<std::array<std::size_t, stage_count>, latency> asked_{};  // parts that were measured
  std::size_t slot_ = 0;
  bool waits_ = false;
  std::chrono::steady_clock::time_point frame_start_ = std::chrono::steady_clock::now();
};

/// Measures a stage that OpenCL does, or a part of it, until it is done; by the device's clock too where the
/// device keeps one.
void run_stage(StageTimes& times, Stage stage, const ocl::Device& device, const std::function<void()>& work);

}  // namespace offing::present

#pragma once

#include <array>
#include <chrono>
#include <cstddef>
#include <string_view>

#include "present/gl_objects.h"

namespace offing::present {

/// Parts of a frame whose time is shown.
enum class Stage { simulate, transfer, sky, water, tone, panels };
inline constexpr std::size_t stage_count = 6;
std::string_view to_string(Stage stage);

/// Milliseconds of each stage, over the last frames.
class StageTimes {
 public:
  static constexpr std::size_t history_length = 120;

  StageTimes();

  /// Measures one stage from here to its end; stages do not nest. On a GPU its own clock (timer queries)
  /// counts, else the CPU's.
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
  };

  /// Ends a frame: its times enter the history. Queries are read a few frames later, so that nobody waits.
  void end_frame();

  /// Milliseconds of a stage, the oldest frame first; the CPU's time, and that of OpenGL.
  const std::array<float, history_length>& cpu_ms(Stage stage) const { return cpu_ms_[index(stage)]; }
  const std::array<float, history_length>& gl_ms(Stage stage) const { return gl_ms_[index(stage)]; }
  /// Mean of the last 30 frames.
  double mean_cpu_ms(Stage stage) const { return mean_of(cpu_ms(stage)); }
  double mean_gl_ms(Stage stage) const { return mean_of(gl_ms(stage)); }
  double frames_per_second() const;

 private:
  using History = std::array<float, history_length>;
  static constexpr std::size_t latency = 4;

  static std::size_t index(Stage stage) { return static_cast<std::size_t>(stage); }
  static double mean_of(const History& history);
  static void append(History& history, double value);

  std::array<History, stage_count> cpu_ms_{}, gl_ms_{};
  History frame_ms_{};
  std::array<double, stage_count> current_ms_{};
  std::array<std::array<GlQuery, stage_count>, latency> queries_;
  std::array<std::array<bool, stage_count>, latency> is_asked_{};
  std::size_t slot_ = 0;
  std::chrono::steady_clock::time_point frame_start_ = std::chrono::steady_clock::now();
};

}  // namespace offing::present

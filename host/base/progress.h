#pragma once

#include <chrono>
#include <mutex>
#include <string>

#include "host/base/log.h"

namespace offing {

/// Tells on stderr how far long work is: a bar on a terminal, a line every few seconds elsewhere, nothing
/// when quiet. Rate and time left follow from the steps counted here. Safe to use from several threads.
class Progress {
 public:
  /// `what` is the plural of one step, such as "frames".
  Progress(int total, std::string what, Verbosity verbosity);
  /// Ends the bar's line.
  ~Progress();
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  /// One more step is done.
  void advance();
  /// One step less to do: it was there already. Does not count for the rate.
  void skip();

 private:
  using Clock = std::chrono::steady_clock;
  enum class Style { none, bar, lines };

  void show();

  const std::string what_;
  const Style style_;
  const Clock::time_point start_ = Clock::now();
  std::mutex mutex_;
  Clock::time_point last_shown_;
  int total_;
  int done_ = 0;
  int skipped_ = 0;
  bool bar_is_open_ = false;
};

/// "48 s", "3 min 05 s", "2 h 10 min".
std::string duration_text(double seconds);

}  // namespace offing

#include "host/base/progress.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include <fmt/format.h>
#include <unistd.h>

namespace offing {

namespace {

constexpr auto bar_interval = std::chrono::milliseconds(100);
constexpr auto line_interval = std::chrono::seconds(5);
constexpr int bar_width = 30;

}  // namespace

Progress::Progress(int total, std::string what, Verbosity verbosity)
    : what_(std::move(what)),
      style_(verbosity == Verbosity::quiet ? Style::none
             : isatty(STDERR_FILENO)       ? Style::bar
                                           : Style::lines),
      last_shown_(start_),
      total_(total) {}

Progress::~Progress() {
  if (bar_is_open_) {
    std::fputc('\n', stderr);
  }
}

void Progress::advance() {
  const std::lock_guard lock(mutex_);
  ++done_;
  show();
}

void Progress::skip() {
  const std::lock_guard lock(mutex_);
  ++done_;
  ++skipped_;
  show();
}

void Progress::show() {
  const auto now = Clock::now();
  const bool last = done_ == total_;
  if (style_ == Style::none) {
    return;
  }
  if (style_ == Style::bar ? now - last_shown_ < bar_interval && !last
                           : now - last_shown_ < line_interval && !last) {
    return;
  }
  last_shown_ = now;
  // Below, std::fputs() and not fmt::print(), which throws where stderr is full: no reason to stop the work.
  const double elapsed_s = std::chrono::duration<double>(now - start_).count();
  const int worked = done_ - skipped_;
  std::string text = fmt::format("{}/{} {}", done_, total_, what_);
  if (worked > 0 && elapsed_s > 0.0) {
    const double rate_hz = worked / elapsed_s;
    text += rate_hz >= 1.0 ? fmt::format(", {:.1f} per second", rate_hz)
                           : fmt::format(", {:.1f} s each", 1.0 / rate_hz);
    text += last ? fmt::format(", took {}", duration_text(elapsed_s))
                 : fmt::format(", {} left", duration_text((total_ - done_) / rate_hz));
  }
  if (style_ == Style::lines) {
    std::fputs((text + '\n').c_str(), stderr);
    return;
  }
  const int filled = total_ > 0 ? bar_width * done_ / total_ : bar_width;
  const std::string bar = fmt::format("\r[{}{}] {}\x1b[K", std::string(static_cast<std::size_t>(filled), '='),
                                      std::string(static_cast<std::size_t>(bar_width - filled), ' '), text);
  std::fputs(bar.c_str(), stderr);
  std::fflush(stderr);
  bar_is_open_ = true;
}

std::string duration_text(double seconds) {
  const long long whole = std::llround(std::max(seconds, 0.0));
  if (whole < 60) {
    return fmt::format("{} s", whole);
  }
  if (whole < 3600) {
    return fmt::format("{} min {:02} s", whole / 60, whole % 60);
  }
  return fmt::format("{} h {:02} min", whole / 3600, whole / 60 % 60);
}

}  // namespace offing

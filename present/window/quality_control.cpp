#include "present/window/quality_control.h"

#include <algorithm>

namespace offing::present {
namespace {

constexpr double least_stay_s = 2.0;
// Frames that are looked at together, whose median counts: one that stood still does not.
constexpr double window_s = 2.0;
constexpr std::size_t least_frames = 3;
// A quality level that was too slow is tried again after so long; each time that it is again, after four
// times as long.
constexpr double least_memory_s = 6.0, longest_memory_s = 60.0;

/// Relative to that of quality level 0, of a frame all of whose stages follow their shares half of the way:
/// what does not, simulation and meshes, is the other half.
double typical_cost(const Quality& quality) {
  const double pixels = quality.side_share * quality.side_share;
  return 0.25 + 0.05 / (1 << quality.cloud_halvings) + 0.3 * pixels + 0.2 * pixels * quality.ray_share +
         0.1 * quality.grid_share * quality.grid_share + 0.1 * quality.views_share * quality.views_share;
}

}  // namespace

double QualityControl::expected_ms(std::size_t level, double usual_ms, double now_s) const {
  const double by_cost_ms = usual_ms * typical_cost(quality_levels.at(level)) / typical_cost(quality());
  const std::optional<Memory>& known = memory_.at(level);
  return known && now_s - known->at_s < known->kept_s ? std::max(known->frame_ms, by_cost_ms) : by_cost_ms;
}

void QualityControl::go_to(std::size_t level, double usual_ms, double now_s) {
  const std::optional<Memory>& before = memory_.at(level_);
  const double kept_s = before ? std::min(4.0 * before->kept_s, longest_memory_s) : least_memory_s;
  memory_.at(level_) = Memory{usual_ms, now_s, level > level_ ? kept_s : least_memory_s};
  level_ = level;
  since_s_.reset();
}

void QualityControl::note(double frame_ms, double wanted_ms, double now_s) {
  if (!since_s_) {
    // The first frame of a quality level makes what is as large as its pictures, and is not like those that
    // follow.
    since_s_ = window_s_ = now_s;
    frames_ms_.clear();
    return;
  }
  frames_ms_.push_back(frame_ms);
  if (now_s - window_s_ < window_s || frames_ms_.size() < least_frames) return;
  const auto middle = frames_ms_.begin() + static_cast<std::ptrdiff_t>(frames_ms_.size() / 2);
  std::nth_element(frames_ms_.begin(), middle, frames_ms_.end());
  const double usual_ms = *middle;
  if (now_s - *since_s_ >= least_stay_s) {
    std::size_t wanted = level_;
    if (usual_ms > wanted_ms) {
      while (wanted + 1 < quality_levels.size() &&
             usual_ms * typical_cost(quality_levels.at(wanted)) / typical_cost(quality()) > wanted_ms)
        ++wanted;
    } else {
      while (wanted > 0 && expected_ms(wanted - 1, usual_ms, now_s) < wanted_ms) --wanted;
    }
    if (wanted != level_) {
      go_to(wanted, usual_ms, now_s);
      return;
    }
  }
  window_s_ = now_s;
  frames_ms_.clear();
}

}  // namespace offing::present

#include "present/scale_ladder.h"

#include <cmath>

namespace offing::present {
namespace {

// Frames that are averaged before anything changes: one that stood still does not count much.
constexpr int frames_a_choice = 8;
// A finer rung is tried only if it leaves this much of the time free, so that rungs do not take turns.
constexpr double safety = 0.85;

}  // namespace

double ScaleLadder::side_scale(std::size_t rung) {
  return std::sqrt(ray_shares.at(rung));
}

void ScaleLadder::note(double frame_ms, double rays_ms, double wanted_ms) {
  frame_ms_ += frame_ms;
  rays_ms_ += rays_ms;
  if (++frames_ < frames_a_choice) return;
  const double mean_ms = frame_ms_ / frames_, mean_rays_ms = rays_ms_ / frames_;
  frames_ = 0;
  frame_ms_ = rays_ms_ = 0.0;
  if (mean_ms > wanted_ms) {
    if (rung_ + 1 < ray_shares.size()) ++rung_;
  } else if (rung_ > 0) {
    const double more = ray_shares[rung_ - 1] / ray_shares[rung_] - 1.0;
    if (mean_ms + more * mean_rays_ms < safety * wanted_ms) --rung_;
  }
}

}  // namespace offing::present

#pragma once

#include <array>
#include <cstddef>

namespace offing::present {

/// Shares of the picture's pixels for which rays are cast at the ground, the rungs of a ladder.
inline constexpr std::array<double, 4> ray_shares{1.0, 0.75, 0.5, 0.25};

/// Chooses the rung whose frames take a time that is asked for, from those that were drawn: coarser after a
/// few frames that took too long, finer where the finer rung's rays can be expected to fit.
class ScaleLadder {
 public:
  /// Takes the times of a frame drawn on the current rung, all of it and its rays alone.
  void note(double frame_ms, double rays_ms, double wanted_ms);

  std::size_t rung() const { return rung_; }
  /// Rays a pixel along a side, of a rung.
  static double side_scale(std::size_t rung);

 private:
  std::size_t rung_ = 0;
  int frames_ = 0;                         // since the last change
  double frame_ms_ = 0.0, rays_ms_ = 0.0;  // their sums
};

}  // namespace offing::present

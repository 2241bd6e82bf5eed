#pragma once

#include <vector>

namespace offing {

/// A value at one time.
struct Keyframe {
  double time_s = 0.0;
  double value = 0.0;

  bool operator==(const Keyframe&) const = default;
};

/// How a value goes from one key to the next.
enum class Interpolation {
  /// By cubics that share their slopes at the keys and never turn between them, so that no value lies beyond
  /// those of the two keys. Slopes are those of Fritsch & Butland 1984, "A method for constructing local
  /// monotone piecewise cubic interpolants"; at both ends that of a parabola, as far as the cubic keeps its
  /// direction (Moler 2004, Numerical computing with Matlab, section 3.4). Keys on a line give that line.
  smooth,
  linear,
};

/// A value that changes with time: before the first key that key's, after the last key that one's.
struct KeyframeTrack {
  std::vector<Keyframe> keys = {};  ///< at least one; times increase
  Interpolation interpolation = Interpolation::smooth;
  /// Of an angle, a whole turn in its unit: it goes the shorter way from key to key, half a turn as its
  /// numbers go. 0 for other values.
  double period = 0.0;

  bool operator==(const KeyframeTrack&) const = default;
};

/// The value at a time, from the keys around it alone. Of an angle it may lie beyond those of the keys by
/// whole turns. Throws Error(bad_input) for a track without keys.
double value_at(const KeyframeTrack& track, double time_s);

}  // namespace offing

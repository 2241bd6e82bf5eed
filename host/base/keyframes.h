#pragma once

#include <vector>

namespace offing {

/// A value at one time.
struct Keyframe {
  double time_s = 0.0;
  double value = 0.0;
};

/// How a value goes from one key to the next.
enum class Interpolation {
  /// By cubics that share their slopes at the keys and never turn between them, so that no value lies beyond
  /// those of the two keys: slopes as Fritsch & Butland 1984 have them, at both ends those of a parabola as
  /// far
  /// as it does not turn (Moler 2004, section 3.4). Keys on a straight line give that line.
  smooth,
  linear,
};

/// A value that changes with time. Before the first key it has that key's value, after the last one that
/// one's.
struct KeyframeTrack {
  std::vector<Keyframe> keys = {};  ///< at least one; times increase
  Interpolation interpolation = Interpolation::smooth;
  /// Of an angle, a whole turn in its unit: it goes the shorter way from key to key, half a turn as its
  /// numbers go. 0 for other values.
  double period = 0.0;
};

/// The value at a time, from the keys around it alone. Of an angle it may lie beyond those of the keys by
/// whole turns. Throws Error(bad_input) for a track without keys.
double value_at(const KeyframeTrack& track, double time_s);

}  // namespace offing

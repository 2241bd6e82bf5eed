#include "host/base/keyframes.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>

#include "host/base/error.h"

namespace offing {
namespace {

/// The value closest to `value`, whole periods away, seen from `from`; itself within half a period.
double nearest_turn(double value, double from, double period) {
  const double step = value - from;
  return std::abs(step) <= 0.5 * period ? value : from + std::remainder(step, period);
}

/// From one key to the next: how long it takes and how fast the value grows.
struct Piece {
  double length_s;
  double slope;
};

/// Slope at a key between two pieces: a weighted harmonic mean, 0 where the value turns.
double inner_slope(const Piece& before, const Piece& after) {
  if (before.slope * after.slope <= 0.0) return 0.0;
  const double weight_before = 2.0 * after.length_s + before.length_s;
  const double weight_after = after.length_s + 2.0 * before.length_s;
  return (weight_before + weight_after) / (weight_before / before.slope + weight_after / after.slope);
}

/// Slope at the first or last key, beyond which there is nothing: `next` is the piece after the outer one.
double end_slope(const Piece& outer, const std::optional<Piece>& next) {
  if (!next) return outer.slope;
  const double parabola =
      ((2.0 * outer.length_s + next->length_s) * outer.slope - outer.length_s * next->slope) /
      (outer.length_s + next->length_s);
  if (parabola * outer.slope <= 0.0) return 0.0;
  // Where the next piece turns back, up to three times the secant is monotone (Fritsch & Carlson 1980,
  // "Monotone piecewise cubic interpolation").
  const bool turns = outer.slope * next->slope < 0.0;
  return turns && std::abs(parabola) > 3.0 * std::abs(outer.slope) ? 3.0 * outer.slope : parabola;
}

}  // namespace

double value_at(const KeyframeTrack& track, double time_s) {
  const std::vector<Keyframe>& keys = track.keys;
  if (keys.empty()) {
    throw Error(ErrorKind::bad_input, "keyframes: expected at least one key, found none", "add a key");
  }
  // Also where the time is no number.
  if (!(time_s > keys.front().time_s)) return keys.front().value;
  if (time_s >= keys.back().time_s) return keys.back().value;
  const auto after = std::upper_bound(keys.begin(), keys.end(), time_s,
                                      [](double time, const Keyframe& key) { return time < key.time_s; });
  const auto last = static_cast<std::size_t>(after - keys.begin());
  const Keyframe& from = keys[last - 1];
  const auto grows = [&](const Keyframe& first, const Keyframe& second) {
    const double end =
        track.period > 0.0 ? nearest_turn(second.value, first.value, track.period) : second.value;
    const double length_s = second.time_s - first.time_s;
    return Piece{length_s, (end - first.value) / length_s};
  };
  const Piece piece = grows(from, keys[last]);
  const double part = (time_s - from.time_s) / piece.length_s;
  if (track.interpolation == Interpolation::linear) {
    return from.value + part * piece.length_s * piece.slope;
  }
  std::optional<Piece> before, next;
  if (last >= 2) before = grows(keys[last - 2], from);
  if (last + 1 < keys.size()) next = grows(keys[last], keys[last + 1]);
  const double first_slope = before ? inner_slope(*before, piece) : end_slope(piece, next);
  const double last_slope = next ? inner_slope(piece, *next) : end_slope(piece, before);
  // Hermite's cubic, as the straight line and what the slopes bend it by.
  const double rest = 1.0 - part;
  const double bend = rest * (first_slope - piece.slope) - part * (last_slope - piece.slope);
  return from.value + piece.length_s * part * (piece.slope + rest * bend);
}

}  // namespace offing

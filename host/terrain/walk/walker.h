#pragma once

#include <cstdint>
#include <numbers>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/terrain/field/terrain_posts.h"

namespace offing::terrain {

/// How tall a walker is, and what ground holds him.
struct WalkerParameters {
  double eye_height_m = 1.7;                                 ///< above the feet, 0 ... 1000
  double slope_limit_rad = 45.0 / 180.0 * std::numbers::pi;  ///< steepest ground that holds, 0.01 ... 1.5
  double gravity_mps2 = 9.80665;                             ///< 0.01 ... 1000
};

/// Throws Error(bad_input) that names what is out of range.
void require_valid(const WalkerParameters& parameters);

/// Where a walker is: metres east and south of the map's first post, y up.
struct WalkerState {
  glm::dvec3 eye_m{0.0};
  glm::dvec3 velocity_mps{0.0};
  bool is_falling = false;  ///< through the air, or down ground that is too steep to hold
};

/// A point on foot, on the surface that rays hit: between posts the ground is bilinear.
///
/// Where the ground is no steeper than the limit the feet are on it, at any speed, and go as wanted, in plan.
/// Ground that is steeper is not climbed: what is wanted against it is taken away, so that one slides along
/// its foot, or stops. Who steps down onto it falls: with the velocity that he has, through the air, and
/// where he touches, down the ground against a friction of tan(limit), on which what is wanted has no
/// influence. A fall ends on ground that holds, or where for half a second it leads no lower, as between two
/// steep sides. The feet are never below the ground, nor beyond the map's edge, which stops like a wall.
///
/// Time goes in steps of 1/120 s, each of them in parts of at most a quarter of a cell, so that the same
/// wanted velocities give the same way however the time is divided into frames. All is in double precision.
class Walker {
 public:
  static constexpr double step_s = 1.0 / 120.0;

  /// Stands in the middle of the map. Throws what require_valid() throws, and everywhere what asking for
  /// posts throws.
  explicit Walker(TerrainPosts posts, const WalkerParameters& parameters = {});

  /// At rest on the ground under (x_m, z_m), at a time. Throws Error(bad_input) beyond the map's edge.
  void reset(double x_m, double z_m, double time_s = 0.0);

  /// Wants a velocity in plan (east, south) from now until time_s. A time before now changes nothing. Throws
  /// Error(bad_input) for numbers that are not finite, and beyond 1000 m/s.
  void advance_to(double time_s, glm::dvec2 wanted_mps);

  /// At the time of the last advance_to().
  const WalkerState& state() const { return shown_; }
  double time_s() const { return time_s_; }
  const WalkerParameters& parameters() const { return parameters_; }

 private:
  struct Feet {
    glm::dvec3 place_m{0.0}, velocity_mps{0.0};
    bool is_falling = false;
    double lowest_m = 0.0, held_s = 0.0;  ///< of a fall: where it was lowest, and since when
  };

  glm::dvec2 within_map(glm::dvec2 place_m) const;
  bool holds(const glm::dvec3& normal) const;
  void walk(Feet& feet, double duration_s, glm::dvec2 wanted_mps) const;
  void fall(Feet& feet, double duration_s) const;
  void begin_fall(Feet& feet) const;
  void step(Feet& feet, double duration_s, glm::dvec2 wanted_mps) const;
  void show(const Feet& feet);

  TerrainPosts posts_;
  WalkerParameters parameters_;
  double least_normal_y_, friction_;
  double start_s_ = 0.0, time_s_ = 0.0;
  std::int64_t steps_ = 0;  ///< done since start_s_
  Feet feet_;               ///< at the end of the last whole step
  WalkerState shown_;
};

}  // namespace offing::terrain

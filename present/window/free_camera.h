#pragma once

#include <functional>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/base/camera.h"

namespace offing::present {

/// What keys and mouse ask of a camera during one frame.
struct CameraInput {
  glm::dvec3 move{0.0};  ///< -1 ... 1 along the eye's right, the world's up and the eye's forward
  /// How far the mouse moved with its button down, right and down, in heights of the window.
  glm::dvec2 turn{0.0};
  double wheel = 0.0;  ///< notches away from the user: faster
  bool is_fast = false;
  bool is_slow = false;

  bool moves() const { return move != glm::dvec3(0.0) || turn != glm::dvec2(0.0); }
};

/// Height at a place of the water or the ground, whichever is higher, above the water's mean, m.
using SurfaceHeight = std::function<double(double x_m, double z_m)>;

/// What panels leave free of the picture, in clip coordinates.
struct FreeWidth {
  double left = -1.0, right = 1.0;
};

/// A camera that flies over water and ground, as far as a scene file lets eyes be. Where it stands still it
/// stays, though waves may reach it.
class FreeCamera {
 public:
  explicit FreeCamera(const Camera& start);

  /// Moves by what was asked for in so much time, not into water or ground. `surface_m` is asked only if it
  /// moves.
  void advance(const CameraInput& input, double seconds, const SurfaceHeight& surface_m);
  /// Turns by what was asked for, without moving.
  void look(const CameraInput& input);
  /// To where it sees a whole ball from the side that it was on, in the middle of what is free, not through
  /// water or ground. A ball that lies on the surface it sees from above.
  void look_at(const glm::dvec3& middle_m, double radius_m, const SurfaceHeight& surface_m,
               const FreeWidth& free = {});
  /// Up out of a surface of this height, if it is in it.
  void rise_above(double surface_m);
  /// It stays above this, whatever the waves do.
  void set_water_level(double height_m) { water_level_m_ = height_m; }
  /// Back to where it began.
  void reset();
  /// To where another camera is, with the picture's size as it is.
  void place(const Camera& other);

  Camera& camera() { return camera_; }
  const Camera& camera() const { return camera_; }
  double speed_mps() const { return speed_mps_; }

 private:
  Camera start_, camera_;
  double speed_mps_, water_level_m_ = 0.0;
};

}  // namespace offing::present

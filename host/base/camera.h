#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

namespace offing {

/// Where an eye is and what it sees. World axes are those of the sea: y up, right-handed, metres. Yaw 0 looks
/// along -z and grows toward +x, pitch grows upward, roll turns the head clockwise.
///
/// Everything but the eye itself is relative to the eye, so that nothing loses digits far from the origin.
struct Camera {
  glm::dvec3 eye_m{0.0, 2.0, 0.0};
  double yaw_rad = 0.0;
  double pitch_rad = 0.0;  ///< -pi/2 ... pi/2
  double roll_rad = 0.0;
  double vertical_field_of_view_rad = 1.0;  ///< above 0, below pi
  int width_px = 1280, height_px = 720;

  bool operator==(const Camera&) const = default;
};

/// The camera that sees what a level plane at this height mirrors for another one: its eye mirrored in the
/// plane, its picture upside down, so that the clip coordinates (x, y) of a direction become (x, -y).
Camera mirrored(const Camera& camera, double plane_m);

/// The same camera with its height counted from this level.
Camera above_level(Camera camera, double level_m);

/// Unit vectors along the picture's right and up and along the line of sight.
struct CameraBasis {
  glm::dvec3 right, up, forward;
};

/// Throws Error(bad_input) that names the value if one is not finite or out of range.
void require_valid(const Camera& camera);

CameraBasis basis(const Camera& camera);

/// Half the width and height of the picture at distance 1.
glm::dvec2 half_extent(const Camera& camera);

/// Direction, not normalised, of the ray through a point of the picture in clip coordinates: (-1, -1) is its
/// lower left corner. Its component along the line of sight is 1.
glm::dvec3 ray_direction(const Camera& camera, glm::dvec2 clip);

/// Rotation of eye-relative world coordinates into those of the view: x right, y up, the view along -z.
glm::dmat4 view_rotation(const Camera& camera);

/// Projection with reversed depth and no far plane: clip z / w is 1 at near_m and goes to 0 at infinity.
/// Throws Error(bad_input) unless near_m is finite and positive.
glm::dmat4 projection(const Camera& camera, double near_m);

}  // namespace offing

#include "host/highlights/tracks/track_motion.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "host/highlights/search/nearest_face.h"

namespace offing::highlights {
namespace {

using std::numbers::pi;

/// A vector turned about a unit axis (Rodrigues).
glm::dvec3 turned(const glm::dvec3& v, const glm::dvec3& axis, double angle_rad) {
  const double cosine = std::cos(angle_rad), sine = std::sin(angle_rad);
  return cosine * v + sine * glm::cross(axis, v) + (1.0 - cosine) * glm::dot(axis, v) * axis;
}

/// 0 where the curvatures are alike, so that noise decides about their directions; 1 where they differ.
double certainty(const HighlightPoint& point) {
  const double sum = std::abs(point.k_max_per_m) + std::abs(point.k_min_per_m);
  return sum > 0.0 ? glm::smoothstep(0.05, 0.25, (point.k_max_per_m - point.k_min_per_m) / sum) : 0.0;
}

/// Tilts the axes until their normal is the point's, then turns them about it toward the direction of k_max,
/// by `limit_rad` in all.
void turn_toward(const HighlightPoint& point, double limit_rad, Projector& shown) {
  const glm::dvec3 axis = glm::cross(shown.normal, point.normal);
  const double sine = glm::length(axis);
  const double apart_rad = std::atan2(sine, glm::dot(shown.normal, point.normal));
  const double tilt_rad = std::min(apart_rad, limit_rad);
  glm::dvec3 right = shown.right;
  if (sine > 1e-12) {
    shown.normal = apart_rad <= limit_rad ? point.normal : turned(shown.normal, axis / sine, tilt_rad);
    right = turned(right, axis / sine, tilt_rad);
  }
  // A line has two ends: the nearer one is at most a quarter turn away.
  double twist_rad =
      std::atan2(glm::dot(shown.normal, glm::cross(right, point.e_max)), glm::dot(right, point.e_max));
  if (twist_rad > 0.5 * pi) twist_rad -= pi;
  if (twist_rad < -0.5 * pi) twist_rad += pi;
  const double rest_rad = limit_rad - tilt_rad;
  right = turned(right, shown.normal, std::clamp(certainty(point) * twist_rad, -rest_rad, rest_rad));
  // Rounding must not add up over hours.
  shown.right = glm::normalize(right - glm::dot(right, shown.normal) * shown.normal);
  shown.up = glm::cross(shown.normal, shown.right);
}

double scaled_toward(double from_m, double to_m, double limit) {
  return from_m * std::exp(std::clamp(std::log(to_m / from_m), -limit, limit));
}

}  // namespace

Projector first_projector(const HighlightSurface& surface, const HighlightPoint& point,
                          const HighlightSize& size) {
  Projector projector = projector_at(surface, point, size);
  const glm::dvec3& up = projector.up;
  if (up.y < 0.0 || (up.y == 0.0 && up.x < 0.0)) {
    projector.right = -projector.right;
    projector.up = -projector.up;
  }
  return projector;
}

void follow_point(const HighlightSurface& surface, const TrackOptions& options, HighlightTrack& track) {
  Projector& shown = track.projector;
  const HighlightPoint& point = track.point;
  const glm::dvec3 way_m = point.position_m - shown.centre_m;
  const TrackLimits& limits = options.limits;
  const double limit_m =
      std::max(limits.move_per_s * options.step_s, limits.move_per_rad * track.steady_turn_rad) *
      surface.diagonal_m();
  const double distance_m = glm::length(way_m);
  if (distance_m <= limit_m) {
    shown.centre_m = point.position_m;
    track.seed_face = point.face;
  } else {
    shown.centre_m += way_m * (limit_m / distance_m);
    track.seed_face = nearest_face(surface, track.seed_face, shown.centre_m);
  }
  turn_toward(point,
              std::max(limits.turn_radps * options.step_s, limits.turn_per_rad * track.steady_turn_rad),
              shown);
  const double limit = limits.scale_per_s * options.step_s;
  shown.width_m = scaled_toward(shown.width_m, width_along(surface, point, shown.right, options.size), limit);
  shown.height_m = scaled_toward(shown.height_m, width_along(surface, point, shown.up, options.size), limit);
}

}  // namespace offing::highlights

#include "host/ocean/surface/projected_grid.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>

#include "host/ocean/ocean_limits.h"

namespace offing::ocean {
namespace {

// The sea ends this share of a pixel below the horizon.
constexpr double horizon_gap_px = 0.25;
// A projector at this height, in reaches, sees the water behind the eye that waves may carry into view.
constexpr double least_height_reaches = 1.0;
// The farthest label behind the eye stays in front of the projector by this factor.
constexpr double behind_margin = 2.0;
// So does the label below it.
constexpr double least_pitch_rad = 0.02;

using Polygon = std::vector<glm::dvec3>;  // directions of rays, a convex polygon on the picture

// The part of a convex polygon on which dot(normal, ray) >= bound (Sutherland & Hodgman 1974).
Polygon clipped(const Polygon& polygon, glm::dvec3 normal, double bound) {
  Polygon inside;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 from = polygon[i], to = polygon[(i + 1) % polygon.size()];
    const double from_side = glm::dot(normal, from) - bound, to_side = glm::dot(normal, to) - bound;
    if (from_side >= 0.0) inside.push_back(from);
    if ((from_side < 0.0) != (to_side < 0.0)) {
      inside.push_back(from + (to - from) * (from_side / (from_side - to_side)));
    }
  }
  return inside;
}

// Corners of what the camera sees of the slab |y| <= reach, from above, relative to the eye: the convex hull
// of the picture's parts on both faces of the slab, and of the eye if it is within.
std::vector<glm::dvec2> visible_corners(const Camera& camera, const SurfaceReach& reach) {
  const double pixel = 2.0 * half_extent(camera).y / camera.height_px;
  const double least_slope = horizon_gap_px * pixel;
  Polygon picture;
  for (const glm::dvec2 corner :
       {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
    picture.push_back(ray_direction(camera, corner));
  }
  std::vector<glm::dvec2> corners;
  const auto add_face = [&](double drop_m) {
    const double side = drop_m < 0.0 ? 1.0 : -1.0;  // a face above the eye is met by rays that rise
    for (const glm::dvec3 ray : clipped(picture, {0.0, side, 0.0}, least_slope)) {
      corners.push_back(glm::dvec2(ray.x, ray.z) * (-drop_m / ray.y));
    }
  };
  const double eye_height_m = camera.eye_m.y;
  add_face(eye_height_m + reach.vertical_m);
  if (eye_height_m < reach.vertical_m) {
    add_face(eye_height_m - reach.vertical_m);
    corners.emplace_back(0.0, 0.0);
  } else if (!corners.empty()) {
    add_face(eye_height_m - reach.vertical_m);
  }
  return corners;
}

// With the labels that waves may carry to these corners: squares instead of circles, so that corners stay.
std::vector<glm::dvec2> widened(const std::vector<glm::dvec2>& corners, double reach_m) {
  std::vector<glm::dvec2> wide;
  for (const glm::dvec2 corner : corners) {
    for (const glm::dvec2 offset :
         {glm::dvec2(-1, -1), glm::dvec2(1, -1), glm::dvec2(1, 1), glm::dvec2(-1, 1)}) {
      wide.push_back(corner + reach_m * offset);
    }
  }
  return wide;
}

}  // namespace

std::optional<ProjectedGrid> ProjectedGrid::for_camera(const Camera& camera, const SurfaceReach& reach) {
  constexpr double largest = std::numeric_limits<double>::max();
  require_valid(camera);
  require_within("camera.eye_m.y", camera.eye_m.y, std::numeric_limits<double>::min(), largest);
  require_within("surface reach", reach.horizontal_m, 0.0, largest);
  require_within("surface reach", reach.vertical_m, 0.0, largest);
  const std::vector<glm::dvec2> corners = widened(visible_corners(camera, reach), reach.horizontal_m);
  if (corners.empty()) return std::nullopt;

  ProjectedGrid grid;
  grid.along_ = {std::sin(camera.yaw_rad), -std::cos(camera.yaw_rad)};
  grid.across_ = {-grid.along_.y, grid.along_.x};
  grid.height_m_ = std::max(camera.eye_m.y, least_height_reaches * (reach.horizontal_m + reach.vertical_m));
  double behind_m = 0.0;
  for (const glm::dvec2 corner : corners) behind_m = std::max(behind_m, -glm::dot(corner, grid.along_));
  const double pitch_rad =
      std::max({-camera.pitch_rad, std::atan2(behind_margin * behind_m, grid.height_m_), least_pitch_rad});
  grid.sine_ = std::sin(pitch_rad);
  grid.cosine_ = std::cos(pitch_rad);

  grid.lower_ = glm::dvec2(largest);
  grid.upper_ = glm::dvec2(-largest);
  for (const glm::dvec2 corner : corners) {
    const glm::dvec2 point = grid.image_of(corner).value();
    grid.lower_ = glm::min(grid.lower_, point);
    grid.upper_ = glm::max(grid.upper_, point);
  }
  return grid;
}

ProjectedGrid::Corner ProjectedGrid::homogeneous(glm::dvec2 place) const {
  const glm::dvec2 point = lower_ + (upper_ - lower_) * place;
  return {(across_ * point.x + along_ * (cosine_ + point.y * sine_)) * height_m_, sine_ - point.y * cosine_};
}

glm::dvec2 ProjectedGrid::label_m(glm::dvec2 place) const {
  const Corner point = homogeneous(place);
  return point.label_m / point.w;
}

std::array<ProjectedGrid::Corner, 4> ProjectedGrid::corners() const {
  return {homogeneous({0.0, 0.0}), homogeneous({1.0, 0.0}), homogeneous({0.0, 1.0}), homogeneous({1.0, 1.0})};
}

std::optional<glm::dvec2> ProjectedGrid::image_of(glm::dvec2 label_m) const {
  const double along_m = glm::dot(label_m, along_);
  const double distance_m = along_m * cosine_ + height_m_ * sine_;
  if (distance_m <= 0.0) return std::nullopt;
  return glm::dvec2(glm::dot(label_m, across_), along_m * sine_ - height_m_ * cosine_) / distance_m;
}

std::optional<glm::dvec2> ProjectedGrid::place_of(glm::dvec2 label_m) const {
  const std::optional<glm::dvec2> point = image_of(label_m);
  if (!point) return std::nullopt;
  return (*point - lower_) / (upper_ - lower_);
}

}  // namespace offing::ocean

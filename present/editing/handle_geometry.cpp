#include "present/editing/handle_geometry.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

#include "present/passes/camera_projection.h"

namespace offing::present {
namespace {

constexpr double least_slope = 0.05;  // sine of 3 degrees

}  // namespace

std::optional<glm::dvec2> pixel_of(const Screen& screen, const glm::dvec3& place_m) {
  const CameraBasis axes = basis(screen.camera);
  const glm::dvec2 extent = half_extent(screen.camera);
  const glm::dvec3 way_m = place_m - screen.camera.eye_m;
  const double depth_m = glm::dot(way_m, axes.forward);
  if (depth_m < near_m) return {};
  const glm::dvec2 clip =
      glm::dvec2(glm::dot(way_m, axes.right), glm::dot(way_m, axes.up)) / (depth_m * extent);
  return pixel_of_clip(screen, clip);
}

glm::dvec2 pixel_of_clip(const Screen& screen, glm::dvec2 clip) {
  return glm::dvec2(0.5 + 0.5 * clip.x, 0.5 - 0.5 * clip.y) * screen.size_px;
}

double pixel_m(const Screen& screen, const glm::dvec3& place_m) {
  const double depth_m = glm::dot(place_m - screen.camera.eye_m, basis(screen.camera).forward);
  return 2.0 * depth_m * half_extent(screen.camera).y / screen.size_px.y;
}

Ray ray_at(const Screen& screen, glm::dvec2 clip) {
  return {screen.camera.eye_m, glm::normalize(ray_direction(screen.camera, clip))};
}

std::optional<double> along_axis(const Ray& ray, const glm::dvec3& place_m, const glm::dvec3& axis) {
  // Of the point on either line the way between them is at right angles to both.
  const double cosine = glm::dot(ray.direction, axis), sine_squared = 1.0 - cosine * cosine;
  if (sine_squared < least_slope * least_slope) return {};
  const glm::dvec3 way_m = ray.origin_m - place_m;
  return (glm::dot(way_m, axis) - cosine * glm::dot(way_m, ray.direction)) / sine_squared;
}

std::optional<glm::dvec3> on_plane(const Ray& ray, const glm::dvec3& place_m, const glm::dvec3& normal) {
  const double slope = glm::dot(ray.direction, normal);
  if (std::abs(slope) < least_slope) return {};
  const double distance_m = glm::dot(place_m - ray.origin_m, normal) / slope;
  if (distance_m <= 0.0) return {};
  return ray.origin_m + distance_m * ray.direction;
}

std::optional<double> miss_of(const Ray& ray, const Sphere& sphere) {
  const glm::dvec3 way_m = sphere.centre_m - ray.origin_m;
  const double ahead_m = glm::dot(way_m, ray.direction);
  if (ahead_m <= 0.0) return {};
  return glm::length(way_m - ahead_m * ray.direction) / sphere.radius_m;
}

std::vector<glm::dvec3> outline_of(const Sphere& sphere, const glm::dvec3& eye_m, int count) {
  const glm::dvec3 way_m = eye_m - sphere.centre_m;
  const double distance_m = glm::length(way_m), sine = sphere.radius_m / distance_m;
  if (!(sine < 1.0)) return {};
  // Where lines from the eye touch: on a circle nearer than the middle, smaller than the largest one.
  const glm::dvec3 toward = way_m / distance_m;
  const glm::dvec3 middle_m = sphere.centre_m + sine * sphere.radius_m * toward;
  const double radius_m = sphere.radius_m * std::sqrt(1.0 - sine * sine);
  const glm::dvec3 other = std::abs(toward.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
  const glm::dvec3 right = glm::normalize(glm::cross(other, toward)), up = glm::cross(toward, right);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < count; ++i) {
    const double angle_rad = 2.0 * std::numbers::pi * i / count;
    points.push_back(middle_m + radius_m * (std::cos(angle_rad) * right + std::sin(angle_rad) * up));
  }
  return points;
}

double snapped(double value, double step) {
  return step > 0.0 ? step * std::round(value / step) : value;
}

}  // namespace offing::present

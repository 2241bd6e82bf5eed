#pragma once

#include <optional>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "host/base/camera.h"

namespace offing::present {

/// A screen with what is seen on it, in pixels of a usual monitor: on one with finer pixels it has fewer of
/// these, so that handles and hands are as large on all.
struct Screen {
  Camera camera;
  glm::dvec2 size_px{1.0};
};

struct Ray {
  glm::dvec3 origin_m{0.0};
  glm::dvec3 direction{0.0, 0.0, -1.0};  ///< unit
};

struct Sphere {
  glm::dvec3 centre_m{0.0};
  double radius_m = 0.0;
};

/// How near to a handle a hand must be to take hold of it.
inline constexpr double hand_px = 12.0;
/// A press that moves further is no click.
inline constexpr double click_px = 4.0;

/// The handle nearest to a pointer among places with members `handle` and `place_px`, the last of equals;
/// nothing where all are farther than hand_px.
template <class Place>
auto handle_near(const std::vector<Place>& places, glm::dvec2 pointer_px) {
  std::optional<decltype(Place::handle)> nearest;
  double least_px = hand_px;
  for (const Place& place : places) {
    const double distance_px = glm::distance(place.place_px, pointer_px);
    if (distance_px > least_px) continue;
    least_px = distance_px;
    nearest = place.handle;
  }
  return nearest;
}

/// Where a place of the world is on a screen, in pixels from its upper left corner; nothing behind the eye.
std::optional<glm::dvec2> pixel_of(const Screen& screen, const glm::dvec3& place_m);

/// Pixels of clip coordinates.
glm::dvec2 pixel_of_clip(const Screen& screen, glm::dvec2 clip);

/// What a pixel is wide at the depth of a place, m; negative behind the eye.
double pixel_m(const Screen& screen, const glm::dvec3& place_m);

/// Through a point of the screen, in clip coordinates.
Ray ray_at(const Screen& screen, glm::dvec2 clip);

/// How far along an axis (a unit vector) from a place the nearest point to a ray is, m. Nothing where the ray
/// goes along it, within 3 degrees.
std::optional<double> along_axis(const Ray& ray, const glm::dvec3& place_m, const glm::dvec3& axis);

/// Where a ray meets the plane through a place; nothing behind its origin, or where it goes along the plane,
/// within 3 degrees.
std::optional<glm::dvec3> on_plane(const Ray& ray, const glm::dvec3& place_m, const glm::dvec3& normal);

/// How far from its middle a ray passes a sphere, in radii: at most 1 is a hit. Nothing for a sphere behind
/// the ray's origin.
std::optional<double> miss_of(const Ray& ray, const Sphere& sphere);

/// Points of a sphere's outline as an eye sees it, in the world: a circle. Empty from within.
std::vector<glm::dvec3> outline_of(const Sphere& sphere, const glm::dvec3& eye_m, int count);

/// The nearest multiple of a step; the value itself for a step of 0.
double snapped(double value, double step);

}  // namespace offing::present

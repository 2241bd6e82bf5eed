#include "present/editing/cloud_handles.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace offing::present {
namespace {

constexpr double arrow_px = 80.0, square_px = 32.0;

glm::dvec3 unit(int axis) {
  glm::dvec3 result(0.0);
  result[axis] = 1.0;
  return result;
}

/// Where the ray of a handle is, relative to the middle of its sphere.
std::optional<glm::dvec3> place_of_hand(const Screen& screen, CloudHandle handle, const Sphere& sphere,
                                        glm::dvec2 clip) {
  const Ray ray = ray_at(screen, clip);
  const int number = static_cast<int>(handle);
  if (handle <= CloudHandle::z) {
    const std::optional<double> along_m = along_axis(ray, sphere.centre_m, unit(number));
    return along_m ? std::optional(*along_m * unit(number)) : std::nullopt;
  }
  const glm::dvec3 normal = handle <= CloudHandle::plane_z
                                ? unit(number - static_cast<int>(CloudHandle::plane_x))
                                : basis(screen.camera).forward;
  const std::optional<glm::dvec3> place_m = on_plane(ray, sphere.centre_m, normal);
  return place_m ? std::optional(*place_m - sphere.centre_m) : std::nullopt;
}

bool moves_along(CloudHandle handle, int axis) {
  if (handle <= CloudHandle::z) return static_cast<int>(handle) == axis;
  return handle == CloudHandle::free ||
         static_cast<int>(handle) - static_cast<int>(CloudHandle::plane_x) != axis;
}

}  // namespace

std::vector<CloudHandlePlace> cloud_handle_places(const Screen& screen, const Sphere& sphere) {
  std::vector<CloudHandlePlace> places;
  const auto add = [&](CloudHandle handle, const glm::dvec3& place_m) {
    if (const std::optional<glm::dvec2> place_px = pixel_of(screen, place_m))
      places.push_back({handle, place_m, *place_px});
  };
  const double unit_m = pixel_m(screen, sphere.centre_m);
  add(CloudHandle::free, sphere.centre_m);
  for (int axis = 0; axis < 3; ++axis) {
    const glm::dvec3 others = glm::dvec3(1.0) - unit(axis);
    add(static_cast<CloudHandle>(axis), sphere.centre_m + arrow_px * unit_m * unit(axis));
    add(static_cast<CloudHandle>(static_cast<int>(CloudHandle::plane_x) + axis),
        sphere.centre_m + square_px * unit_m * others);
  }
  // To the left, where no arrow of a camera that looks north is.
  if (sphere.radius_m > 0.0) {
    add(CloudHandle::radius, sphere.centre_m - sphere.radius_m * basis(screen.camera).right);
  }
  return places;
}

std::optional<CloudHandle> cloud_handle_at(const std::vector<CloudHandlePlace>& places,
                                           glm::dvec2 pointer_px) {
  return handle_near(places, pointer_px);
}

std::optional<CloudPull> cloud_pull(const Screen& screen, CloudHandle handle, const Sphere& sphere,
                                    glm::dvec2 from, glm::dvec2 to, double step_m) {
  const std::optional<glm::dvec3> from_m = place_of_hand(screen, handle, sphere, from);
  const std::optional<glm::dvec3> to_m = place_of_hand(screen, handle, sphere, to);
  if (!from_m || !to_m) return {};
  CloudPull pull;
  if (handle == CloudHandle::radius) {
    pull.ratio = std::max(glm::length(*to_m) / std::max(glm::length(*from_m), 1e-9), 1e-3);
    if (step_m > 0.0) {
      pull.ratio = std::max(snapped(pull.ratio * sphere.radius_m, step_m), step_m) / sphere.radius_m;
    }
    return pull;
  }
  pull.way_m = *to_m - *from_m;
  if (step_m <= 0.0) return pull;
  for (int axis = 0; axis < 3; ++axis) {
    if (!moves_along(handle, axis)) continue;
    const double middle_m = sphere.centre_m[axis];
    pull.way_m[axis] = snapped(middle_m + pull.way_m[axis], step_m) - middle_m;
  }
  return pull;
}

}  // namespace offing::present

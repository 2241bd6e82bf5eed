#include "present/editing/objects/object_handles.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace offing::present {
namespace {

// Rings are beyond the arrows, so that neither hides the other.
constexpr double arrow_px = 80.0, square_px = 32.0, ring_px = 104.0;
constexpr int ring_places = 48;  // closer to each other than a hand is wide

constexpr std::array all_handles{ObjectHandle::x,       ObjectHandle::y,       ObjectHandle::z,
                                 ObjectHandle::plane_x, ObjectHandle::plane_y, ObjectHandle::plane_z,
                                 ObjectHandle::free,    ObjectHandle::radius,  ObjectHandle::turn_x,
                                 ObjectHandle::turn_y,  ObjectHandle::turn_z};
constexpr std::array handles_afloat{ObjectHandle::x, ObjectHandle::z, ObjectHandle::plane_y,
                                    ObjectHandle::radius, ObjectHandle::turn_y};
constexpr std::array handles_of_square{ObjectHandle::x,       ObjectHandle::y,       ObjectHandle::z,
                                       ObjectHandle::plane_x, ObjectHandle::plane_y, ObjectHandle::plane_z,
                                       ObjectHandle::free,    ObjectHandle::side};
constexpr std::array handles_of_water_square{ObjectHandle::x, ObjectHandle::z, ObjectHandle::plane_y,
                                             ObjectHandle::side};
constexpr std::array handles_of_camera{ObjectHandle::x,       ObjectHandle::y,       ObjectHandle::z,
                                       ObjectHandle::plane_x, ObjectHandle::plane_y, ObjectHandle::plane_z,
                                       ObjectHandle::free,    ObjectHandle::turn_y};

glm::dvec3 unit(int axis) {
  glm::dvec3 result(0.0);
  result[axis] = 1.0;
  return result;
}

/// The axis of an arrow or a ring, the normal of a square.
int axis_of(ObjectHandle handle) {
  const int number = static_cast<int>(handle);
  if (handle >= ObjectHandle::turn_x) return number - static_cast<int>(ObjectHandle::turn_x);
  return handle >= ObjectHandle::plane_x ? number - static_cast<int>(ObjectHandle::plane_x) : number;
}

/// Where the ray of a handle is, relative to the middle of its sphere.
std::optional<glm::dvec3> place_of_hand(const Screen& screen, ObjectHandle handle, const Sphere& sphere,
                                        glm::dvec2 clip) {
  const Ray ray = ray_at(screen, clip);
  if (handle <= ObjectHandle::z) {
    const glm::dvec3 axis = unit(axis_of(handle));
    const std::optional<double> along_m = along_axis(ray, sphere.centre_m, axis);
    return along_m ? std::optional(*along_m * axis) : std::nullopt;
  }
  if (handle == ObjectHandle::side) {
    // Also far away, where it is close to the horizon.
    constexpr double flattest = 1e-3;
    const double rise = ray.direction.y, height_m = sphere.centre_m.y - ray.origin_m.y;
    if (std::abs(rise) < flattest || rise * height_m <= 0.0) return {};
    return ray.origin_m + height_m / rise * ray.direction - sphere.centre_m;
  }
  const bool goes_with_screen = handle == ObjectHandle::free || handle == ObjectHandle::radius;
  const glm::dvec3 normal = goes_with_screen ? basis(screen.camera).forward : unit(axis_of(handle));
  const std::optional<glm::dvec3> place_m = on_plane(ray, sphere.centre_m, normal);
  return place_m ? std::optional(*place_m - sphere.centre_m) : std::nullopt;
}

bool moves_along(ObjectHandle handle, int axis) {
  if (handle <= ObjectHandle::z) return axis_of(handle) == axis;
  return handle == ObjectHandle::free || axis_of(handle) != axis;
}

/// Where the eye looks over the side of a level square, relative to the middle: the far side, so that it is
/// in the picture also if the eye is within the square.
glm::dvec3 seen_side(const Screen& screen, const Sphere& square) {
  const CameraBasis axes = basis(screen.camera);
  glm::dvec2 ahead(axes.forward.x, axes.forward.z);
  if (glm::length(ahead) < 1e-6) ahead = {axes.up.x, axes.up.z};  // it looks straight up or down
  const glm::dvec3 eye_m = screen.camera.eye_m - square.centre_m;
  double enters = 0.0, leaves = std::numeric_limits<double>::infinity();
  for (const auto& [from_m, way] : {std::pair(eye_m.x, ahead.x), {eye_m.z, ahead.y}}) {
    const double to_low = (-square.radius_m - from_m) / way, to_high = (square.radius_m - from_m) / way;
    enters = std::max(enters, std::min(to_low, to_high));
    leaves = std::min(leaves, std::max(to_low, to_high));
  }
  if (leaves > enters) return {eye_m.x + leaves * ahead.x, 0.0, eye_m.z + leaves * ahead.y};
  const double longest = std::max(std::abs(ahead.x), std::abs(ahead.y));  // it looks past the square
  return square.radius_m / longest * glm::dvec3(ahead.x, 0.0, ahead.y);
}

/// How far from the middle a hand is: of a square as the half side of the one that it is on.
double reach_of(ObjectHandle handle, const glm::dvec3& way_m) {
  return handle == ObjectHandle::side ? std::max(std::abs(way_m.x), std::abs(way_m.z)) : glm::length(way_m);
}

/// Points of a ring about an axis.
glm::dvec3 on_ring(int axis, int number, double radius_m) {
  const double angle_rad = 2.0 * std::numbers::pi * number / ring_places;
  return radius_m * (std::cos(angle_rad) * unit((axis + 1) % 3) + std::sin(angle_rad) * unit((axis + 2) % 3));
}

}  // namespace

HandleSet sphere_handles() {
  return HandleSet(all_handles).first(8);
}
HandleSet place_handles() {
  return HandleSet(all_handles).first(7);
}
HandleSet mesh_handles() {
  return all_handles;
}
HandleSet floating_handles() {
  return handles_afloat;
}
HandleSet square_handles() {
  return handles_of_square;
}
HandleSet water_square_handles() {
  return handles_of_water_square;
}
HandleSet camera_handles() {
  return handles_of_camera;
}

std::vector<ObjectHandlePlace> object_handle_places(const Screen& screen, const Sphere& sphere,
                                                    HandleSet handles) {
  std::vector<ObjectHandlePlace> places;
  const auto add = [&](ObjectHandle handle, const glm::dvec3& way_m) {
    if (const std::optional<glm::dvec2> place_px = pixel_of(screen, sphere.centre_m + way_m))
      places.push_back({handle, sphere.centre_m + way_m, *place_px});
  };
  const double unit_m = pixel_m(screen, sphere.centre_m);
  // Of equals the last one is taken: rings go first.
  for (const ObjectHandle handle : handles) {
    for (int i = 0; handle >= ObjectHandle::turn_x && i < ring_places; ++i)
      add(handle, on_ring(axis_of(handle), i, ring_px * unit_m));
  }
  for (const ObjectHandle handle : handles) {
    const int axis = axis_of(handle);
    if (handle == ObjectHandle::free) {
      add(handle, glm::dvec3(0.0));
    } else if (handle == ObjectHandle::radius) {
      // To the left, where no arrow of a camera that looks north is.
      add(handle, -sphere.radius_m * basis(screen.camera).right);
    } else if (handle == ObjectHandle::side) {
      add(handle, seen_side(screen, sphere));
    } else if (handle <= ObjectHandle::z) {
      add(handle, arrow_px * unit_m * unit(axis));
    } else if (handle <= ObjectHandle::plane_z) {
      add(handle, square_px * unit_m * (glm::dvec3(1.0) - unit(axis)));
    }
  }
  return places;
}

std::string handle_help(ObjectHandle handle) {
  constexpr std::array<const char*, 3> axes{"x (east)", "y (up)", "z (south)"};
  constexpr std::array<const char*, 3> planes{"y and z", "x and z (level)", "x and y"};
  if (handle == ObjectHandle::free) return "drag: move in the plane of the picture\nCtrl: in steps";
  if (handle == ObjectHandle::radius || handle == ObjectHandle::side) return "drag: resize\nCtrl: in steps";
  const auto axis = static_cast<std::size_t>(axis_of(handle));
  if (handle >= ObjectHandle::turn_x)
    return fmt::format("drag: turn about {}\nCtrl: in steps of 15 degrees", axes.at(axis));
  if (handle >= ObjectHandle::plane_x)
    return fmt::format("drag: move along {}\nCtrl: in steps", planes.at(axis));
  return fmt::format("drag: move along {}\nCtrl: in steps", axes.at(axis));
}

std::optional<ObjectHandle> object_handle_at(const std::vector<ObjectHandlePlace>& places,
                                             glm::dvec2 pointer_px) {
  return handle_near(places, pointer_px);
}

std::optional<ObjectPull> object_pull(const Screen& screen, ObjectHandle handle, const Sphere& sphere,
                                      glm::dvec2 from, glm::dvec2 to, const HandleSteps& steps) {
  const std::optional<glm::dvec3> from_m = place_of_hand(screen, handle, sphere, from);
  const std::optional<glm::dvec3> to_m = place_of_hand(screen, handle, sphere, to);
  if (!from_m || !to_m) return {};
  ObjectPull pull;
  if (handle == ObjectHandle::radius || handle == ObjectHandle::side) {
    pull.ratio = std::max(reach_of(handle, *to_m) / std::max(reach_of(handle, *from_m), 1e-9), 1e-3);
    if (steps.way_m > 0.0) {
      pull.ratio =
          std::max(snapped(pull.ratio * sphere.radius_m, steps.way_m), steps.way_m) / sphere.radius_m;
    }
    return pull;
  }
  if (handle >= ObjectHandle::turn_x) {
    const int axis = axis_of(handle);
    const double across = glm::dot(unit(axis), glm::cross(*from_m, *to_m));
    pull.turn_rad[axis] = snapped(std::atan2(across, glm::dot(*from_m, *to_m)), steps.turn_rad);
    return pull;
  }
  pull.way_m = *to_m - *from_m;
  if (steps.way_m <= 0.0) return pull;
  for (int axis = 0; axis < 3; ++axis) {
    if (!moves_along(handle, axis)) continue;
    const double middle_m = sphere.centre_m[axis];
    pull.way_m[axis] = snapped(middle_m + pull.way_m[axis], steps.way_m) - middle_m;
  }
  return pull;
}

}  // namespace offing::present

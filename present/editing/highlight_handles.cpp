#include "present/editing/highlight_handles.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>

namespace offing::present {
namespace {

using highlights::HighlightControls;
using highlights::Projector;

constexpr double knob_px = 28.0;  // of the handle that turns, above the box
constexpr double least_scale = 1e-3, most_scale = 1e3;
// Anisotropy that makes a box twice as wide for its height is half of this.
constexpr double doubling = 0.5;  // log(2) / log(4): a width at anisotropy 1 is four times that at 0

/// Widens by one factor and leaves the other way: both by its root, and anisotropy does the rest.
void stretch(HighlightControls& controls, double factor, double sign) {
  controls.scale *= std::sqrt(factor);
  controls.anisotropy += sign * doubling * 0.5 * std::log2(factor);
}

}  // namespace

Projector in_world(const Projector& box, const highlights::RigidMotion& mesh) {
  Projector result = box;
  result.centre_m = mesh.rotation * box.centre_m + mesh.translation_m;
  result.right = mesh.rotation * box.right;
  result.up = mesh.rotation * box.up;
  result.normal = mesh.rotation * box.normal;
  return result;
}

std::vector<glm::dvec3> corners_of(const Projector& box) {
  std::vector<glm::dvec3> corners;
  for (const glm::dvec2 sign : {glm::dvec2(1.0, 1.0), {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}) {
    corners.push_back(box.centre_m + 0.5 * sign.x * box.width_m * box.right +
                      0.5 * sign.y * box.height_m * box.up);
  }
  return corners;
}

std::vector<HandlePlace> handle_places(const Screen& screen, const Projector& box) {
  std::vector<HandlePlace> places;
  const auto add = [&](Handle handle, const glm::dvec3& place_m) {
    if (const std::optional<glm::dvec2> place_px = pixel_of(screen, place_m))
      places.push_back({handle, *place_px});
  };
  const glm::dvec3 right_m = 0.5 * box.width_m * box.right, up_m = 0.5 * box.height_m * box.up;
  add(Handle::move, box.centre_m);
  add(Handle::scale, box.centre_m + right_m + up_m);
  add(Handle::width, box.centre_m + right_m);
  add(Handle::height, box.centre_m + up_m);
  add(Handle::rotate, box.centre_m + up_m + knob_px * pixel_m(screen, box.centre_m) * box.up);
  return places;
}

const char* handle_help(Handle handle) {
  switch (handle) {
    case Handle::move:
      return "drag: move over the mesh";
    case Handle::rotate:
      return "drag: turn";
    case Handle::scale:
      return "drag: resize";
    case Handle::width:
      return "drag: change the width";
    case Handle::height:
      return "drag: change the height";
  }
  return "";
}

std::optional<Handle> handle_at(const std::vector<HandlePlace>& places, glm::dvec2 pointer_px) {
  return handle_near(places, pointer_px);
}

std::optional<glm::dvec2> place_on_plane(const Screen& screen, const Projector& box, glm::dvec2 clip) {
  const Ray ray = ray_at(screen, clip);
  // Not from behind.
  if (glm::dot(ray.origin_m - box.centre_m, box.normal) <= 0.0) return {};
  const std::optional<glm::dvec3> place_m = on_plane(ray, box.centre_m, box.normal);
  if (!place_m) return {};
  const glm::dvec3 way_m = *place_m - box.centre_m;
  return glm::dvec2(glm::dot(way_m, box.right), glm::dot(way_m, box.up));
}

HighlightControls pulled(const HighlightControls& controls, Handle handle, glm::dvec2 from_m,
                         glm::dvec2 to_m) {
  HighlightControls result = controls;
  const auto ratio = [](double to, double from) {
    return std::max(std::abs(to) / std::max(std::abs(from), 1e-12), 1e-6);
  };
  switch (handle) {
    case Handle::move:
      break;
    case Handle::rotate: {
      const double way_rad = std::atan2(to_m.y, to_m.x) - std::atan2(from_m.y, from_m.x);
      result.rotation_rad += std::remainder(way_rad, 2.0 * std::numbers::pi);
      break;
    }
    case Handle::scale:
      result.scale *= ratio(glm::length(to_m), glm::length(from_m));
      break;
    case Handle::width:
      stretch(result, ratio(to_m.x, from_m.x), 1.0);
      break;
    case Handle::height:
      stretch(result, ratio(to_m.y, from_m.y), -1.0);
      break;
  }
  result.scale = std::clamp(result.scale, least_scale, most_scale);
  result.anisotropy = std::clamp(result.anisotropy, -1.0, 1.0);
  return result;
}

HighlightControls pushed(const HighlightControls& controls, const Projector& found, glm::dvec2 way_m) {
  HighlightControls result = controls;
  // Offsets count in the axes before the rotation.
  const double cosine = std::cos(controls.rotation_rad), sine = std::sin(controls.rotation_rad);
  const glm::dvec2 along(cosine * way_m.x - sine * way_m.y, sine * way_m.x + cosine * way_m.y);
  const glm::dvec2 step = along / (0.5 * glm::dvec2(found.width_m, found.height_m));
  result.offset = glm::clamp(result.offset + step, -highlights::most_offset, highlights::most_offset);
  return result;
}

}  // namespace offing::present

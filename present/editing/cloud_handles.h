#pragma once

#include <array>
#include <optional>
#include <vector>

#include "present/editing/handle_geometry.h"

namespace offing::present {

/// What a hand can take hold of on a picked part of a cloud: arrows along the axes, squares in the planes
/// between them (named by their normals), its middle, which goes with the screen, and its rim.
enum class CloudHandle { x, y, z, plane_x, plane_y, plane_z, free, radius };

struct CloudHandlePlace {
  CloudHandle handle;
  glm::dvec3 place_m;
  glm::dvec2 place_px;
};

/// The handles of a sphere; arrows are as long on every screen. Those behind the eye are left out, and of
/// particles, which have no radius, the rim.
std::vector<CloudHandlePlace> cloud_handle_places(const Screen& screen, const Sphere& sphere);

/// The nearest one within a hand's width.
std::optional<CloudHandle> cloud_handle_at(const std::vector<CloudHandlePlace>& places,
                                           glm::dvec2 pointer_px);

/// What a pull has come to.
struct CloudPull {
  glm::dvec3 way_m{0.0};
  double ratio = 1.0;  ///< of the radius
};

/// A hand took hold of a handle of a sphere at one point of the screen and is at another one now, in clip
/// coordinates. With a step, the middle goes to multiples of it along what it moves along, and the radius to
/// multiples too, at least one. Nothing where the ray through the point says nothing.
std::optional<CloudPull> cloud_pull(const Screen& screen, CloudHandle handle, const Sphere& sphere,
                                    glm::dvec2 from, glm::dvec2 to, double step_m);

}  // namespace offing::present

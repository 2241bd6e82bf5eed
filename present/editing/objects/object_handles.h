#pragma once

#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "present/editing/handle_geometry.h"

namespace offing::present {

/// What a hand can take hold of on a selected object: arrows along the world's axes, squares in the planes
/// between them (named by their normals), its middle, which goes with the screen, what resizes it (the rim of
/// a sphere or a side of a level square), and rings, which turn it about the axes.
enum class ObjectHandle { x, y, z, plane_x, plane_y, plane_z, free, radius, side, turn_x, turn_y, turn_z };

/// Which of them an object has.
using HandleSet = std::span<const ObjectHandle>;
/// Of what is moved and resized, such as a ball of a cloud; of what is only moved, such as particles; of what
/// is turned too, such as a mesh; of what stays upright on the water; of a level square, such as a layer of
/// clouds, and of one on the water; and of what stands somewhere and looks around, such as a camera.
HandleSet sphere_handles();
HandleSet place_handles();
HandleSet mesh_handles();
HandleSet floating_handles();
HandleSet square_handles();
HandleSet water_square_handles();
HandleSet camera_handles();

struct ObjectHandlePlace {
  ObjectHandle handle;
  glm::dvec3 place_m;
  glm::dvec2 place_px;
};

/// The handles of a sphere, or of a level square with sides of twice its radius; arrows and rings are as
/// large on every screen. Those behind the eye are left out. A ring has many places, in order around it.
std::vector<ObjectHandlePlace> object_handle_places(const Screen& screen, const Sphere& sphere,
                                                    HandleSet handles);

/// What a handle does, as help on it.
std::string handle_help(ObjectHandle handle);

/// The nearest one within a hand's width.
std::optional<ObjectHandle> object_handle_at(const std::vector<ObjectHandlePlace>& places,
                                             glm::dvec2 pointer_px);

/// What a pull has come to.
struct ObjectPull {
  glm::dvec3 way_m{0.0};
  double ratio = 1.0;        ///< of the radius
  glm::dvec3 turn_rad{0.0};  ///< about one of the world's axes, anticlockwise seen from its end
};

/// What handles snap to; 0: nothing.
struct HandleSteps {
  double way_m = 0.0;
  double turn_rad = 0.0;
};

/// A hand took hold of a handle of a sphere at one point of the screen and is at another one now, in clip
/// coordinates. With steps, the middle goes to multiples along what it moves along, the radius to multiples
/// too, at least one, and turns are multiples. Nothing where the ray through the point says nothing.
std::optional<ObjectPull> object_pull(const Screen& screen, ObjectHandle handle, const Sphere& sphere,
                                      glm::dvec2 from, glm::dvec2 to, const HandleSteps& steps);

}  // namespace offing::present

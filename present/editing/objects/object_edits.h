#pragma once

#include <cstddef>
#include <optional>

#include <glm/mat3x3.hpp>

#include "host/highlights/search/lighting.h"
#include "host/scene/model/scene.h"
#include "present/editing/objects/object_handles.h"
#include "present/editing/objects/scene_objects.h"

namespace offing::present {

/// Yaw, pitch and roll of a mesh that is turned like this (as base::Camera counts them), rad. Where it looks
/// straight up or down, its roll is 0.
glm::dvec3 turns_of(const glm::dmat3& rotation);

/// The rotation of a pull.
glm::dmat3 rotation_of(const ObjectPull& pull);

/// A mesh as a hand took hold of it.
struct HeldMesh {
  std::size_t mesh = 0;
  highlights::RigidMotion local = {};   ///< as the scene places it, in the world or on a body
  highlights::RigidMotion parent = {};  ///< of the body that carries it; else nothing
  glm::dvec3 middle_m{0.0};             ///< that turns and sizes are about, in the mesh's axes
};
/// Moves, turns and resizes it about its middle, along with its keyframes.
void pull_mesh(scene::Scene& scene, const HeldMesh& held, const ObjectPull& pull);

/// A floating body as a hand took hold of it.
struct HeldBody {
  std::size_t body = 0;
  std::optional<std::size_t> hull = {};
  /// Where it has got to by its own forces; nothing for a body on a path.
  struct Pose {
    double x_m, z_m, heading_rad;
  };
  std::optional<Pose> pose = {};
};
/// Moves and turns it over the water, from where it has got to, and resizes hull, draught, mass, propeller
/// and rudder.
void pull_body(scene::Scene& scene, const HeldBody& held, const ObjectPull& pull);

/// Where an object is that the scene alone places, and how large: a cloud layer, a wake window whose centre
/// is a place, both squares of twice the radius, or a bookmark. Nothing for all others.
std::optional<Sphere> place_of(const scene::Scene& scene, const SceneObject& object, double time_s);
/// Moves, resizes and turns one of them, or a light that stands at a place; `held` is where it was.
void pull_place(scene::Scene& scene, const SceneObject& object, const Sphere& held, const ObjectPull& pull);
/// Turns a light of a direction from one direction to another (unit vectors toward it), along with its
/// keyframes.
void aim_light(scene::Scene& scene, std::size_t light, const glm::dvec3& from, const glm::dvec3& to);

}  // namespace offing::present

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "host/scene/model/scene.h"
#include "host/scene/schema/parameter.h"

namespace offing::present {

/// What a user can select in a scene. The order is that of the list of objects.
enum class ObjectKind {
  camera,
  bookmark,
  sky,
  sea,
  wake,
  terrain,
  lake,
  cloud_layer,
  cloud,
  mesh,
  body,
  light
};

/// One of them: of a list such as [[mesh]] which one.
struct SceneObject {
  ObjectKind kind = ObjectKind::camera;
  std::size_t index = 0;

  bool operator==(const SceneObject&) const = default;
};

/// All that a scene has; the parts of a body come after it.
std::vector<SceneObject> objects_of(const scene::Scene& scene);
/// The body that an object is a part of: its hull, a mesh aboard or a wake window that follows it. Nothing
/// for all others.
std::optional<std::size_t> body_of_part(const scene::Scene& scene, const SceneObject& object);
/// All parts of a body.
std::vector<SceneObject> parts_of_body(const scene::Scene& scene, std::size_t body);
bool has_object(const scene::Scene& scene, const SceneObject& object);
/// How many of a kind it has.
std::size_t count_of(const scene::Scene& scene, ObjectKind kind);

/// The row of the parameter table that names objects of a kind; nullptr for kinds without names.
const scene::Parameter* name_row(ObjectKind kind);
/// Its name, or "mesh 2" without one.
std::string label_of(const scene::Scene& scene, const SceneObject& object);
/// The parameter groups of its values, that of its own section first.
std::vector<scene::ParameterGroup> groups_of(ObjectKind kind);

/// The body that a mesh moves with as its hull; nothing where it has none.
std::optional<std::size_t> body_of_mesh(const scene::Scene& scene, std::size_t mesh);
/// The mesh that a body moves; nothing where the scene does not have it.
std::optional<std::size_t> hull_of_body(const scene::Scene& scene, std::size_t body);

bool can_be_removed(const scene::Scene& scene, const SceneObject& object);
bool can_be_duplicated(const SceneObject& object);

/// Removes an object with what depends on it: with a body or its hull all parts of the body.
/// Throws Error(bad_usage) for what cannot be removed.
void remove_object(scene::Scene& scene, const SceneObject& object);
/// Removes a body and its wakes, and leaves its meshes where it floats upright at its start.
void stop_floating(scene::Scene& scene, std::size_t body);

/// The same again, `way_m` beside it, with its keyframes and a name of its own; a body or its hull with
/// all that belongs to them, but for wakes that the scene has no room for. Returns the copy. Throws
/// Error(bad_input) where the scene takes no more, and for a body without a hull; Error(bad_usage) for what
/// there is only one of.
SceneObject duplicate_object(scene::Scene& scene, const SceneObject& object, const glm::dvec3& way_m);

/// Gives an object another name, also wherever the scene refers to it. A hull with a name that follows the
/// body's, such as "boat hull", is renamed with the body. Throws Error(bad_input) for a text that cannot be a
/// name, for one that another of its kind has, and for an empty one where others refer to it.
void rename_object(scene::Scene& scene, const SceneObject& object, const std::string& name);

/// Whether the scene takes one more wake window.
bool has_room_for_wake(const scene::Scene& scene);
/// The name of the hull of a new boat.
std::string hull_name_of(const std::string& body);

/// A name that no other element of a list has: "ship", "ship 2" ...
template <class List>
std::string unused_name(const List& list, const std::string& stem) {
  std::string name = stem;
  const auto is_used = [&] {
    for (const auto& each : list) {
      if (each.name == name) return true;
    }
    return false;
  };
  for (int number = 2; is_used(); ++number) name = stem + " " + std::to_string(number);
  return name;
}

}  // namespace offing::present

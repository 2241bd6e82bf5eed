#pragma once

#include <optional>
#include <string>

#include "host/scene/model/scene.h"
#include "present/editing/handle_geometry.h"
#include "present/editing/objects/object_edit.h"
#include "present/passes/live_sea.h"

namespace offing::present {

/// Where a new object goes.
struct NewPlace {
  Camera camera;
  glm::dvec3 place_m{0.0};                 ///< in front of the camera, on the surface there
  std::optional<glm::dvec3> water_m = {};  ///< on open water in front of the camera, if it sees any
};

/// What the camera of a screen has before it: the surface a little below the middle of the picture, or 30 m
/// ahead where it sees none within 10 km.
NewPlace new_place(LiveSea& sea, const Screen& screen);

/// What has been added, and what there is to say of it.
struct AddedObject {
  SceneObject object;
  std::string news;
};

/// Ends the message about a boat that gets no wake, as the scene has as many as it can.
inline constexpr const char* no_room_for_wake = ", without a wake: the scene takes no more wakes";

/// Adds an object at a place, of a size that shows well from there. A boat is a hull with a body, an engine
/// that drives it across the picture, and a wake window that follows it, if the scene takes one more. Throws
/// Error(bad_input) where a scene takes no more, Error(bad_usage) for a boat without water, and for what the
/// scene has already.
AddedObject add_object(scene::Scene& scene, const NewObject& object, const NewPlace& place);

/// How far beside an object its copy goes: to the right of the picture, so that the two do not touch.
glm::dvec3 way_beside(const LiveSea& sea, const SceneObject& object, const Screen& screen);

}  // namespace offing::present

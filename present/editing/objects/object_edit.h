#pragma once

#include <cstddef>
#include <string>

#include "host/clouds/shape/cloud_parameters.h"
#include "present/editing/objects/scene_objects.h"

namespace offing::present {

/// What a user can add to a scene.
struct NewObject {
  enum class Kind { boat, mesh, light, cloud, cloud_layer, sea, terrain, lake, bookmark };
  Kind kind = Kind::boat;
  std::size_t shape = 0;                         ///< of a mesh: index of mesh_shapes::shapes()
  clouds::Genus genus = clouds::Genus::cumulus;  ///< of a cloud or a layer
};

/// What a user asks for of the objects of a scene, beside what keys do.
struct ObjectEdit {
  enum class Kind { add, rename, stop_floating };
  Kind kind = Kind::add;
  SceneObject object = {};  ///< that is there already
  NewObject added = {};
  std::string name = {};  ///< of rename
};

/// An object whose name is being typed.
struct Renaming {
  SceneObject object;
  std::string text;
  bool is_new = false;  ///< the field gets the keyboard with the next frame
};

}  // namespace offing::present

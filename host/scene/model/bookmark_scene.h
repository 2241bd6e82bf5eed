#pragma once

#include <string>

#include "host/base/camera.h"
#include "host/scene/model/view_scene.h"

namespace offing::scene {

/// A view that somebody wants to come back to.
struct BookmarkScene {
  std::string name;
  Camera camera = ViewScene{}.camera;  ///< its size in pixels says nothing
};

}  // namespace offing::scene

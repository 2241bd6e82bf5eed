#pragma once

#include <functional>

#include "host/highlights/search/lighting.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// Where a mesh of a scene is at any time. Its own copy of what it needs: the scene may go.
std::function<highlights::RigidMotion(double time_s)> motion_of(const Scene& scene, std::size_t mesh);

}  // namespace offing::scene

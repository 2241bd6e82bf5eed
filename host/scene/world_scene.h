#pragma once

#include "host/scene/ocean_scene.h"
#include "host/world/world.h"

namespace offing::scene {

/// What a world needs of a scene. Throws what prepare_sea() throws.
world::WorldParameters prepare_world(const OceanScene& scene);

}  // namespace offing::scene

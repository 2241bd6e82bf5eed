#pragma once

#include <vector>

#include "host/scene/model/scene.h"
#include "host/world/world_wakes.h"

namespace offing::scene {

/// The wakes of a scene, in water of this dispersion. Throws Error(bad_input) that names the section for
/// windows of unlike cells.
std::vector<world::WakeSettings> prepare_wakes(const Scene& scene, const ocean::Dispersion& dispersion);

}  // namespace offing::scene

#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of the parameter table for the ground: [terrain].
std::vector<Parameter> terrain_parameters();

}  // namespace offing::scene

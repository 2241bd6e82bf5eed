#pragma once

#include <vector>

#include "host/scene/parameter.h"

namespace offing::scene {

/// The rows of the parameter table that pictures depend on and simulations do not: camera, sun, exposure.
std::vector<Parameter> view_parameters();

}  // namespace offing::scene

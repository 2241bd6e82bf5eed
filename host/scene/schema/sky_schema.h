#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of the parameter table for what lights a picture: sun and air.
std::vector<Parameter> sky_parameters();

}  // namespace offing::scene

#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Rows of the parameter table for lights beside the sun.
std::vector<Parameter> light_parameters();

}  // namespace offing::scene

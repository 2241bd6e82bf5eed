#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Rows of the parameter table for the highlights of meshes.
std::vector<Parameter> highlight_parameters();

}  // namespace offing::scene

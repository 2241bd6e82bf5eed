#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Rows of the parameter table for meshes and what they look like.
std::vector<Parameter> mesh_parameters();

}  // namespace offing::scene

#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of the parameter table for the shape, the noise, the look and the motion of a cloud.
std::vector<Parameter> cloud_shape_parameters();

}  // namespace offing::scene

#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of the parameter table for the eye of a picture: camera and exposure.
std::vector<Parameter> view_parameters();

}  // namespace offing::scene

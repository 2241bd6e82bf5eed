#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of the parameter table for clouds: what is common to all, layers of many, and single ones.
std::vector<Parameter> cloud_parameters();

}  // namespace offing::scene

#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of the parameter table for the energy of a sea: its spectrum, modelled or measured, and its
/// water.
std::vector<Parameter> sea_parameters();

}  // namespace offing::scene

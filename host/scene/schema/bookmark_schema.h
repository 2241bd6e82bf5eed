#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of the parameter table for views to come back to: those of [camera] that say where the eye is and
/// where it looks, and a name.
std::vector<Parameter> bookmark_parameters();

}  // namespace offing::scene

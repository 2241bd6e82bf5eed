#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of the parameter table for edits of particles of clouds by hand.
std::vector<Parameter> particle_edit_parameters();

}  // namespace offing::scene

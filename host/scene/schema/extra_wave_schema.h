#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of the parameter table for waves beside the spectrum's: [[ocean.swell]], [[ocean.raindrop]].
std::vector<Parameter> extra_wave_parameters();

}  // namespace offing::scene

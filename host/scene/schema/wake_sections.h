#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of the parameter table for wakes: [[ocean.wake]] and [[ocean.wake.hull]].
std::vector<Parameter> wake_sections();

}  // namespace offing::scene

#pragma once

#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// The rows of [[body]].
std::vector<Parameter> body_parameters();

}  // namespace offing::scene

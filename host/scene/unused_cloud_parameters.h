#pragma once

#include <string>

#include "host/scene/parameter.h"

namespace offing::scene {

/// Why a use of parameters has no part in a cloud; empty where it has.
std::string against_cloud(const CloudScene& cloud, ParameterUse use);

}  // namespace offing::scene

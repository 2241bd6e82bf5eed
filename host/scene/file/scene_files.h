#pragma once

#include <string>
#include <vector>

#include "host/scene/model/scene.h"

namespace offing::scene {

/// Every file and folder that a scene names, in the order of the parameter table, whether it is there or not.
std::vector<std::string> files_of(const Scene& scene);

}  // namespace offing::scene

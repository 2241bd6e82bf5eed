#pragma once

#include <string>
#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Whether a row is of a [[cloud]], its balls or its levels.
bool is_of_one_cloud(const Parameter& row);

/// Why a use of parameters has no part in a cloud; empty where it has.
std::string against_cloud(const CloudScene& cloud, ParameterUse use);

/// A line for each [[light]] of a scene with clouds that does not light them, with its place and the reason.
std::vector<std::string> lights_without_clouds(const Scene& scene);

/// The lines of unused_parameters() that are of clouds: for those who take nothing else from a scene.
std::vector<std::string> unused_cloud_parameters(const Scene& scene);

}  // namespace offing::scene

#pragma once

#include <string>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

// Why a use of parameters has no part in a light, a mesh, a highlight or a body; empty where it has.

std::string against_light(const LightScene& light, ParameterUse use);
std::string against_mesh(const Scene& scene, ElementIndex element, ParameterUse use);
std::string against_body(const BodyScene& body, ParameterUse use);
std::string against_highlight(const Scene& scene, ElementIndex element, ParameterUse use);

}  // namespace offing::scene

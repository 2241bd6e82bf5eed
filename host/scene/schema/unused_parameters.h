#pragma once

#include <string>
#include <vector>

#include "host/scene/prepare/sea.h"
#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Why a row's value has no effect in a scene; empty where it has one.
std::string reason_unused(const Parameter& row, const UseContext& context);

/// A line for each parameter that a scene file or flag set and that this sea does not depend on: where it was
/// set, and why it does not matter. `sea` is what prepare_sea() made of the scene, up to its spectrum.
///
/// A value that another one overrides on purpose, a flag the scene file's or [ocean] that of [wind], is none.
std::vector<std::string> unused_parameters(const Scene& scene, const Sea& sea);
/// The same for a scene without a sea.
std::vector<std::string> unused_parameters(const Scene& scene);
/// Those lines that are of clouds: for those who take nothing else from a scene.
std::vector<std::string> unused_cloud_parameters(const Scene& scene);

}  // namespace offing::scene

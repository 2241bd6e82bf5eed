#pragma once

#include <string_view>

#include <toml++/toml.h>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Reads `y_m = { keys = [{ t = 0, value = 5 }, { t = 3.5, value = 8 }], interpolation = "linear" }`, the
/// keyframes of a row, into the scene. Throws Error(bad_input) with the place in `file` for a fault.
void read_track(Scene& scene, const Parameter& parameter, const toml::table& table, std::string_view file);

}  // namespace offing::scene

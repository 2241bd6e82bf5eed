#pragma once

#include <span>
#include <string_view>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Every value of a scene, one row each: the scene loader, the command-line flags, the help texts and the
/// scene hash are all made from these rows, so that they cannot drift apart.
std::span<const Parameter> parameter_table();

/// The row of this scene key, or nullptr.
const Parameter* find_parameter(std::string_view key);
/// The row that had this key earlier, or nullptr.
const Parameter* find_by_alias(std::string_view key);

}  // namespace offing::scene

#pragma once

#include <string_view>

#include "host/scene/schema/parameter.h"

namespace offing::present {

/// Whether each word that is looked for is among the words of a row's panel, its name or key, in any case:
/// "wind spe" finds the wind's speed. Nothing finds nothing.
bool is_found(std::string_view wanted, std::string_view panel, const scene::Parameter& row);
/// The same for words that begin alike, up to three letters from their end: "foamy" finds "foam".
bool is_found_alike(std::string_view wanted, std::string_view panel, const scene::Parameter& row);
/// As is_found(), among the words of its help too.
bool is_found_in_help(std::string_view wanted, std::string_view panel, const scene::Parameter& row);

}  // namespace offing::present

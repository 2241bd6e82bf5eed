#pragma once

#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Where something stands in a file: `storm.toml:14:13`. "scene" without a file's name: of a text that a
/// program made.
std::string place_text(std::string_view file, const toml::source_region& region);

/// One line of the value as it was written, cut where it gets long.
std::string shown_text(const toml::node& node);

/// The value for store(): numbers and text as they are, a date with an offset from UTC as its text in UTC, if
/// it is of a whole second.
WrittenValue written_value(const toml::node& node);

}  // namespace offing::scene

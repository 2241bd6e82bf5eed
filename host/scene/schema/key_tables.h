// The reference page of scene keys, in Markdown: one table a section.
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// Those of a section together, in the order of their first rows.
std::vector<Parameter> by_section(std::span<const Parameter> rows);

/// Heading and tables of these rows, by section. docs/reference/scene_keys.md holds it for all rows of
/// parameter_table().
std::string key_page(std::span<const Parameter> rows);

/// The header of a row's section: "[[light]]" or "[wind]".
std::string header_of(const Parameter& row);

/// How a value moves between keyframes: "" (it has none), "keys", or "keys, turn" for an angle.
std::string_view motion_text(const Parameter& row);

}  // namespace offing::scene

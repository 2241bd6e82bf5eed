#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace offing {

/// How many tables and lists of a TOML file may stand in one another, each way of writing them counted on its
/// own: names of a header or a key, joined by dots, and brackets.
inline constexpr int most_toml_levels = 32;

struct TomlPlace {
  std::size_t line = 1, column = 1;
};

/// Where a text goes deeper; nothing where it does not. Before toml++ parses it: what it makes of such a text
/// ends the stack. Beyond the first fault of the text the answer means nothing.
std::optional<TomlPlace> too_deep_toml(std::string_view text);

}  // namespace offing

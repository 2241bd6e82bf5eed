#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace offing {

/// How deep tables and lists of a TOML file may be nested, each way of writing them counted on its own:
/// names of a header or a key, joined by dots, and brackets.
inline constexpr int most_toml_levels = 32;

/// A place in a text, both counted from 1.
struct TomlPlace {
  std::size_t line = 1, column = 1;
};

/// Where a text is nested deeper; nothing if it is not. Call it before toml++ parses the text, whose
/// recursion would overflow the stack. After the first syntax error of the text the answer means nothing.
std::optional<TomlPlace> too_deep_toml(std::string_view text);

}  // namespace offing

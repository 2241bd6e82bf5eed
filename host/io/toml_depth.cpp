#include "host/io/toml_depth.h"

#include <algorithm>

namespace offing {
namespace {

/// The place after a string whose first quote stands at `at`: of one line, or of several between three
/// quotes.
std::size_t after_string(std::string_view text, std::size_t at) {
  const char quote = text[at];
  const std::string_view three = text.substr(at, 3);
  const bool is_long = three.size() == 3 && three[1] == quote && three[2] == quote;
  at += is_long ? 3 : 1;
  while (at < text.size()) {
    if (text[at] == '\\' && quote == '"') {
      at += 2;
    } else if (is_long && text[at] == quote && text.substr(at, 3) == three) {
      // Two quotes before the last three belong to the text.
      at += 3;
      for (int own = 0; own < 2 && at < text.size() && text[at] == quote; ++own) ++at;
      return at;
    } else if (!is_long && (text[at] == quote || text[at] == '\n')) {
      return at + 1;
    } else {
      ++at;
    }
  }
  return text.size();
}

TomlPlace place_of(std::string_view text, std::size_t at) {
  const std::string_view before = text.substr(0, at);
  const auto lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
  return {lines + 1, at - (lines == 0 ? 0 : before.rfind('\n') + 1) + 1};
}

}  // namespace

std::optional<TomlPlace> too_deep_toml(std::string_view text) {
  int names = 1, brackets = 0;
  for (std::size_t at = 0; at < text.size();) {
    const char here = text[at];
    if (here == '"' || here == '\'') {
      at = after_string(text, at);
      continue;
    }
    if (here == '#') {
      at = std::min(text.find('\n', at), text.size());
      continue;
    }
    if (here == '.') ++names;
    if (here == '[' || here == '{') ++brackets;
    if (here == ']' || here == '}') brackets = std::max(0, brackets - 1);
    if (std::string_view("\n=,[]{}").find(here) != std::string_view::npos) names = 1;
    if (names > most_toml_levels || brackets > most_toml_levels) return place_of(text, at);
    ++at;
  }
  return {};
}

}  // namespace offing

#pragma once

#include <string_view>

namespace offing {

/// A text without the mark of UTF-8 that Windows programs write at its begin.
constexpr std::string_view without_byte_order_mark(std::string_view text) {
  constexpr std::string_view mark = "\xef\xbb\xbf";
  if (text.starts_with(mark)) text.remove_prefix(mark.size());
  return text;
}

}  // namespace offing

#pragma once

#include <string>
#include <string_view>

namespace offing {

/// A relative URI as a file name: %20 is a blank (RFC 3986).
std::string decode_percent(std::string_view uri);

/// A file name as a relative URI: all but letters, digits, "-", ".", "_", "~" and the slashes between folders
/// is written as %XX of its bytes, so that decode_percent() gives it back.
std::string encode_percent(std::string_view file);

}  // namespace offing

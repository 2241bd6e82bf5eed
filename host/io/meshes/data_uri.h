#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace offing::meshes {

/// The bytes of "data:...;base64,..." (RFC 2397, RFC 4648); nothing for any other.
std::optional<std::string> decode_data_uri(std::string_view uri);

}  // namespace offing::meshes

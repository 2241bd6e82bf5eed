#pragma once

#include <string>
#include <string_view>

namespace offing::animations {

/// Bytes in base64 (RFC 4648).
std::string base64(std::string_view bytes);

/// A .glb file of a document and its buffer (glTF 2.0, section 4).
std::string gltf_binary(std::string_view json, std::string_view buffer);

}  // namespace offing::animations

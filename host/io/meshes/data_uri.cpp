#include "host/io/meshes/data_uri.h"

#include <cstdint>

namespace offing::meshes {

std::optional<std::string> decode_data_uri(std::string_view uri) {
  constexpr std::string_view mark = ";base64,";
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::size_t begin = uri.find(mark);
  if (!uri.starts_with("data:") || begin == std::string_view::npos) return std::nullopt;
  uri.remove_prefix(begin + mark.size());
  while (uri.ends_with('=')) uri.remove_suffix(1);
  std::string bytes;
  bytes.reserve(uri.size() / 4 * 3 + 3);
  std::uint32_t bits = 0;
  int count = 0;
  for (const char c : uri) {
    const std::size_t digit = digits.find(c);
    if (digit == std::string_view::npos) return std::nullopt;
    bits = (bits << 6) | static_cast<std::uint32_t>(digit);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes += static_cast<char>((bits >> count) & 0xff);
    }
  }
  return bytes;
}

}  // namespace offing::meshes

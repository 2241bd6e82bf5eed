#include "host/io/animations/gltf_container.h"

#include <cstddef>
#include <cstdint>

namespace offing::animations {
namespace {

void append_number(std::string& file, std::size_t value) {
  for (int byte = 0; byte < 4; ++byte) file.push_back(static_cast<char>((value >> (8 * byte)) & 0xff));
}

/// Length, kind, content, and as much padding as brings it to a multiple of four bytes.
void append_chunk(std::string& file, std::string_view kind, std::string_view content, char padding) {
  const std::size_t padded = (content.size() + 3) / 4 * 4;
  append_number(file, padded);
  file += kind;
  file += content;
  file.append(padded - content.size(), padding);
}

}  // namespace

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    std::uint32_t group = 0;
    for (std::size_t byte = i; byte < i + 3; ++byte)
      group = group << 8 | (byte < bytes.size() ? static_cast<unsigned char>(bytes[byte]) : 0u);
    for (std::size_t digit = 0; digit < 4; ++digit) {
      const bool is_there = i + digit <= bytes.size();
      text.push_back(is_there ? digits[(group >> (18 - 6 * digit)) & 63] : '=');
    }
  }
  return text;
}

std::string gltf_binary(std::string_view json, std::string_view buffer) {
  using namespace std::string_view_literals;
  std::string chunks;
  append_chunk(chunks, "JSON"sv, json, ' ');
  append_chunk(chunks, "BIN\0"sv, buffer, '\0');
  std::string file = "glTF";
  append_number(file, 2);
  append_number(file, 12 + chunks.size());
  return file + chunks;
}

}  // namespace offing::animations

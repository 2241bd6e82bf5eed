#include "host/io/file_mark.h"

#include <algorithm>
#include <cstdint>
#include <fstream>
#include <string>

namespace offing {
namespace {

constexpr std::string_view mark = "\x89HDF\r\n\x1a\n";

/// A block of the user may come first: the mark is at byte 0, 512, 1024, 2048 and so on (HDF5 File Format
/// Specification, section II.A). `bytes_at(offset)` returns as many bytes as the mark has, fewer at the end.
template <typename BytesAt>
bool has_mark(const BytesAt& bytes_at) {
  for (std::uint64_t at = 0;; at = std::max<std::uint64_t>(2 * at, 512)) {
    const std::string_view bytes = bytes_at(at);
    if (bytes == mark || bytes.size() < mark.size()) return bytes == mark;
  }
}

}  // namespace

bool is_hdf5_file(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::string bytes(mark.size(), '\0');
  return has_mark([&](std::uint64_t at) -> std::string_view {
    const bool is_there(file.seekg(static_cast<std::streamoff>(at)).read(bytes.data(), mark.size()));
    return is_there ? std::string_view(bytes) : std::string_view();
  });
}

bool is_hdf5(std::string_view bytes) {
  return has_mark([&](std::uint64_t at) { return at < bytes.size() ? bytes.substr(at, mark.size()) : ""; });
}

}  // namespace offing

// Refuses what is no file, or no readable one, before GDAL is asked.
#include "host/io/height_maps/readable_file.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <memory>
#include <system_error>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/file_trust.h"

namespace offing::height_maps {

void require_readable_file(const std::filesystem::path& path, const char* expected, const char* folder_hint) {
  if (is_address(path.string())) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected {}, found an address", one_line(path.string()), expected),
                "download it, and give the path of the file");
  }
  std::error_code status;
  const auto kind = std::filesystem::status(path, status).type();
  if (kind == std::filesystem::file_type::not_found) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected {}, found no such file", path.string(), expected),
                "check the path");
  }
  if (kind != std::filesystem::file_type::regular) {
    throw Error(ErrorKind::bad_input,
                fmt::format("{}: expected {}, found a {}", path.string(), expected,
                            kind == std::filesystem::file_type::directory ? "folder" : "device"),
                folder_hint);
  }
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"), std::fclose);
  if (!file) {
    throw Error(ErrorKind::file, fmt::format("{}: cannot be read: {}", path.string(), std::strerror(errno)),
                "check the permissions of the file and its folders");
  }
}

}  // namespace offing::height_maps

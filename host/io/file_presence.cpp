// Looks names up in the file system.
#include "host/io/file_presence.h"

#include <system_error>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing {
namespace {

bool found(const std::filesystem::path& path, const std::filesystem::file_status& status,
           const std::error_code& failure) {
  if (std::filesystem::status_known(status)) return std::filesystem::exists(status);
  throw Error(ErrorKind::file, fmt::format("{}: cannot be looked up: {}", path.string(), failure.message()),
              "choose a shorter name, or a folder that you may read");
}

}  // namespace

bool is_there(const std::filesystem::path& path) {
  std::error_code failure;
  return found(path, std::filesystem::status(path, failure), failure);
}

bool is_taken(const std::filesystem::path& path) {
  std::error_code failure;
  return found(path, std::filesystem::symlink_status(path, failure), failure);
}

}  // namespace offing

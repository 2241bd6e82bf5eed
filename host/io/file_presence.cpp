#include "host/io/file_presence.h"

#include <system_error>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing {

bool is_there(const std::filesystem::path& path) {
  std::error_code failure;
  const bool found = std::filesystem::exists(path, failure);
  if (failure) {
    throw Error(ErrorKind::file, fmt::format("{}: cannot be looked up: {}", path.string(), failure.message()),
                "choose a shorter name, or a folder that you may read");
  }
  return found;
}

}  // namespace offing

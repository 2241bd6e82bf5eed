#include "host/io/file_extension.h"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"

namespace offing {

void require_extension(const std::filesystem::path& path,
                       std::initializer_list<std::string_view> extensions) {
  const std::string found = path.extension().string();
  if (std::find(extensions.begin(), extensions.end(), found) != extensions.end()) return;
  std::filesystem::path mended = path;
  mended.replace_extension(*extensions.begin());
  throw Error(
      ErrorKind::bad_usage,
      fmt::format("{}: expected a name that ends in {}", path.string(), fmt::join(extensions, " or ")),
      fmt::format("name it {}", mended.filename().string()));
}

}  // namespace offing

#include "host/io/file_extension.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "host/base/error.h"

namespace offing {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& letter : extension) letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return extension;
}

void require_extension(const std::filesystem::path& path,
                       std::initializer_list<std::string_view> extensions) {
  const std::string found = path.extension().string();
  if (std::find(extensions.begin(), extensions.end(), found) != extensions.end()) return;
  std::filesystem::path fitting = path == "-" ? "out" : path;
  fitting.replace_extension(*extensions.begin());
  throw Error(
      ErrorKind::bad_usage,
      fmt::format("{}: expected a name that ends in {}", path.string(), fmt::join(extensions, " or ")),
      fmt::format("name it {}", fitting.filename().string()));
}

}  // namespace offing

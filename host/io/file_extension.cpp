#include "host/io/file_extension.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <vector>

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

bool is_vector_name(const std::filesystem::path& path) {
  constexpr std::array<std::string_view, 10> extensions{".geojson", ".json", ".gpkg", ".shp", ".kml",
                                                        ".kmz",     ".gml",  ".fgb",  ".gpx", ".dxf"};
  return std::ranges::find(extensions, lower_extension(path)) != extensions.end();
}

void refuse_vector_name(const std::filesystem::path& path,
                        std::initializer_list<std::string_view> extensions) {
  const std::string found = lower_extension(path);
  if (!is_vector_name(path) || std::ranges::find(extensions, found) != extensions.end()) return;
  std::vector<std::string> fitting;
  for (const std::string_view extension : extensions)
    fitting.push_back(std::filesystem::path(path.filename()).replace_extension(extension).string());
  throw Error(ErrorKind::bad_usage,
              fmt::format("{}: expected a name that ends in {}, found {}", path.string(),
                          fmt::join(extensions, " or "), found),
              fmt::format("name it {}", fmt::join(fitting, " or ")));
}

}  // namespace offing

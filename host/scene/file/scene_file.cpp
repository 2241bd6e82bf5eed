#include "host/scene/file/scene_file.h"

#include <cstddef>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "host/base/error.h"
#include "host/base/log.h"
#include "host/scene/file/scene_reader.h"

namespace offing::scene {

namespace {

/// How many errors of a file are reported at once.
constexpr std::ptrdiff_t most_errors = 10;

}  // namespace

Scene load_scene(const std::filesystem::path& file, Trust trust) {
  return parse_scene(read_scene_text(file), file.string(), file.parent_path(), trust);
}

Scene parse_scene(std::string_view text, std::string_view name, const std::filesystem::path& folder,
                  Trust trust, EarlierKeys earlier_keys) {
  SceneReading reading = read_scene(text, name, folder, trust);
  if (earlier_keys == EarlierKeys::warn) {
    for (const std::string& line : reading.warnings) spdlog::warn("{}", line);
  }
  std::vector<Error>& errors = reading.errors;
  if (!errors.empty()) {
    if (std::ssize(errors) > most_errors) errors.erase(errors.begin() + most_errors, errors.end());
    throw ErrorList(std::move(errors));
  }
  return std::move(reading.scene);
}

}  // namespace offing::scene

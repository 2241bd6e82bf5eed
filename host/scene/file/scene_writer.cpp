#include "host/scene/file/scene_writer.h"

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/file_extension.h"
#include "host/io/file_presence.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_text.h"

namespace offing::scene {

std::string scene_text(const Scene& scene, const std::filesystem::path& folder) {
  return SceneText(scene, folder).whole();
}

void save_scene_text(std::string_view text, const std::filesystem::path& file, Existing existing) {
  require_extension(file, {".toml"});
  if (existing == Existing::keep && is_taken(file)) {
    throw Error(ErrorKind::bad_usage, fmt::format("{}: already exists", file.string()),
                "choose another name, or overwrite it");
  }
  if (text.size() > most_scene_bytes) {
    throw Error(
        ErrorKind::bad_input,
        fmt::format("{}: expected a scene of at most {} bytes, the most that can be read back, found {}",
                    file.string(), most_scene_bytes, text.size()),
        "give clouds the balls of their genus again, or remove some");
  }
  write_file_atomically(file, text, existing);
}

void save_scene(const Scene& scene, const std::filesystem::path& file, Existing existing) {
  save_scene_text(scene_text(scene, file.parent_path()), file, existing);
}

}  // namespace offing::scene

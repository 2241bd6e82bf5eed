#include "present/window/file_intake.h"

#include <optional>

#include <fmt/format.h>

#include "host/base/error.h"
#include "present/editing/objects/selection.h"
#include "present/editing/pointed_place.h"
#include "present/window/dropped_files.h"

namespace offing::present {

void FileIntake::open(const ListedScene& scene) {
  if (!scene.is_shipped()) return open_file(scene.file);
  files_.add({{.file = scene.name, .source = FileSource::shipped}});
}

void FileIntake::open_file(const std::filesystem::path& file) {
  files_.add({{.file = file, .source = FileSource::chosen}});
}

void FileIntake::open_new() {
  files_.add({{.file = "a new scene", .source = FileSource::new_scene}});
}

bool FileIntake::turn(const std::vector<std::filesystem::path>& dropped, const Screen& screen,
                      glm::dvec2 pointer) {
  for (const std::filesystem::path& file : dropped) files_.add({{.file = file}});
  const std::optional<WaitingFile> file = files_.next(state_.message);
  if (!file) return false;
  bool is_other_scene = false;
  try {
    is_other_scene = take_in(*file, screen, pointer);
  } catch (const Error& error) {
    state_.message = fault_message(error);
  }
  files_.note(state_.message);
  return is_other_scene;
}

bool FileIntake::take_in(const WaitingFile& waiting, const Screen& screen, glm::dvec2 pointer) {
  const std::filesystem::path& file = waiting.file;
  const bool is_file = waiting.source == FileSource::dropped || waiting.source == FileSource::chosen;
  const DroppedKind kind = is_file ? kind_of_dropped(file) : DroppedKind::scene;
  if (options_.recording) {
    throw Error(
        ErrorKind::bad_usage,
        fmt::format("{}: cannot be opened while the window records", one_line(file.filename().string())),
        "drop it on a window that does not record");
  }
  if (kind == DroppedKind::scene) {
    if (waiting.source == FileSource::new_scene) {
      scenes_.open({});
    } else {
      scenes_.open(is_file ? open_scene(file, options_.trust) : shipped_scene(file.string()));
    }
    if (is_file) recent_.add(file);
    return true;
  }
  const glm::dvec2 place = waiting.source == FileSource::dropped ? pointer : glm::dvec2(0.0);
  const bool has_place = kind == DroppedKind::mesh;
  const glm::dvec3 place_m = has_place ? pointed_place(sea_, screen, place) : glm::dvec3(0.0);
  editing_.make([&](scene::Scene& scene) { return add_dropped(scene, file, kind, place_m); });
  if (state_.message.is_fault) return false;
  recent_.add(file);
  if (kind == DroppedKind::height_map) select_object(state_, {ObjectKind::terrain, 0});
  if (kind == DroppedKind::mesh) select_object(state_, {ObjectKind::mesh, state_.scene.meshes.size() - 1});
  return false;
}

}  // namespace offing::present

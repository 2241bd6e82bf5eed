#include "present/window/file_intake.h"

#include <optional>

#include <fmt/format.h>

#include "host/base/error.h"
#include "present/editing/pointed_place.h"
#include "present/window/dropped_files.h"

namespace offing::present {

void FileIntake::open(const ListedScene& scene) {
  const std::filesystem::path file = scene.is_shipped() ? std::filesystem::path(scene.name) : scene.file;
  files_.add({{.file = file, .is_shipped = scene.is_shipped()}});
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
  const DroppedKind kind = waiting.is_shipped ? DroppedKind::scene : kind_of_dropped(file);
  if (options_.recording) {
    throw Error(
        ErrorKind::bad_usage,
        fmt::format("{}: cannot be opened while the window records", one_line(file.filename().string())),
        "drop it on a window that does not record");
  }
  if (kind == DroppedKind::scene) {
    scenes_.open(waiting.is_shipped ? shipped_scene(file.string()) : open_scene(file, options_.trust));
    return true;
  }
  const bool has_place = kind == DroppedKind::mesh;
  const glm::dvec3 place_m = has_place ? pointed_place(sea_, screen, pointer) : glm::dvec3(0.0);
  editing_.make([&](scene::Scene& scene) { return add_dropped(scene, file, kind, place_m); });
  return false;
}

}  // namespace offing::present

#include "present/window/scene_switch.h"

#include <iterator>
#include <optional>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/io/atomic_file.h"
#include "host/io/file_presence.h"
#include "host/io/whole_file.h"
#include "host/scene/file/scene_edit.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_writer.h"
#include "present/output/camera_path.h"
#include "present/window/scene_sources.h"
#include "present/window/viewer_start.h"

namespace offing::present {
namespace {

constexpr std::size_t most_left = 16;

/// All that edits are kept of: the camera is moved without an edit.
std::string text_without_camera(scene::Scene scene) {
  take_camera_path({}, scene);
  scene.view.camera = {};
  scene.view.mode = {};
  return scene::scene_text(scene, "");
}

/// Whether both have a path of the camera, and these differ: one that has none is one that the user has left.
bool are_other_paths(const scene::Scene& one, const scene::Scene& other) {
  if (!has_camera_path(one) || !has_camera_path(other)) return false;
  scene::Scene path_of_one, path_of_other;
  take_camera_path(one, path_of_one);
  take_camera_path(other, path_of_other);
  return path_of_one.tracks != path_of_other.tracks;
}

/// But for the size of the picture.
bool are_same_view(const Camera& one, const Camera& other) {
  return one.eye_m == other.eye_m && one.yaw_rad == other.yaw_rad && one.pitch_rad == other.pitch_rad &&
         one.roll_rad == other.roll_rad && one.vertical_field_of_view_rad == other.vertical_field_of_view_rad;
}

std::string shown_name(const std::string& name) {
  return name.empty() ? "the scene before" : name;
}

std::string scene_file_text(const std::filesystem::path& file) {
  return read_whole_file(file, {.kind = "a scene file", .most_bytes = scene::most_scene_bytes});
}

}  // namespace

OpenedScene open_scene(const std::filesystem::path& file, Trust trust) {
  return {.scene = scene::load_scene(file, trust), .name = file.stem().string(), .file = file};
}

OpenedScene shipped_scene(std::string_view name) {
  const EmbeddedFile& source = shipped_source(name);
  return {.scene = scene::parse_scene(source.text, source.name, ""),
          .name = std::filesystem::path(source.name).stem().string(),
          .file = {}};
}

SavedScene::SavedScene(const std::filesystem::path& file, scene::Scene scene) : scene_(std::move(scene)) {
  std::error_code ignored;
  if (file.empty() || std::filesystem::is_symlink(file, ignored)) return;
  try {
    text_ = scene_file_text(file);
    file_ = file;
  } catch (const Error&) {  // it has gone since it was opened
  }
}

bool SavedScene::differs_from(const scene::Scene& scene) const {
  try {
    return are_other_paths(scene, scene_) || text_without_camera(scene) != text_without_camera(scene_);
  } catch (const Error&) {  // what no file can have is in none
    return true;
  }
}

std::filesystem::path SavedScene::save(const scene::Scene& scene, const std::filesystem::path& name,
                                       Existing existing) {
  if (file_.empty()) return write(scene, {}, name, existing);
  if (is_there(file_) && scene_file_text(file_) != text_) {
    throw Error(ErrorKind::file, fmt::format("{}: another program has changed it", file_.string()),
                "Ctrl Shift S saves under another name");
  }
  const std::filesystem::path folder = file_.parent_path();
  const std::optional<std::string> edited = scene::edited_scene_text(text_, folder, scene, folder);
  // Comments that cannot be kept are not lost.
  const bool loses_comments = !edited && text_.find('#') != std::string::npos;
  return loses_comments ? write(scene, {}, name, existing) : write(scene, edited, file_, Existing::replace);
}

std::filesystem::path SavedScene::save_as(const scene::Scene& scene, const std::filesystem::path& name,
                                          Existing existing) {
  std::optional<std::string> edited;
  if (!file_.empty())
    edited = scene::edited_scene_text(text_, file_.parent_path(), scene, name.parent_path());
  return write(scene, edited, name, existing);
}

std::filesystem::path SavedScene::write(const scene::Scene& scene, const std::optional<std::string>& edited,
                                        const std::filesystem::path& file, Existing existing) {
  if (edited) {
    scene::save_scene_text(*edited, file, existing);
  } else {
    scene::save_scene(scene, file, existing);
  }
  scene_ = scene;
  file_ = file;
  text_ = scene_file_text(file_);
  return file_;
}

SceneSwitch::Left SceneSwitch::leave() const {
  return {.opened = {options_.scene, options_.scene_name, options_.scene_file},
          .shown = state_.scene,
          .saved = saved_,
          .time_s = state_.clock.time_s(),
          .history = editing_.history()};
}

void SceneSwitch::show(const OpenedScene& opened, const scene::Scene& shown, double time_s) {
  sea_.open(shown);
  options_.scene = opened.scene;
  options_.scene.view.camera = sea_.scene().view.camera;  // which the ground may have placed
  options_.scene_name = opened.name;
  options_.scene_file = opened.file;
  const bool is_paused = state_.clock.is_paused();
  options_.time_s = time_s;
  const ViewState start = start_state(options_, sea_);
  state_.scene = shown;
  state_.scene.view.camera = options_.scene.view.camera;
  state_.camera = start.camera;
  state_.clock = start.clock;
  if (is_paused) state_.clock.toggle_pause();
  state_.pick.reset();
  state_.object.reset();
  state_.picked.reset();
  state_.renaming.reset();
  state_.clouds = {};
  state_.edit = {};
  state_.timeline.let_go();
}

void SceneSwitch::open(OpenedScene opened) {
  opened.scene.trust = options_.trust;  // of shipped ones too: files may be dropped on them
  Left left = leave();
  const bool is_unsaved = saved_.differs_from(state_.scene);
  show(opened, opened.scene, opened.scene.time.start_s);
  editing_.begin_anew(SceneHistory(options_.scene));
  saved_ = SavedScene(options_.scene_file, state_.scene);
  const std::string before = shown_name(left.opened.name);
  const std::string now = opened.name.empty() ? "a new scene" : opened.name;
  state_.message = {
      .text = is_unsaved
                  ? fmt::format("opened {}; edits of {} are not saved: Ctrl Z goes back to them", now, before)
                  : fmt::format("opened {}; Ctrl Z goes back to {}", now, before)};
  if (!sea_.warning().empty()) state_.message.text += '\n' + sea_.warning();
  // Scenes that undo() has left may have edits that are not saved: they come before this one too.
  before_.insert(before_.end(), std::make_move_iterator(after_.begin()),
                 std::make_move_iterator(after_.end()));
  after_.clear();
  before_.push_back(std::move(left));
  if (before_.size() > most_left) before_.erase(before_.begin(), before_.end() - most_left);
}

void SceneSwitch::go(std::vector<Left>& from, std::vector<Left>& to) {
  const Left next = from.back();
  Left left = leave();
  show(next.opened, next.shown, next.time_s);
  editing_.begin_anew(next.history);
  // The eye as it was left; key 0 goes back to that of the file.
  options_.scene.view.camera = next.opened.scene.view.camera;
  state_.camera = FreeCamera(next.opened.scene.view.camera);
  state_.camera.place(next.shown.view.camera);
  state_.scene.view.camera = state_.camera.camera();
  saved_ = next.saved;
  from.pop_back();
  to.push_back(std::move(left));
}

/// The scene is in this file from here on.
std::filesystem::path SceneSwitch::note(std::filesystem::path file) {
  options_.scene_name = file.stem().string();
  options_.scene_file = file;
  ++saves_;
  return file;
}

bool SceneSwitch::has_moved() const {
  return !has_camera_path(state_.scene) && !are_same_view(state_.camera.camera(), saved_.camera());
}

std::filesystem::path SceneSwitch::first_name() const {
  return options_.scene_file.parent_path() / first_save_name(options_.scene_name);
}

std::filesystem::path SceneSwitch::save() {
  return note(saved_.save(state_.scene, first_name(), Existing::keep));
}

std::filesystem::path SceneSwitch::save_as(const std::filesystem::path& file, Existing existing) {
  return note(saved_.save_as(state_.scene, file, existing));
}

std::vector<std::string> SceneSwitch::unsaved() const {
  std::vector<std::string> names;
  const auto look = [&](const SavedScene& saved, const scene::Scene& scene, const std::string& name) {
    if (saved.differs_from(scene)) names.push_back(name.empty() ? "the scene" : name);
  };
  look(saved_, state_.scene, options_.scene_name);
  for (const std::vector<Left>* scenes : {&before_, &after_}) {
    for (const Left& left : *scenes) look(left.saved, left.shown, left.opened.name);
  }
  return names;
}

void SceneSwitch::save_all() {
  if (saved_.differs_from(state_.scene)) save();
  for (std::vector<Left>* scenes : {&before_, &after_}) {
    for (Left& left : *scenes) {
      if (!left.saved.differs_from(left.shown)) continue;
      const std::filesystem::path folder = left.opened.file.parent_path();
      left.saved.save(left.shown, folder / first_save_name(left.opened.name), Existing::keep);
    }
  }
}

std::string SceneSwitch::undo_words() const {
  if (editing_.can_undo()) return "undo: " + editing_.undo_words();
  return before_.empty() ? "" : "back to " + shown_name(before_.back().opened.name);
}

std::string SceneSwitch::redo_words() const {
  if (editing_.can_redo()) return "redo: " + editing_.redo_words();
  return after_.empty() ? "" : "forward to " + shown_name(after_.back().opened.name);
}

bool SceneSwitch::undo() {
  if (editing_.can_undo() || before_.empty()) {
    editing_.undo();
    return false;
  }
  go(before_, after_);
  state_.message = {.text =
                        fmt::format("back in {}, as you left it; Ctrl Shift Z goes forward to {}",
                                    shown_name(options_.scene_name), shown_name(after_.back().opened.name))};
  return true;
}

bool SceneSwitch::redo() {
  if (editing_.can_redo() || after_.empty()) {
    editing_.redo();
    return false;
  }
  go(after_, before_);
  state_.message = {.text =
                        fmt::format("forward to {}, as you left it; Ctrl Z goes back to {}",
                                    shown_name(options_.scene_name), shown_name(before_.back().opened.name))};
  return true;
}

}  // namespace offing::present

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "present/editing/scene_editing.h"
#include "present/panels/panels.h"
#include "present/passes/live_sea.h"
#include "present/view_options.h"

namespace offing::present {

/// A scene as its file has it.
struct OpenedScene {
  scene::Scene scene;
  std::string name;            ///< for titles and names of files
  std::filesystem::path file;  ///< empty: none
};
/// Throws what load_scene() throws.
OpenedScene open_scene(const std::filesystem::path& file, Trust trust);
/// One of scene_sources(). Throws Error(bad_input) for another name.
OpenedScene shipped_scene(std::string_view name);

/// A scene as it stands in a file, and the file that the next save overwrites.
class SavedScene {
 public:
  /// Just opened from a file. If the name is empty, or the file is a link or cannot be read, saving writes
  /// another file.
  SavedScene(const std::filesystem::path& file, scene::Scene scene);

  /// Whether the next save overwrites a file.
  bool has_file() const { return !file_.empty(); }
  const Camera& camera() const { return scene_.view.camera; }
  /// Whether anything but the place of the camera differs.
  bool differs_from(const scene::Scene& scene) const;
  /// Writes it into the file that it was opened from or saved to last, whose comments, order and layout stay
  /// (scene_edit.h). A scene without a file is saved as `name`, which must not be there, and so is one whose
  /// comments cannot be kept. Returns what was written. Throws Error(file) where another program has changed
  /// the file, and what scene::save_scene() throws.
  std::filesystem::path save(const scene::Scene& scene, const std::filesystem::path& name, Existing existing);
  std::filesystem::path save_as(const scene::Scene& scene, const std::filesystem::path& name,
                                Existing existing);

 private:
  /// `edited`: the text to write, where that of the file could be edited.
  std::filesystem::path write(const scene::Scene& scene, const std::optional<std::string>& edited,
                              const std::filesystem::path& file, Existing existing);

  scene::Scene scene_;
  std::filesystem::path file_;
  std::string text_;  // of the file, when it was opened or saved
};

/// Takes a window from one scene to another, as if the program had been started with it, in the same window
/// and on the same device, and back again: scenes that were left are kept with their edits.
class SceneSwitch {
 public:
  /// What is shown first is the scene of the options; they follow what is opened.
  SceneSwitch(ViewOptions& options, LiveSea& sea, ViewState& state, SceneEditing& editing)
      : options_(options),
        sea_(sea),
        state_(state),
        editing_(editing),
        saved_(options.scene_file, state.scene) {}

  /// The message then says what has been left. Throws what LiveSea::open() throws, and has changed nothing
  /// then.
  void open(OpenedScene scene);
  /// Takes back the last edit, or where none is left goes to the scene that was left last, as it was left;
  /// true if another scene is shown from here on. Throws as open() does.
  bool undo();
  /// The same the other way: redoes an edit, or goes on to the scene that undo() has left.
  bool redo();
  /// What undo() and redo() would do; empty: nothing.
  std::string undo_words() const;
  std::string redo_words() const;
  /// Saves the state's scene, which has that file and its name from here on. Both return what was written.
  std::filesystem::path save();
  std::filesystem::path save_as(const std::filesystem::path& file, Existing existing);
  /// Whether save() has a file to write. It has none of a scene that comes with the program, that is new, or
  /// whose file is a link.
  bool has_file() const { return saved_.has_file(); }
  /// Whether the user has moved the camera since the scene was opened or saved: that is no edit, but files
  /// keep it.
  bool has_moved() const;
  /// Counts what has been saved.
  std::uint64_t saves() const { return saves_; }
  /// What is offered to save the scene as: beside its file.
  std::filesystem::path first_name() const;
  /// Whether the scene that is shown has edits that its file has not.
  bool is_unsaved() const { return saved_.differs_from(state_.scene); }
  /// Names of all scenes with edits that no file has: the one that is shown and those that were left.
  std::vector<std::string> unsaved() const;
  /// Saves them all.
  void save_all();

 private:
  struct Left {
    OpenedScene opened;
    scene::Scene shown;
    SavedScene saved;
    double time_s;
    SceneHistory history;
  };

  Left leave() const;
  std::filesystem::path note(std::filesystem::path file);
  void show(const OpenedScene& opened, const scene::Scene& shown, double time_s);
  /// To the last one of `from`; the scene that is left becomes the last one of `to`.
  void go(std::vector<Left>& from, std::vector<Left>& to);

  ViewOptions& options_;
  LiveSea& sea_;
  ViewState& state_;
  SceneEditing& editing_;
  SavedScene saved_;
  std::uint64_t saves_ = 0;
  // The next one last: before the scene that is shown, and those that undo() has left.
  std::vector<Left> before_, after_;
};

}  // namespace offing::present

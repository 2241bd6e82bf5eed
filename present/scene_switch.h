#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "present/live_sea.h"
#include "present/panels.h"
#include "present/scene_editing.h"
#include "present/view_options.h"

namespace offing::present {

/// A scene as its file has it.
struct OpenedScene {
  scene::OceanScene scene;
  std::string name;            ///< for titles and names of files
  std::filesystem::path file;  ///< empty: none
};
/// Throws what load_scene() throws.
OpenedScene open_scene(const std::filesystem::path& file);
/// One of scene_sources(). Throws Error(bad_input) for another name.
OpenedScene shipped_scene(std::string_view name);

/// Takes a window from one scene to another, as if the program had been started with it, in the same window
/// and on the same device, and back again: scenes that were left are kept with their edits.
class SceneSwitch {
 public:
  /// What is shown first is the scene of the options; they follow what is opened.
  SceneSwitch(ViewOptions& options, LiveSea& sea, ViewState& state, SceneEditing& editing)
      : options_(options), sea_(sea), state_(state), editing_(editing), saved_(state.scene) {}

  /// The message then says what has been left. Throws what LiveSea::open() throws, and has changed nothing
  /// then.
  void open(OpenedScene scene);
  /// Takes back the last edit, or where none is left goes to the scene that was left last, as it was left;
  /// true if another scene is shown from here on. Throws as open() does.
  bool undo();
  /// The same the other way: redoes an edit, or goes on to the scene that undo() has left.
  bool redo();
  /// The state's scene is in a file.
  void note_saved() { saved_ = state_.scene; }

 private:
  struct Left {
    OpenedScene opened;
    scene::OceanScene shown, saved;
    double time_s;
    SceneHistory history;
  };

  bool has_unsaved_edits() const;
  Left leave() const;
  void show(const OpenedScene& opened, const scene::OceanScene& shown, double time_s);
  /// To the last one of `from`; the scene that is left becomes the last one of `to`.
  void go(std::vector<Left>& from, std::vector<Left>& to);

  ViewOptions& options_;
  LiveSea& sea_;
  ViewState& state_;
  SceneEditing& editing_;
  scene::OceanScene saved_;  // as it is in a file
  // The next one last: before the scene that is shown, and those that undo() has left.
  std::vector<Left> before_, after_;
};

}  // namespace offing::present

#pragma once

#include <filesystem>
#include <vector>

#include "present/editing/handle_geometry.h"
#include "present/editing/scene_editing.h"
#include "present/files/recent_files.h"
#include "present/passes/live_sea.h"
#include "present/view_options.h"
#include "present/window/file_queue.h"
#include "present/window/scene_list.h"
#include "present/window/scene_switch.h"

namespace offing::present {

/// What becomes of files that are dropped on a window: a scene is opened, all others are edits of the scene
/// that is shown. A file that cannot be read is told by the message and changes nothing.
class FileIntake {
 public:
  FileIntake(const ViewOptions& options, LiveSea& sea, ViewState& state, SceneEditing& editing,
             SceneSwitch& scenes, RecentFiles& recent)
      : options_(options), sea_(sea), state_(state), editing_(editing), scenes_(scenes), recent_(recent) {}

  // Each waits until the files before it have been taken in.
  void open(const ListedScene& scene);
  /// As a dropped file, but for the place of a mesh: in the middle of the view.
  void open_file(const std::filesystem::path& file);
  /// A scene as a file without any values has it.
  void open_new();
  /// Takes in the next file, once a frame; true if another scene is shown from here on. Meshes are put where
  /// the pointer is, in clip coordinates.
  bool turn(const std::vector<std::filesystem::path>& dropped, const Screen& screen, glm::dvec2 pointer);
  /// Whether all files have been taken in.
  bool is_idle() const { return files_.is_empty(); }

 private:
  bool take_in(const WaitingFile& waiting, const Screen& screen, glm::dvec2 pointer);

  const ViewOptions& options_;
  LiveSea& sea_;
  ViewState& state_;
  SceneEditing& editing_;
  SceneSwitch& scenes_;
  RecentFiles& recent_;
  FileQueue files_;
};

}  // namespace offing::present

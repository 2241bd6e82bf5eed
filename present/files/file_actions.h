#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "present/editing/scene_editing.h"
#include "present/files/file_dialog.h"
#include "present/files/recent_files.h"
#include "present/panels/panels.h"
#include "present/view_options.h"
#include "present/window/file_intake.h"
#include "present/window/key_bindings.h"
#include "present/window/scene_list.h"
#include "present/window/scene_switch.h"

namespace offing::present {

/// What keys and buttons do with files: new scenes, opening, saving, and the dialog in which files are
/// chosen.
class FileActions {
 public:
  FileActions(const ViewOptions& options, ViewState& state, SceneEditing& editing, SceneSwitch& scenes,
              FileIntake& intake, SceneList& list, RecentFiles& recent)
      : options_(options),
        state_(state),
        editing_(editing),
        scenes_(scenes),
        intake_(intake),
        list_(list),
        recent_(recent) {}

  /// True if it is an action on files.
  bool act(ViewAction action);
  /// Asks for a file to open.
  void open(FileFilter filter);
  /// Asks for the file, or the folder, that a value of the scene names.
  void browse(const scene::ValueKey& value);
  /// While the dialog is open, it has all keys.
  bool asks() const { return dialog_.is_open(); }
  void close() { dialog_.close(); }
  void for_shown_names(const std::function<void(std::string_view)>& tell) const {
    dialog_.for_shown_names(tell);
  }
  /// Between PanelLayer::begin() and end().
  void draw();

 private:
  void save();
  void ask_where_to_save();
  /// The value that was asked for is this file.
  void take_value(const std::filesystem::path& file);
  /// Does it, and the message says what was written, or the fault.
  void write(const std::function<std::filesystem::path()>& work);

  const ViewOptions& options_;
  ViewState& state_;
  SceneEditing& editing_;
  SceneSwitch& scenes_;
  FileIntake& intake_;
  SceneList& list_;
  RecentFiles& recent_;
  FileDialog dialog_;
  std::optional<scene::ValueKey> browsed_;
};

/// What a dialog lists for a row that names a file.
FileFilter filter_of_row(std::string_view key);

}  // namespace offing::present

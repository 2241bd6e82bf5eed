#pragma once

#include <optional>
#include <string>
#include <vector>

#include "present/output/recorder.h"
#include "present/panels/panels.h"
#include "present/window/scene_switch.h"

namespace offing::present {

/// Quitting a window: a dialog asks if there are unsaved edits, whether to save them, discard them or stay,
/// and if a recording runs, whether to end it.
class QuitDialog {
 public:
  QuitDialog(SceneSwitch& scenes, ViewState& state) : scenes_(scenes), state_(state) {}

  /// The user wants to quit. `recording`: that runs.
  void open(const std::optional<RecordingProgress>& recording);
  bool is_open() const { return is_open_; }
  bool has_quit() const { return has_quit_; }
  /// Between PanelLayer::begin() and end(). Once the recording has ended and nothing is unsaved, the window
  /// quits.
  void draw(const std::optional<RecordingProgress>& recording);
  /// Saves all edits, if there are any, and quits; where that fails the state's message says why, and the
  /// window stays.
  void save();
  void cancel() { is_open_ = false; }

 private:
  void quit();

  SceneSwitch& scenes_;
  ViewState& state_;
  std::vector<std::string> unsaved_;  // names of scenes
  bool is_open_ = false, has_quit_ = false;
};

}  // namespace offing::present

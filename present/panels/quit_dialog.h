#pragma once

#include <string>
#include <vector>

#include "present/panels/panels.h"
#include "present/window/scene_switch.h"

namespace offing::present {

/// Quitting a window: if there are unsaved edits, a dialog asks whether to save them, discard them or stay.
class QuitDialog {
 public:
  QuitDialog(SceneSwitch& scenes, ViewState& state) : scenes_(scenes), state_(state) {}

  /// The user wants to quit.
  void open();
  bool is_open() const { return !unsaved_.empty(); }
  bool has_quit() const { return has_quit_; }
  /// Between PanelLayer::begin() and end().
  void draw();
  /// Saves all edits and quits; where that fails the state's message says why, and the window stays.
  void save();
  void cancel() { unsaved_.clear(); }

 private:
  SceneSwitch& scenes_;
  ViewState& state_;
  std::vector<std::string> unsaved_;  // names of scenes; none: the dialog is closed
  bool has_quit_ = false;
};

}  // namespace offing::present

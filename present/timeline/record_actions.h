#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include "present/panels/panels.h"
#include "present/timeline/record_dialog.h"
#include "present/view_options.h"

namespace offing::present {

/// What keys and buttons do to record the scene of a window: a dialog, a recording in the background, and a
/// message about what came of it.
class RecordActions {
 public:
  RecordActions(const ViewOptions& options, ViewState& state) : options_(options), state_(state) {}
  RecordActions(const RecordActions&) = delete;
  RecordActions& operator=(const RecordActions&) = delete;
  /// Stops a recording, and waits for the end of its frame in progress.
  ~RecordActions();

  /// Asks what to record. One recording runs at a time.
  void open();
  /// While the dialog is open, it has all keys.
  bool asks() const { return dialog_.is_open(); }
  void close() { dialog_.close(); }
  bool is_recording() const { return job_ != nullptr; }
  /// Nothing if nothing is recorded.
  std::optional<RecordingProgress> progress() const;
  void cancel();
  /// Says what came of a recording that has ended.
  void turn();
  /// Texts of the dialog, in letters of any language.
  void for_shown_names(const std::function<void(std::string_view)>& tell) const;
  /// Between PanelLayer::begin() and end(). `window`: its size in pixels.
  void draw(ImageSize window);

 private:
  void begin();
  void refuse_taken(const Recording& recording) const;
  void make_folder(const Recording& recording);
  void remove_empty_folder();

  const ViewOptions& options_;
  ViewState& state_;
  RecordDialog dialog_;
  std::optional<RecordingRequest> last_;  // what was recorded last
  std::unique_ptr<RecordingJob> job_;
  std::filesystem::path made_folder_;  // for the recording's pictures; empty: none
};

}  // namespace offing::present

#pragma once

#include <array>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include "host/scene/model/scene.h"
#include "present/files/file_dialog.h"
#include "present/output/recording_job.h"

namespace offing::present {

/// What the frames of a recording become.
enum class RecordFormat { mp4, webm, png, exr };
inline constexpr std::array<const char*, 4> record_format_names{
    "video (.mp4)", "video (.webm)", "pictures (.png)", "scene-linear pictures (.exr)"};

/// What a user asks to be recorded.
struct RecordingRequest {
  RecordFormat format = RecordFormat::mp4;
  ImageSize size = {};
  double start_s = 0.0, seconds = 2.0, frames_per_second = 24.0;
  Detail detail = Detail::high;
  std::string name = {};  ///< without its ending, and for pictures without the number
  bool replaces = false;
  bool has_folder = true;  ///< pictures: in a folder of this name
  bool has_path = false;   ///< the camera, which follows it
};

/// The recording that is asked for. Throws Error(bad_usage) for a name or a range that cannot be.
Recording recording_of(const RecordingRequest& request);

/// The first of stem_001, stem_002 ... that no file of the current folder begins with.
std::string unused_record_name(const std::string& stem);

/// A dialog of the panels in which the user says what is to be recorded. It begins with the seconds, which
/// have the keyboard; Enter records, Esc closes the dialog.
class RecordDialog {
 public:
  /// `request`: what it shows first.
  void open(const RecordingRequest& request);
  bool is_open() const { return is_open_; }
  void close() { is_open_ = false; }
  /// Stays open and says why this cannot be recorded.
  void refuse(const std::string& fault) { fault_ = fault; }
  /// All names that it shows, in letters of any language.
  void for_shown_names(const std::function<void(std::string_view)>& tell) const;
  /// As it was edited last.
  const RecordingRequest& request() const { return request_; }
  /// Between PanelLayer::begin() and end(). Whether it is to be recorded.
  /// `now_s`: the time that the window shows.
  bool draw(ImageSize window, double now_s);

 private:
  void draw_format();
  void draw_size(ImageSize window);
  void draw_range(double now_s);
  void draw_name();

  bool is_open_ = false, focuses_seconds_ = false, has_list_ = false;
  RecordingRequest request_;
  std::string fault_;
  FileDialog folders_;  // to choose one
  int longest_px_ = 0;  // side that the device draws
};

}  // namespace offing::present

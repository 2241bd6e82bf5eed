// --frames and --fps of commands that write frames of a scene.
#pragma once

#include <string>

#include "host/base/argument.h"
#include "host/command_line/setting_options.h"
#include "host/scene/model/scene.h"

namespace offing {

/// Must outlive the command.
class FrameFlags {
 public:
  void add_frames_to(CLI::App& command, const char* group);
  /// For commands that do not take the scene's own flags.
  void add_fps_to(CLI::App& command, const char* group);

  bool has_frames() const;
  bool has_fps() const { return fps_.are_given(); }

  /// The scene's times, with the frame rate of --fps if it was given.
  scene::TimeSection times(const scene::Scene& scene) const;
  /// The frames of --frames, else those of the scene's time span. Throws Error(bad_usage) for a text that is
  /// no range, and what frames_in_time_span() throws.
  FrameRange frames(const scene::Scene& scene) const;

 private:
  std::string frames_;
  const CLI::Option* frames_option_ = nullptr;
  SettingOptions<scene::TimeSection> fps_;
};

}  // namespace offing

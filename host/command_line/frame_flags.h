// --frames and --fps of commands that write frames of a scene.
#pragma once

#include <string>

#include "host/base/argument.h"
#include "host/command_line/setting_options.h"
#include "host/scene/model/scene.h"

namespace offing {

/// `this` must outlive the command.
class FrameFlags {
 public:
  void add_frames_to(CLI::App& command, const char* group);
  /// For commands that do not take the scene's own flags.
  void add_fps_to(CLI::App& command, const char* group);

  bool has_frames() const { return !frames_.empty(); }
  bool has_fps() const { return fps_.are_given(); }

  /// The scene's, with the frames a second of the flag.
  scene::TimeSection times(const scene::Scene& scene) const;
  /// Those of the flag, else those of the scene's time span. Throws Error(bad_usage) for other text, and
  /// what frames_in_time_span() throws.
  FrameRange frames(const scene::Scene& scene) const;

 private:
  std::string frames_;
  SettingOptions<scene::TimeSection> fps_;
};

}  // namespace offing

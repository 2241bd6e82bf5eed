#include "host/command_line/frame_flags.h"

#include <CLI/App.hpp>
#include <CLI/Option.hpp>

#include "host/scene/prepare/scene_frames.h"

namespace offing {

void FrameFlags::add_frames_to(CLI::App& command, const char* group) {
  frames_option_ =
      command
          .add_option(
              "--frames", frames_,
              "frames to make: A to B inclusive, or A alone; time = frame / fps (default: the scene's)")
          ->type_name("A:B")
          ->group(group);
}

void FrameFlags::add_fps_to(CLI::App& command, const char* group) {
  fps_.add_to(command, {{&scene::TimeSection::frames_per_second, over_scene("time.fps", "--fps")}}, group);
}

bool FrameFlags::has_frames() const {
  return frames_option_ != nullptr && !frames_option_->empty();
}

scene::TimeSection FrameFlags::times(const scene::Scene& scene) const {
  return fps_.read(scene.time);
}

FrameRange FrameFlags::frames(const scene::Scene& scene) const {
  return has_frames() ? read_frame_range("--frames", frames_)
                      : scene::frames_in_time_span(scene, times(scene).frames_per_second);
}

}  // namespace offing

#include "host/command_line/frame_flags.h"

#include <CLI/App.hpp>

#include "host/scene/prepare/scene_frames.h"

namespace offing {

void FrameFlags::add_frames_to(CLI::App& command, const char* group) {
  command
      .add_option("--frames", frames_,
                  "frames to make, A to B or A alone; time = frame / fps (default: the scene's)")
      ->type_name("A:B")
      ->group(group);
}

void FrameFlags::add_fps_to(CLI::App& command, const char* group) {
  fps_.add_to(command, {{&scene::TimeSection::frames_per_second, over_scene("time.fps", "--fps")}}, group);
}

scene::TimeSection FrameFlags::times(const scene::Scene& scene) const {
  return fps_.read(scene.time);
}

FrameRange FrameFlags::frames(const scene::Scene& scene) const {
  return frames_.empty() ? scene::frames_in_time_span(scene, times(scene).frames_per_second)
                         : read_frame_range("--frames", frames_);
}

}  // namespace offing

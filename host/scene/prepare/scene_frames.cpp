#include "host/scene/prepare/scene_frames.h"

#include <cmath>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::scene {
namespace {

// As read_frame_range() takes them.
constexpr int last_frame = 9'999'999;

}  // namespace

FrameRange frames_in_time_span(const Scene& scene, double frames_per_second) {
  const double first = std::ceil(scene.time.start_s * frames_per_second - 1e-9) + 0.0;  // + 0: never -0
  const double last = std::ceil(scene.time.end_s * frames_per_second - 1e-9) - 1.0;
  if (last < first || last > last_frame) {
    throw Error(ErrorKind::bad_input,
                fmt::format("time: expected frames 0 to {} between start_s = {:g} and end_s = {:g} at {:g} a "
                            "second, found {}",
                            last_frame, scene.time.start_s, scene.time.end_s, frames_per_second,
                            last < first ? "none" : fmt::format("{:.0f} to {:.0f}", first, last)),
                last < first ? "write an end_s after start_s, or give --frames A:B"
                             : "give --frames A:B, or fewer frames per second");
  }
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace offing::scene

#include "host/cli/scene_frames.h"

#include <cmath>

#include <fmt/format.h>

#include "host/base/error.h"

namespace offing::cli {

FrameRange frames_in_time_span(const scene::OceanScene& scene) {
  const double first = std::ceil(scene.start_s * scene.frames_per_second - 1e-9);
  const double last = std::ceil(scene.end_s * scene.frames_per_second - 1e-9) - 1.0;
  if (last < first || last > 9'999'999.0) {
    throw Error(ErrorKind::bad_input,
                fmt::format("time: expected frames between start_s = {:g} and end_s = {:g}, found {}",
                            scene.start_s, scene.end_s, last < first ? "none" : "too many"),
                "write an end_s after start_s, or give --frames A:B");
  }
  return {static_cast<int>(first), static_cast<int>(last)};
}

}  // namespace offing::cli

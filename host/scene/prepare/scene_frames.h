#pragma once

#include "host/base/argument.h"
#include "host/scene/model/scene.h"

namespace offing::scene {

/// Frames of the scene's time span, frame i at i / frames_per_second: from its start, stopping before its
/// end. Throws Error(bad_input) where there are none or frames beyond 9,999,999.
FrameRange frames_in_time_span(const Scene& scene, double frames_per_second);

}  // namespace offing::scene

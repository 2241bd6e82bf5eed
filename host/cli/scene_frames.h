#pragma once

#include "host/base/argument.h"
#include "host/scene/ocean_scene.h"

namespace offing::cli {

/// Frames of the scene's time span: from its start, stopping before its end. Throws Error(bad_input) where
/// there are none or more than 9,999,999.
FrameRange frames_in_time_span(const scene::OceanScene& scene);

}  // namespace offing::cli

#pragma once

#include "host/base/argument.h"
#include "host/base/progress.h"
#include "host/base/work.h"
#include "host/io/animations/highlight_animation.h"
#include "host/ocl/device.h"
#include "host/scene/model/scene.h"

namespace offing::cli {

/// The highlights of a scene's meshes over frames, as offing-view draws them in files, with the same id as
/// long as each lasts. Throws Error(bad_input) for a scene without meshes that have highlights,
/// Error(cancelled), and what preparing its world and showing its meshes throws.
animations::HighlightAnimation record_highlights(const ocl::Device& device, scene::Scene scene,
                                                 const FrameRange& frames, Progress& progress,
                                                 const CancelToken& cancel);

}  // namespace offing::cli

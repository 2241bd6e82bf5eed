#pragma once

#include <string>
#include <vector>

#include "host/base/progress.h"
#include "host/base/work.h"
#include "host/cli/ocean/bake_settings.h"
#include "host/cli/ocean/frame_files.h"
#include "host/cli/ocean/frame_writer.h"
#include "host/ocl/device_list.h"
#include "host/scene/prepare/sea.h"

namespace offing::cli {

struct BakeSummary {
  int written = 0;
  int kept = 0;  ///< were there already
};

/// Makes the frames of the settings' share that are not done yet: a thread for each device, which take frames
/// in turn, and some that write while the next frame is simulated. Throws the first error of any thread,
/// Error(cancelled) when stopped; frames finished by then stay.
BakeSummary bake(const std::vector<ocl::DeviceInfo>& devices, const scene::Sea& sea,
                 const BakeSettings& settings, const FrameFiles& files, FrameWriter& writer,
                 Progress& progress, const CancelToken& cancel, const scene::Scene& scene = {});

}  // namespace offing::cli

#pragma once

#include <string>
#include <string_view>

#include "host/scene/prepare/sea.h"

namespace offing::scene {

/// 32 hexadecimal digits that change with everything that shapes a frame's pixels: every parameter with an
/// influence, the measured spectrum's content (not its name), the cascades, the version, and
/// `output_settings`, a canonical text of how frames are written. Equal on every machine.
std::string scene_hash(const Scene& scene, const Sea& sea, std::string_view output_settings);

}  // namespace offing::scene

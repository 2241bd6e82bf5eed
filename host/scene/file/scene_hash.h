#pragma once

#include <string>
#include <string_view>

#include "host/scene/prepare/sea.h"
#include "host/scene/schema/parameter.h"

namespace offing::scene {

/// What shapes maps and answers about water, without and with the wakes of a scene.
inline constexpr Affects shapes_sea = Affects::baked;
inline constexpr Affects shapes_sea_and_wakes =
    Affects::baked | Affects::wakes | Affects::bodies | Affects::meshes;

/// 32 hexadecimal digits that change with everything that shapes a frame's pixels: every parameter with an
/// influence on `what`, with its keyframes, the measured spectrum's content (not its name), that of the files
/// of hulls, the cascades, the version, and `output_settings`, a canonical text of how frames are written.
/// Equal on every machine. Throws Error as read_whole_file().
std::string scene_hash(const Scene& scene, const Sea& sea, std::string_view output_settings,
                       Affects what = shapes_sea);

}  // namespace offing::scene

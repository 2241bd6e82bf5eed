#pragma once

#include <string>

#include "host/io/animations/highlight_animation.h"

namespace offing::animations {

/// An animation as JSON: {"generator", "version": 1, "frames_per_s", "first_frame", "frame_count",
/// "lights": [name], "textures": [{"name", "file"?}], "meshes": [{"name", "file"?, "scale", "frames":
/// [{"frame", "time_s", "mesh": {"translation_m", "rotation": [x, y, z, w]}, "highlights": [{"id", "rule",
/// "copy", "light", "position_m", "right", "up", "normal", "width_m", "height_m", "opacity", "texture",
/// "softness", "colour"}]}]}]}. Vectors are in the world's axes (right-handed, y up), `texture` is an index,
/// a rotation is a unit quaternion. Numbers read back to the same doubles.
/// `lights` and `light` are written under their earlier names, `lamps` and `lamp`, too.
std::string highlight_animation_json(const HighlightAnimation& animation);

}  // namespace offing::animations

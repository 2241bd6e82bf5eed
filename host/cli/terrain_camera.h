#pragma once

#include <string_view>

#include "host/base/camera.h"
#include "host/base/height_map.h"

namespace offing::cli {

/// Where a camera of `--camera` stands: "fly" (over the middle of the southern edge, 300 m above the highest
/// post, looking north and 15 degrees down), "walk" (on the ground in the middle of the map, 1.7 m high,
/// looking where it falls) or "X,Y,Z,YAW_DEG,PITCH_DEG". Throws Error(bad_usage) for anything else.
Camera read_terrain_camera(std::string_view text, const HeightMap& map);

}  // namespace offing::cli

#pragma once

#include "host/base/camera.h"
#include "host/base/height_map.h"

namespace offing::terrain {

/// Over the middle of a map's southern edge, 300 m above its highest post, looking north and 15 degrees down.
/// The map's first post is at x = z = 0. Field of view and size are a Camera's own.
Camera flying_camera(const HeightMap& map);

}  // namespace offing::terrain

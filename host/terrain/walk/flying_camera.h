#pragma once

#include "host/base/camera.h"
#include "host/terrain/walk/eye_place.h"

namespace offing::terrain {

/// Over the middle of the southern edge, 300 m above the highest post, looking north and 15 degrees down.
/// Field of view and size are a Camera's own.
Camera flying_camera(const TerrainExtent& extent);

}  // namespace offing::terrain

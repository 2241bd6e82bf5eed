#pragma once

#include "host/base/camera.h"
#include "host/base/height_map.h"

namespace offing::terrain {

/// The box of a ground whose first post is at x = z = 0.
struct TerrainExtent {
  double width_m = 0.0, depth_m = 0.0;  ///< along x and z
  double highest_m = 0.0;
};

TerrainExtent extent_of(const HeightMap& map);

/// Over the middle of the southern edge, 300 m above the highest post, looking north and 15 degrees down.
/// Field of view and size are a Camera's own.
Camera flying_camera(const TerrainExtent& extent);

}  // namespace offing::terrain

#pragma once

#include <functional>
#include <string_view>

#include <glm/vec2.hpp>

#include "host/base/camera.h"
#include "host/base/height_map.h"
#include "host/base/numbers/degrees.h"
#include "host/terrain/field/terrain_posts.h"
#include "host/terrain/tiles/tiled_field.h"
#include "host/terrain/walk/eye_place.h"

namespace offing::cli {

/// What a camera needs to know of the ground that it stands on, whose first post is at x = z = 0.
struct CameraTerrain {
  terrain::TerrainExtent extent;
  std::function<terrain::TerrainPoint(double x_m, double z_m)> under;
  bool ends = true;  ///< at its edges
  /// (x_m, z_m) of a place, where cameras are given as east, north and height in another system.
  std::function<glm::dvec2(const glm::dvec2& place)> on_map = {};
};

/// Those of a map and of a field, which must live as long.
CameraTerrain camera_terrain(const HeightMap& map);
CameraTerrain camera_terrain(terrain::TiledField& field);

/// Where a camera of `--camera` stands: "fly" (over the middle of the southern edge, 300 m above the highest
/// post, looking north and 15 degrees down), "walk" (on the ground in the middle of the map, 1.7 m high,
/// looking where it falls) or "X,Y,Z,YAW_DEG,PITCH_DEG", with on_map "X,Y,HEIGHT,YAW_DEG,PITCH_DEG". Throws
/// Error(bad_usage) for anything else.
Camera read_terrain_camera(std::string_view text, const CameraTerrain& terrain);

/// Lifts a camera whose eye is in the ground to a walker's height, and warns of that and of one off the map.
void keep_above_ground(Camera& camera, const CameraTerrain& terrain);

/// `--size WxH`, the pixels of a camera. Throws Error(bad_usage) for anything else.
void read_image_size(std::string_view text, Camera& camera);

}  // namespace offing::cli

#pragma once

#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <glm/vec2.hpp>

#include "host/base/height_map.h"

namespace offing {

/// The systems that places on a map may be given in, beside those that PROJ knows.
inline constexpr const char* local_places = "local";    ///< m east and south of the map's first post
inline constexpr const char* map_places = "map";        ///< the map's own coordinates
inline constexpr const char* lonlat_places = "lonlat";  ///< WGS 84, degrees

/// Where a map lies, without its heights.
struct MapFrame {
  std::string file;  ///< for messages
  int columns = 0, rows = 0;
  double spacing_x_m = 1.0, spacing_z_m = 1.0;
  Georeference georeference;  ///< step 0 where the map has none
};

inline MapFrame frame_of(std::string file, const HeightMap& map) {
  return {std::move(file), map.columns, map.rows, map.spacing_x_m, map.spacing_z_m, map.georeference};
}

/// The ways between the coordinates of a system and places on a map. Coordinates are ordered east before
/// north, and so longitude before latitude, whatever order the system itself names. Longitudes may be counted
/// from -180 or from 0. GDAL and PROJ transform.
///
/// The map's own coordinates count posts exactly, so that they are right on a map whose spacing in m is that
/// of its middle row. Not safe for use from several threads at once.
class MapCoordinates {
 public:
  MapCoordinates() = default;
  MapCoordinates(const MapCoordinates&) = delete;
  MapCoordinates& operator=(const MapCoordinates&) = delete;
  virtual ~MapCoordinates() = default;

  /// WKT of the system; empty where there is none.
  virtual const std::string& coordinate_system() const = 0;
  /// Places (x, z) in m from the map's first post; NaN where the map's system has no such place. Those that
  /// are beyond an edge by less than 1e-6 of a post are on it: that much is rounding.
  virtual std::vector<glm::dvec2> to_local(std::span<const glm::dvec2> places) const = 0;
  /// The same way back; NaN where the system has no such place.
  virtual std::vector<glm::dvec2> from_local(std::span<const glm::dvec2> places_m) const = 0;
};

/// `system` is one of the words above, WKT, "EPSG:n" or another text that PROJ understands. Throws
/// Error(bad_input) that names `flag` for an unknown system, and one that names the map if it does not say
/// where it lies in the world: with `flag` and `system`, unless `flag` is empty.
std::unique_ptr<MapCoordinates> map_coordinates(const MapFrame& map, const std::string& system,
                                                const std::string& flag = "--crs");

}  // namespace offing

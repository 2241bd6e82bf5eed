#pragma once

#include <filesystem>
#include <string>

#include "host/io/height_maps/source_heights.h"

namespace offing::height_maps {

/// A place on WGS 84.
struct GeographicPlace {
  double latitude_deg = 0.0, longitude_deg = 0.0;
};

/// What a coordinate system counts in.
struct CoordinateUnits {
  std::string name;
  bool is_geographic = false;
  bool is_mercator = false;     ///< Web Mercator too: its metres are longer than those of the ground
  double metres_a_unit = 1.0;   ///< of others than geographic ones
  double degrees_a_unit = 1.0;  ///< of geographic ones
  double equatorial_radius_m = 0.0, flattening = 0.0;  ///< of geographic ones
};

/// Throws Error(bad_input) for a system that cannot be understood.
CoordinateUnits coordinate_units(const std::filesystem::path& path, const std::string& coordinate_system);

/// WGS 84 of a place in a coordinate system; none where there is no way between the two.
std::optional<GeographicPlace> geographic_place(const std::string& coordinate_system, double x, double y);

/// The heights resampled (bilinear, square cells of about the spacing there was) to another coordinate system
/// in metres: "utm", the zone of the map's centre, or a text that PROJ understands. Posts outside the source
/// are voids. Throws Error(bad_input) if the source has no coordinate system, or the other is unknown or
/// counts in degrees.
SourceHeights reproject(const std::filesystem::path& path, const SourceHeights& source,
                        const std::string& target);

}  // namespace offing::height_maps

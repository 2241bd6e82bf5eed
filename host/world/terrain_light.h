#pragma once

#include "host/sky/atmosphere.h"
#include "host/sky/clear_sky.h"
#include "host/terrain/cast/relief_surface.h"
#include "host/terrain/shading/materials.h"
#include "kernels/shared/terrain_light_params.h"

namespace offing::world {

/// Heights at which the ground's cover changes, m above the sea.
struct CoverLines {
  double sea_level_m = 0.0;     ///< ground at or below is water
  double beach_line_m = -1e30;  ///< ground below is sand
  double tree_line_m = 2000.0;
  double snow_line_m = 2800.0;

  bool operator==(const CoverLines&) const = default;
};

/// A rule of thumb for the lines of a latitude: snow lies all year from 5000 m on within 25 degrees of the
/// equator and down to the sea at 75, evenly falling between; trees end 800 m lower. Dry and wet mountains
/// are off by up to 1 km.
CoverLines cover_lines(double latitude_deg);

/// The lines of a landscape.
terrain::LandscapeLines landscape_lines(const CoverLines& lines);

/// Relief of ground with these lines.
terrain::ReliefSettings relief_of(const CoverLines& lines, double strength);

/// The light at the eye as terrain kernels take it, with air that is as dense at `sea_level_m` as an
/// atmosphere is at the sea.
TerrainLight terrain_light(const sky::Illuminance& light, const sky::Atmosphere& atmosphere,
                           const CoverLines& lines, double sea_level_m);

}  // namespace offing::world

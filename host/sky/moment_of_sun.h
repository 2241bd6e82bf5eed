#pragma once

#include <optional>

#include "host/base/utc_time.h"
#include "host/sky/sun_position.h"

namespace offing::sky {

/// The sun at a moment, as all places of the Earth see it.
struct MomentOfSun {
  ApparentSun sun;
  double sidereal_time_rad = 0.0;  ///< apparent, at Greenwich
};

/// Throws what julian_date() throws.
MomentOfSun sun_at(const UtcTime& time);

/// sun_position() of many places at one moment.
SunPosition sun_position(const MomentOfSun& moment, const GeoPosition& position,
                         const std::optional<Air>& air = std::nullopt);

/// How far air lifts a true elevation (Saemundsson 1986 in Meeus eq. 16.4); below -1 degree it fades.
double refraction_rad(double true_elevation_rad, const Air& air);

}  // namespace offing::sky

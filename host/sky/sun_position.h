#pragma once

#include <array>
#include <optional>

#include "host/base/utc_time.h"

namespace offing::sky {

/// Days since noon of 1 January 4713 BC, UTC. Meeus, Astronomical Algorithms, 2nd ed. 1998, chapter 7.
/// Throws Error(bad_input) unless the time exists and lies in the years 1900 ... 2100.
double julian_date(const UtcTime& time);

/// The sun as seen from the middle of the Earth, referred to the true equator and equinox of the date.
struct ApparentSun {
  double ecliptic_longitude_rad = 0.0;  ///< 0 ... 2 pi
  double right_ascension_rad = 0.0;     ///< 0 ... 2 pi
  double declination_rad = 0.0;
  double distance_au = 1.0;
};

/// Meeus 1998, chapter 25, the method "of low accuracy": 0.01 degrees. The day is of terrestrial time.
ApparentSun apparent_sun(double julian_ephemeris_day);

/// Where somebody stands. Height is not asked: it moves the sun by less than 0.0001 degrees.
struct GeoPosition {
  double latitude_rad = 0.0;   ///< north positive
  double longitude_rad = 0.0;  ///< east positive
};

/// Air at the eye, which lifts the sun by refraction.
struct Air {
  double pressure_pa = 101'000.0;
  double temperature_k = 283.15;
};

/// Where the sun stands in the sky.
struct SunAngles {
  double azimuth_rad = 0.0;    ///< clockwise from north
  double elevation_rad = 0.0;  ///< above the horizon
};

/// The sun of a world.
struct Sun {
  std::array<double, 3> sun_direction{0.0, 1.0, 0.0};  ///< unit, toward the sun; x east, y up, z south
  double sun_distance_au = 1.0;                        ///< light falls off with its square

  bool operator==(const Sun&) const = default;
};

/// Where the sun stands. The world's axes are those of the whole project: x east, y up, z south (north is
/// -z).
struct SunPosition {
  double azimuth_rad = 0.0;                        ///< clockwise from north, 0 ... 2 pi
  double elevation_rad = 0.0;                      ///< above the horizon of a plane through the eye
  double distance_au = 1.0;                        ///< light falls off with its square
  std::array<double, 3> direction{0.0, 1.0, 0.0};  ///< unit vector toward the sun
};

/// Unit vector (x east, y up, z south) of an azimuth, clockwise from north, and an elevation.
std::array<double, 3> direction_of(double azimuth_rad, double elevation_rad);

/// The middle of the sun's disc, for an eye on the ground; with `air`, lifted by refraction (Saemundsson 1986
/// in Meeus eq. 16.4, to 0.1 minutes of arc above the horizon). Within 0.01 degrees without refraction
/// (tests/sky/sun_position_test.cpp).
/// Throws Error(bad_input) as julian_date() does, and unless latitude is within +-pi/2, longitude within +-2
/// pi, pressure within 0 ... 120 kPa and temperature within 150 ... 350 K.
SunPosition sun_position(const UtcTime& time, const GeoPosition& position,
                         const std::optional<Air>& air = std::nullopt);

/// The sun at a moment, as all places of the Earth see it.
struct MomentOfSun {
  ApparentSun sun;
  double sidereal_time_rad = 0.0;  ///< apparent, at Greenwich
};

/// Throws what julian_date() throws.
MomentOfSun sun_at(const UtcTime& time);

/// sun_position() of many places at one moment.
SunPosition sun_position_at(const MomentOfSun& moment, const GeoPosition& position,
                            const std::optional<Air>& air = std::nullopt);

/// How far air lifts a true elevation (Saemundsson 1986 in Meeus eq. 16.4); below -1 degree it fades.
double refraction_rad(double true_elevation_rad, const Air& air);

}  // namespace offing::sky

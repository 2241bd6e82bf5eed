#include "host/sky/sun_position.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "host/base/error.h"
#include "host/base/parameter_check.h"

namespace offing::sky {
namespace {

using std::numbers::pi;
constexpr double j2000 = 2451545.0;
constexpr double unix_epoch = 2440587.5;  // the Julian date of 1970-01-01T00:00Z
constexpr double days_per_century = 36525.0;
constexpr double seconds_per_day = 86400.0;
// Terrestrial minus universal time: 69 s today, -3 s in 1900, some 200 s (forecast) in 2100. The sun moves a
// degree a day along the ecliptic, so that one value serves all these years within 0.0015 degrees.
constexpr double terrestrial_minus_utc_s = 69.0;
constexpr double solar_parallax_deg = 8.794 / 3600.0;

double radians(double degrees) {
  return degrees * pi / 180.0;
}

double degrees(double radians) {
  return radians * 180.0 / pi;
}

double turn(double angle_rad) {
  const double rest = std::fmod(angle_rad, 2.0 * pi);
  return rest < 0.0 ? rest + 2.0 * pi : rest;
}

void require_valid(const UtcTime& time) {
  if (is_valid(time) && time.year >= 1900 && time.year <= 2100 && time.hour < 24) return;
  throw Error(ErrorKind::bad_input,
              fmt::format("time: expected a date and time of the years 1900 to 2100, found "
                          "{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z",
                          time.year, time.month, time.day, time.hour, time.minute, time.second),
              "give UTC as year-month-day hour:minute:second");
}

double centuries_since_j2000(double julian_day) {
  return (julian_day - j2000) / days_per_century;
}

// Longitude of the Moon's ascending node, which sets the pace of nutation. Meeus, chapter 25.
double node_rad(double centuries) {
  return radians(125.04 - 1934.136 * centuries);
}

// Nutation in longitude, its largest term. Meeus, chapter 25.
double nutation_rad(double centuries) {
  return radians(-0.00478 * std::sin(node_rad(centuries)));
}

// Obliquity of the ecliptic of the date. Meeus eq. 22.2 and 25.8.
double obliquity_rad(double centuries) {
  const double t = centuries;
  const double mean_deg =
      23.0 + 26.0 / 60.0 + (21.448 - 46.8150 * t - 0.00059 * t * t + 0.001813 * t * t * t) / 3600.0;
  return radians(mean_deg + 0.00256 * std::cos(node_rad(t)));
}

// Apparent sidereal time at Greenwich; the day is of universal time. Meeus eq. 12.4.
double sidereal_time_rad(double julian_day) {
  const double t = centuries_since_j2000(julian_day);
  const double mean_deg =
      280.46061837 + 360.98564736629 * (julian_day - j2000) + 0.000387933 * t * t - t * t * t / 38'710'000.0;
  return radians(std::fmod(mean_deg, 360.0)) + nutation_rad(t) * std::cos(obliquity_rad(t));
}

}  // namespace

double julian_date(const UtcTime& time) {
  require_valid(time);
  return unix_epoch + static_cast<double>(unix_seconds(time)) / seconds_per_day;
}

ApparentSun apparent_sun(double julian_ephemeris_day) {
  const double t = centuries_since_j2000(julian_ephemeris_day);
  const double mean_longitude_deg = 280.46646 + 36000.76983 * t + 0.0003032 * t * t;
  const double anomaly = radians(std::fmod(357.52911 + 35999.05029 * t - 0.0001537 * t * t, 360.0));
  const double eccentricity = 0.016708634 - 0.000042037 * t - 0.0000001267 * t * t;
  const double centre_deg = (1.914602 - 0.004817 * t - 0.000014 * t * t) * std::sin(anomaly) +
                            (0.019993 - 0.000101 * t) * std::sin(2.0 * anomaly) +
                            0.000289 * std::sin(3.0 * anomaly);
  constexpr double aberration_deg = -0.00569;
  const double longitude = radians(mean_longitude_deg + centre_deg + aberration_deg) + nutation_rad(t);
  const double obliquity = obliquity_rad(t);

  const double true_anomaly = anomaly + radians(centre_deg);
  return {
      .ecliptic_longitude_rad = turn(longitude),
      .right_ascension_rad = turn(std::atan2(std::cos(obliquity) * std::sin(longitude), std::cos(longitude))),
      .declination_rad = std::asin(std::sin(obliquity) * std::sin(longitude)),
      .distance_au =
          1.000001018 * (1.0 - eccentricity * eccentricity) / (1.0 + eccentricity * std::cos(true_anomaly))};
}

// How far air lifts a true elevation. Meeus eq. 16.4, which holds down to the horizon and has a pole at -5
// degrees; from -1 degrees on, its value there falls off as 1 / tan.
double refraction_rad(double true_elevation_rad, const Air& air) {
  const double elevation_deg = std::max(degrees(true_elevation_rad), -1.0);
  const double minutes = 1.02 / std::tan(radians(elevation_deg + 10.3 / (elevation_deg + 5.11)));
  const double density = air.pressure_pa / 101'000.0 * 283.0 / air.temperature_k;
  const double fade = true_elevation_rad < radians(-1.0)
                          ? std::tan(radians(1.0)) / std::abs(std::tan(true_elevation_rad))
                          : 1.0;
  // The formula passes through zero just short of the zenith.
  return radians(std::max(0.0, minutes) / 60.0) * density * std::min(fade, 1.0);
}

std::array<double, 3> direction_of(double azimuth_rad, double elevation_rad) {
  const double level = std::cos(elevation_rad);
  return {level * std::sin(azimuth_rad), std::sin(elevation_rad), -level * std::cos(azimuth_rad)};
}

MomentOfSun sun_at(const UtcTime& time) {
  const double day = julian_date(time);
  return {apparent_sun(day + terrestrial_minus_utc_s / seconds_per_day), sidereal_time_rad(day)};
}

SunPosition sun_position(const UtcTime& time, const GeoPosition& position, const std::optional<Air>& air) {
  return sun_position_at(sun_at(time), position, air);
}

SunPosition sun_position_at(const MomentOfSun& moment, const GeoPosition& position,
                            const std::optional<Air>& air) {
  require_within("position.latitude_rad", position.latitude_rad, -0.5 * pi, 0.5 * pi);
  require_within("position.longitude_rad", position.longitude_rad, -2.0 * pi, 2.0 * pi);
  if (air) {
    require_within("air.pressure_pa", air->pressure_pa, 0.0, 120e3);
    require_within("air.temperature_k", air->temperature_k, 150.0, 350.0);
  }
  const ApparentSun& sun = moment.sun;
  const double hour_angle = moment.sidereal_time_rad + position.longitude_rad - sun.right_ascension_rad;

  // The sun in the horizon's frame; atan2 of both sides stays exact at zenith and poles.
  const double sin_latitude = std::sin(position.latitude_rad), cos_latitude = std::cos(position.latitude_rad);
  const double sin_declination = std::sin(sun.declination_rad),
               cos_declination = std::cos(sun.declination_rad);
  const double east = -cos_declination * std::sin(hour_angle);
  const double north = sin_declination * cos_latitude - cos_declination * std::cos(hour_angle) * sin_latitude;
  const double up = sin_declination * sin_latitude + cos_declination * std::cos(hour_angle) * cos_latitude;

  double elevation = std::atan2(up, std::hypot(east, north));
  elevation -= radians(solar_parallax_deg) * std::cos(elevation);
  if (air) elevation += refraction_rad(elevation, *air);
  const double azimuth = turn(std::atan2(east, north));
  return {.azimuth_rad = azimuth,
          .elevation_rad = elevation,
          .distance_au = sun.distance_au,
          .direction = direction_of(azimuth, elevation)};
}

}  // namespace offing::sky

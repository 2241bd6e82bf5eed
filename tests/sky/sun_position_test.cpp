// The sun's place against printed almanac values. The method promises 0.01 degrees.
#include "host/sky/sun_position.h"

#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "tests/ocl/expect_error.h"

namespace offing::sky {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

// Fails if a term of the series is mistyped. Meeus 1998, example 25.a: 1992 October 13 at 0h TD. Printed to
// 0.1 s of time, 1" and 1e-5 au: gates are half of the last digits.
TEST(SunPositionTest, MeeusExample25a) {
  const double day = julian_date({.year = 1992, .month = 10, .day = 13, .hour = 0});
  EXPECT_DOUBLE_EQ(day, 2448908.5);
  const ApparentSun sun = apparent_sun(day);
  EXPECT_NEAR(sun.right_ascension_rad / degree / 15.0 * 3600.0, 13 * 3600 + 13 * 60 + 31.4, 0.05);
  EXPECT_NEAR(sun.declination_rad / degree * 3600.0, -(7 * 3600 + 47 * 60 + 6), 0.5);
  EXPECT_NEAR(sun.ecliptic_longitude_rad / degree, 199.90895, 1e-5);  // a sum of rounded terms
  EXPECT_NEAR(sun.distance_au, 0.99766, 5e-6);
}

// Fails if days are counted wrongly. Meeus 1998, chapter 7: values printed there.
TEST(SunPositionTest, JulianDatesOfMeeus) {
  EXPECT_DOUBLE_EQ(julian_date({.year = 2000, .month = 1, .day = 1, .hour = 12}), 2451545.0);
  EXPECT_DOUBLE_EQ(julian_date({.year = 1999, .month = 1, .day = 1, .hour = 0}), 2451179.5);
  EXPECT_DOUBLE_EQ(julian_date({.year = 1987, .month = 1, .day = 27, .hour = 0}), 2446822.5);
  EXPECT_DOUBLE_EQ(julian_date({.year = 1987, .month = 6, .day = 19, .hour = 12}), 2446966.0);
  EXPECT_DOUBLE_EQ(julian_date({.year = 1900, .month = 1, .day = 1, .hour = 0}), 2415020.5);
}

// Fails if hour angle, axes or refraction are wrong. Reda & Andreas 2004 (NREL/TP-560-34302), the worked
// example: 2003-10-17 12:30:30, 7 h behind UTC, 39.742476 N 105.1786 W, 820 hPa, 11 C; elevation without
// refraction 39.872046, zenith 50.11162, azimuth 194.34024 degrees. Bound 0.01; measured 0.003.
TEST(SunPositionTest, ExampleOfTheSolarPositionAlgorithm) {
  const UtcTime time{.year = 2003, .month = 10, .day = 17, .hour = 19, .minute = 30, .second = 30};
  const GeoPosition place{.latitude_rad = 39.742476 * degree, .longitude_rad = -105.1786 * degree};
  EXPECT_NEAR(sun_position(time, place).elevation_rad / degree, 39.872046, 0.01);
  const SunPosition sun =
      sun_position(time, place, Air{.pressure_pa = 82'000.0, .temperature_k = 273.15 + 11.0});
  EXPECT_NEAR(90.0 - sun.elevation_rad / degree, 50.11162, 0.01);
  EXPECT_NEAR(sun.azimuth_rad / degree, 194.34024, 0.01);
  // A little west of south: x east is negative, z south positive.
  EXPECT_NEAR(sun.direction[0], -0.190, 0.001);
  EXPECT_NEAR(sun.direction[1], 0.641, 0.001);
  EXPECT_NEAR(sun.direction[2], 0.743, 0.001);
}

// Fails if the year drifts. Equinoxes and solstices as almanacs print them, to the minute: the sun's
// longitude is then a multiple of 90 degrees. A minute is 0.0007 degrees; the method's error 0.01.
TEST(SunPositionTest, SeasonsOfTheAlmanac) {
  struct Season {
    UtcTime time;
    double longitude_deg;
  };
  const Season seasons[] = {
      {{.year = 2000, .month = 3, .day = 20, .hour = 7, .minute = 35}, 360.0},
      {{.year = 2000, .month = 6, .day = 21, .hour = 1, .minute = 48}, 90.0},
      {{.year = 2000, .month = 9, .day = 22, .hour = 17, .minute = 28}, 180.0},
      {{.year = 2000, .month = 12, .day = 21, .hour = 13, .minute = 37}, 270.0},
      {{.year = 2024, .month = 3, .day = 20, .hour = 3, .minute = 6}, 360.0},
      {{.year = 2024, .month = 6, .day = 20, .hour = 20, .minute = 51}, 90.0},
      {{.year = 2024, .month = 9, .day = 22, .hour = 12, .minute = 44}, 180.0},
      {{.year = 2024, .month = 12, .day = 21, .hour = 9, .minute = 21}, 270.0},
  };
  for (const Season& season : seasons) {
    const ApparentSun sun = apparent_sun(julian_date(season.time) + 69.0 / 86400.0);
    const double difference = sun.ecliptic_longitude_rad / degree - season.longitude_deg;
    EXPECT_NEAR(std::remainder(difference, 360.0), 0.0, 0.01) << season.time.year << "-" << season.time.month;
  }
}

// Fails if east and west, north and south are swapped: on the equator at the equinox the sun rises in the
// east, passes the zenith within the equation of time (7.5 minutes: 1.9 degrees) and sets in the west; at
// solstice noon it stands 23.44 degrees from the zenith, to the north in June.
TEST(SunPositionTest, DirectionsOnTheEquator) {
  const GeoPosition place{};
  const auto at_hour = [&](int month, int day, int hour) {
    return sun_position({.year = 2024, .month = month, .day = day, .hour = hour}, place);
  };
  EXPECT_NEAR(at_hour(3, 20, 7).direction[0], std::cos(15.0 * degree), 0.01);
  EXPECT_NEAR(at_hour(3, 20, 17).direction[0], -std::cos(15.0 * degree), 0.01);
  EXPECT_GT(at_hour(3, 20, 12).elevation_rad, 88.0 * degree);
  EXPECT_NEAR(at_hour(6, 20, 12).direction[2], -std::sin(23.44 * degree), 0.001);
  EXPECT_NEAR(at_hour(12, 21, 12).direction[2], std::sin(23.44 * degree), 0.001);
  EXPECT_NEAR(at_hour(6, 20, 0).elevation_rad, -66.56 * degree, 0.3 * degree);
}

// Fails if latitude's sign is lost: at an equinox the southern hemisphere sees the northern sky mirrored. The
// declination differs from 0 by less than 0.001 degrees, parallax is the same.
TEST(SunPositionTest, HemispheresMirrorEachOtherAtAnEquinox) {
  for (int hour = 0; hour < 24; hour += 3) {
    const UtcTime time{.year = 2024, .month = 3, .day = 20, .hour = 3, .minute = 6};
    const double longitude = hour * 15.0 * degree;
    const SunPosition north = sun_position(time, {.latitude_rad = 0.7, .longitude_rad = longitude});
    const SunPosition south = sun_position(time, {.latitude_rad = -0.7, .longitude_rad = longitude});
    EXPECT_NEAR(north.direction[0], south.direction[0], 1e-4);
    EXPECT_NEAR(north.direction[1], south.direction[1], 1e-4);
    EXPECT_NEAR(north.direction[2], -south.direction[2], 1e-4);
  }
}

// Fails if refraction jumps, grows downward without end, or is off at the horizon: 34' there is the
// almanacs' convention (for an apparent elevation of 0; 29' for a true one), 1' at 45 degrees.
TEST(SunPositionTest, RefractionIsContinuousAndOfTheKnownSize) {
  double previous = 0.0;
  double largest_jump = 0.0, at_horizon = 0.0, at_half = 0.0;
  for (int minute = 0; minute < 24 * 60; ++minute) {
    const UtcTime time{.year = 2024, .month = 3, .day = 20, .hour = minute / 60, .minute = minute % 60};
    const GeoPosition place{.latitude_rad = 0.3};
    const double plain = sun_position(time, place).elevation_rad;
    const double lift = sun_position(time, place, Air{}).elevation_rad - plain;
    EXPECT_GE(lift, 0.0);
    if (minute > 0) largest_jump = std::max(largest_jump, std::abs(lift - previous));
    if (std::abs(plain) < 0.13 * degree) at_horizon = lift;
    if (std::abs(plain - 45.0 * degree) < 0.13 * degree) at_half = lift;
    previous = lift;
  }
  // The sun moves 0.25 degrees a minute; refraction's steepest slope, at -1 degrees, is 0.65.
  EXPECT_LT(largest_jump, 0.65 * 0.25 * degree);
  EXPECT_NEAR(at_horizon * 60.0 / degree, 29.0, 2.0);
  EXPECT_NEAR(at_half * 60.0 / degree, 1.0, 0.05);
}

// Fails if nonsense is computed with instead of refused.
TEST(SunPositionTest, RefusesTimesAndPlacesThatDoNotExist) {
  using test::expect_error;
  for (const UtcTime time :
       {UtcTime{.month = 0}, UtcTime{.month = 13}, UtcTime{.year = 2023, .month = 2, .day = 29},
        UtcTime{.year = 1900, .month = 2, .day = 29}, UtcTime{.month = 4, .day = 31}, UtcTime{.hour = 24},
        UtcTime{.minute = 60}, UtcTime{.second = -1}, UtcTime{.second = 60}, UtcTime{.year = 1899},
        UtcTime{.year = 2101}}) {
    expect_error(ErrorKind::bad_input, "years 1900 to 2100", [&] { julian_date(time); });
  }
  EXPECT_NO_THROW(julian_date({.year = 2000, .month = 2, .day = 29}));
  expect_error(ErrorKind::bad_input, "latitude_rad", [] { sun_position({}, {.latitude_rad = 1.58}); });
  expect_error(ErrorKind::bad_input, "longitude_rad", [] { sun_position({}, {.longitude_rad = 7.0}); });
  expect_error(ErrorKind::bad_input, "pressure_pa", [] { sun_position({}, {}, Air{.pressure_pa = -1.0}); });
}

}  // namespace
}  // namespace offing::sky

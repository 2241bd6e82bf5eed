// Prints where the sun stands, and its light under a clear sky, as JSON: for sun_test.py.
#include <cstdint>
#include <cstdio>
#include <numbers>

#include <nlohmann/json.hpp>

#include "host/base/utc_time.h"
#include "host/sky/direct_sunlight.h"
#include "host/sky/sun_position.h"

int main() {
  using namespace offing;
  constexpr double degree = std::numbers::pi / 180.0;
  nlohmann::json rows;
  const std::int64_t from_s = unix_seconds({.year = 2026, .month = 1, .day = 1, .hour = 0});
  // Moments of all seasons and hours: 11 h 7 min is no part of a day.
  constexpr std::int64_t step_s = 11 * 3600 + 7 * 60, moments = 788;
  for (const double latitude_deg : {-65.0, -32.5, 0.0, 46.5, 70.0}) {
    for (std::int64_t i = 0; i < moments; ++i) {
      const std::int64_t time_s = from_s + i * step_s;
      const double longitude_deg = -170.0 + static_cast<double>(i % 7) * 50.0;
      const sky::GeoPosition place{latitude_deg * degree, longitude_deg * degree};
      const sky::SunPosition sun = sky::sun_position(from_unix_seconds(time_s), place);
      const sky::SunPosition lifted = sky::sun_position(from_unix_seconds(time_s), place, sky::Air{});
      const double height_m = static_cast<double>(i % 5) * 1000.0,
                   turbidity = 2.0 + static_cast<double>(i % 4);
      rows.push_back(
          {time_s, latitude_deg, longitude_deg, sun.azimuth_rad / degree, sun.elevation_rad / degree,
           lifted.elevation_rad / degree, sun.distance_au, height_m, turbidity,
           sky::direct_sunlight_w_per_m2(lifted.elevation_rad, height_m, sun.distance_au, turbidity)});
    }
  }
  std::puts(rows.dump().c_str());
}

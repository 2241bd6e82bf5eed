// Hours of sun and sunlight of maps, against day lengths, integrals in double precision and exact rays.
#include "host/scene/prepare/maps/terrain_sun.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/base/utc_time.h"
#include "tests/ocl/expect_error.h"

namespace offing::scene {
namespace {

using std::numbers::pi;

constexpr double degree = pi / 180.0;
constexpr std::int64_t day_s = 86400;

HeightMap sunny_map(int columns, int rows, double spacing_m,
                    const std::function<double(double, double)>& height_m) {
  HeightMap map{.columns = columns,
                .rows = rows,
                .spacing_x_m = spacing_m,
                .spacing_z_m = spacing_m,
                .heights_m = {},
                .is_void = {},
                .georeference = {}};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      map.heights_m.push_back(static_cast<float>(height_m(column * spacing_m, row * spacing_m)));
    }
  }
  return map;
}

/// Hours and energy [rows][columns].
struct Sunshine {
  std::vector<float> hours, energy_kwh;
};

Sunshine sunshine(const HeightMap& map, const std::optional<sky::GeoPosition>& place,
                  const SunSettings& settings) {
  const ocl::Device device = ocl::Device::open();
  const terrain::HeightField field(device, terrain::post_grid(map), map.heights_m);
  TerrainSun sun(device, field, map, frame_of("map", map), place, settings);
  Sunshine found;
  for (const terrain::RowBand& band : sun.bands()) {
    const auto first = found.hours.size();
    const auto posts = static_cast<std::size_t>(band.rows) * static_cast<std::size_t>(map.columns);
    found.hours.resize(first + posts);
    found.energy_kwh.resize(first + posts);
    sun.read(band, std::span(found.hours).subspan(first), std::span(found.energy_kwh).subspan(first));
  }
  return found;
}

std::int64_t day_of(int year, int month, int day) {
  return unix_seconds({.year = year, .month = month, .day = day, .hour = 0});
}

/// From -0.833 degrees to -0.833 degrees, at the declination of the day's noon.
double day_length_h(std::int64_t noon_s, double latitude_rad) {
  const double declination = sky::sun_at(from_unix_seconds(noon_s)).sun.declination_rad;
  const double cosine = (std::sin(-0.833 * degree) - std::sin(latitude_rad) * std::sin(declination)) /
                        (std::cos(latitude_rad) * std::cos(declination));
  return 24.0 / pi * std::acos(std::clamp(cosine, -1.0, 1.0));
}

// Over level ground the sun shines from -0.833 degrees on, for as long as almanacs say. Between moments its
// height is taken as linear, which is wrong by up to h^2 / 8 of its second derivative: 0.06 h at dawn and at
// dusk for steps of 1 h, 0.002 h for those of 10 min. The declination moves by 0.2 degrees in a day, which is
// 0.01 h. Fails if sunrise is where a moment is, refraction or the sun's disc is left out, or a day is lost.
TEST(TerrainSunTest, LevelGroundHasTheLengthOfTheDay) {
  const HeightMap map = sunny_map(40, 3, 30.0, [](double, double) { return 250.0; });
  for (const double latitude_deg : {46.5, -33.0, 0.0, 60.0}) {
    for (const auto& [month, day] : {std::pair{3, 20}, {6, 21}, {12, 21}, {2, 7}}) {
      const std::int64_t from_s = day_of(2026, month, day);
      const double length_h = day_length_h(from_s + day_s / 2, latitude_deg * degree);
      for (const auto& [step_s, gate_h] : {std::pair{3600, 0.2}, {600, 0.03}}) {
        const Sunshine found = sunshine(map, sky::GeoPosition{latitude_deg * degree, 0.0},
                                        {.from_s = from_s, .to_s = from_s + day_s, .step_s = step_s});
        for (const float hours : found.hours) {
          ASSERT_NEAR(static_cast<double>(hours), length_h, gate_h)
              << latitude_deg << ", " << month << '-' << day << ", " << step_s;
        }
      }
    }
  }
}

// Night without end is 0, day without end 24 h. Fails if a map without moments is not written.
TEST(TerrainSunTest, PolarNightAndDay) {
  const HeightMap map = sunny_map(20, 70, 30.0, [](double, double) { return 0.0; });
  const auto hours_of = [&](int month) {
    const std::int64_t from_s = day_of(2026, month, 21);
    return sunshine(map, sky::GeoPosition{80.0 * degree, 0.3}, {.from_s = from_s, .to_s = from_s + day_s})
        .hours;
  };
  for (const float hours : hours_of(12)) ASSERT_EQ(hours, 0.0f);
  for (const float hours : hours_of(6)) ASSERT_NEAR(hours, 24.0f, 1e-4f);
}

/// kWh a square metre of a plane that rises by (slope_x, slope_z), by steps of a minute.
double plane_energy_kwh(const sky::GeoPosition& place, const SunSettings& settings, double slope_x,
                        double slope_z, double height_m) {
  const double up = 1.0 / std::sqrt(1.0 + slope_x * slope_x + slope_z * slope_z);
  double sum_kwh = 0.0;
  constexpr int step_s = 60;
  for (std::int64_t time_s = settings.from_s + step_s / 2; time_s < settings.to_s; time_s += step_s) {
    const sky::SunPosition sun = sky::sun_position(from_unix_seconds(time_s), place, sky::Air{});
    const double cosine = up * (sun.direction[1] - slope_x * sun.direction[0] - slope_z * sun.direction[2]);
    sum_kwh +=
        std::max(cosine, 0.0) * step_s / 3.6e6 *
        sky::direct_sunlight_w_per_m2(sun.elevation_rad, height_m, sun.distance_au, settings.linke_turbidity);
  }
  return sum_kwh;
}

// Planes that face all ways, at solstices and an equinox, with steps of 15 min, against sums over minutes of
// the same model: within 1 %; in all, of a year with steps of 1 h too. Measured 0.07 % and 0.42 %. Fails if a
// direction is swapped, the cosine is not to the ground's normal, light of before sunrise counts, or heights
// do not.
TEST(TerrainSunTest, TiltedPlanesGetTheIntegralOfTheModel) {
  const sky::GeoPosition place{46.5 * degree, 8.0 * degree};
  for (const auto& [slope_x, slope_z] :
       {std::pair{0.0, 0.0}, {0.5, 0.0}, {-0.5, 0.0}, {0.0, 0.6}, {0.0, -0.6}, {0.7, -0.7}, {-0.2, -0.3}}) {
    const HeightMap map = sunny_map(48, 48, 20.0, [x_rise = slope_x, z_rise = slope_z](double x, double z) {
      return 1500.0 + x_rise * (x - 480.0) + z_rise * (z - 480.0);
    });
    const std::size_t middle = 48 * 24 + 24;
    for (const auto& [month, day] : {std::pair{3, 20}, {6, 21}, {12, 21}}) {
      const std::int64_t from_s = day_of(2026, month, day);
      const SunSettings settings{
          .from_s = from_s, .to_s = from_s + day_s, .step_s = 900, .linke_turbidity = 2.5};
      const double expected = plane_energy_kwh(place, settings, slope_x, slope_z, 1500.0);
      const double found = static_cast<double>(sunshine(map, place, settings).energy_kwh[middle]);
      EXPECT_NEAR(found, expected, 0.01 * std::max(expected, 0.2))
          << slope_x << ' ' << slope_z << ' ' << month;
    }
    const std::int64_t from_s = day_of(2025, 1, 1);
    const SunSettings year{.from_s = from_s, .to_s = from_s + 365 * day_s};
    const double expected = plane_energy_kwh(place, year, slope_x, slope_z, 1500.0);
    EXPECT_NEAR(sunshine(map, place, year).energy_kwh[middle] / expected, 1.0, 0.01)
        << slope_x << ' ' << slope_z;
  }
}

HeightMap map_in(const char* system, double x, double y, double step) {
  HeightMap map = sunny_map(33, 33, 30.0, [](double, double) { return 0.0; });
  map.georeference = {system, x, y, step, -step};
  return map;
}

// Meridian convergence of UTM: tan of it is that of the longitude from the zone's middle times the sine of
// the latitude, to 0.01 degrees at 2.5 degrees (the next term is 5e-4 of it). Systems whose meridians run
// north have none. Fails if directions are not turned, or the wrong way round.
TEST(TerrainSunTest, KnowsHowMapsLie) {
  const glm::dvec2 place_m(480.0, 480.0);
  const auto place_on = [&](const HeightMap& map) {
    return sun_places(frame_of("map", map), std::span(&place_m, 1))[0];
  };
  const SunPlace utm = place_on(map_in("EPSG:32632", 700000.0, 5200000.0, 30.0));
  const double convergence =
      std::atan(std::tan(utm.position.longitude_rad - 9.0 * degree) * std::sin(utm.position.latitude_rad));
  EXPECT_GT(convergence, 1.5 * degree);
  EXPECT_NEAR(utm.north_rad, convergence, 0.01 * degree);
  const SunPlace south = place_on(map_in("EPSG:32719", 700000.0, 6400000.0, 30.0));
  EXPECT_NEAR(south.position.latitude_rad / degree, -32.5, 0.2);
  EXPECT_LT(south.north_rad, -1.0 * degree);
  EXPECT_NEAR(place_on(map_in("EPSG:3857", 900000.0, 5800000.0, 40.0)).north_rad, 0.0, 1e-4 * degree);
  const SunPlace degrees = place_on(map_in("EPSG:4326", 8.0, 46.5, 0.0003));
  EXPECT_NEAR(degrees.north_rad, 0.0, 1e-4 * degree);
  EXPECT_NEAR(degrees.position.longitude_rad, (8.0 + 16 * 0.0003) * degree, 1e-9);
  test::expect_error(ErrorKind::bad_input, "map",
                     [&] { place_on(sunny_map(9, 9, 30.0, [](double, double) { return 0.0; })); });
}

// Masks against exact rays to the sun's edge, whose azimuth is turned by the convergence. Horizons are 0.001
// too low at most and linear between 64 azimuths: of posts and moments less than 1 % may differ; measured
// 0.44 %. Without the turn of 1.8 degrees 1.6 % differ. Fails if directions are not turned, a horizon is
// taken for another, or blocks are shifted.
TEST(TerrainSunTest, MasksAreThoseOfExactRays) {
  HeightMap map = sunny_map(150, 90, 30.0, [](double x, double z) {
    return 300.0 * std::sin(0.0041 * x + 0.3 * std::sin(0.003 * z)) * std::cos(0.0037 * z) +
           60.0 * std::sin(0.013 * x) * std::sin(0.011 * z);
  });
  map.georeference = {"EPSG:32632", 700000.0, 5200000.0, 30.0, -30.0};
  const ocl::Device device = ocl::Device::open();
  terrain::HeightField field(device, terrain::post_grid(map), map.heights_m);
  const MapFrame frame = frame_of("map", map);
  const std::int64_t from_s = day_of(2026, 2, 10);
  TerrainSun sun(device, field, map, frame, std::nullopt,
                 {.from_s = from_s, .to_s = from_s + day_s, .step_s = 1200});
  std::size_t tested = 0, wrong = 0, lit_rays = 0;
  std::mt19937 random(3);
  for (const terrain::RowBand& band : sun.bands()) {
    const auto posts = static_cast<std::size_t>(150 * band.rows);
    std::vector<float> hours(posts), energy(posts);
    sun.read(band, hours, energy);
    std::vector<std::uint8_t> lit(posts);
    for (std::size_t number = 0; number < sun.up_s().size(); ++number) {
      sun.read_mask(band, number, lit);
      std::vector<terrain::Ray> rays;
      std::vector<std::size_t> looked_at;
      for (int i = 0; i < 200; ++i) {
        const std::size_t post = random() % posts;
        const int column = static_cast<int>(post % 150), row = band.first_row + static_cast<int>(post / 150);
        const glm::dvec2 place_m(30.0 * column, 30.0 * row);
        const SunPlace place = sun_places(frame, std::span(&place_m, 1))[0];
        const sky::SunPosition seen =
            sky::sun_position(from_unix_seconds(sun.up_s()[number]), place.position);
        double edge_rad = seen.elevation_rad + 0.26656 * degree / seen.distance_au;
        edge_rad += sky::refraction_rad(edge_rad, {});
        const auto direction = sky::direction_of(seen.azimuth_rad - place.north_rad, edge_rad);
        if (edge_rad <= 0.0) continue;
        const double height_m = static_cast<double>(map.heights_m[map.index(column, row)]);
        rays.push_back({.origin_m = {place_m.x, height_m + 0.03, place_m.y},
                        .direction = {direction[0], direction[1], direction[2]}});
        looked_at.push_back(post);
      }
      const std::vector<terrain::RayHit> hits = field.cast(rays);
      for (std::size_t i = 0; i < hits.size(); ++i) {
        const bool is_lit = hits[i].kind == TERRAIN_MISS;
        ++tested;
        lit_rays += is_lit ? 1 : 0;
        wrong += is_lit != (lit[looked_at[i]] == 255) ? 1 : 0;
      }
    }
  }
  EXPECT_GT(tested, 10000u);
  EXPECT_GT(lit_rays, tested / 3);
  EXPECT_LT(lit_rays, tested * 9 / 10);
  EXPECT_LT(static_cast<double>(wrong) / static_cast<double>(tested), 0.01);
}

// Fails if settings that cannot be are computed with.
TEST(TerrainSunTest, RefusesWhatCannotBe) {
  const SunSettings good{.from_s = 0, .to_s = day_s};
  EXPECT_NO_THROW(require_valid(good));
  const auto refuse = [&](const char* expected, const std::function<void(SunSettings&)>& change) {
    SunSettings bad = good;
    change(bad);
    test::expect_error(ErrorKind::bad_input, expected, [&] { require_valid(bad); });
  };
  refuse("step_s", [](SunSettings& bad) { bad.step_s = 0; });
  refuse("after the start", [](SunSettings& bad) { bad.to_s = 0; });
  refuse("years 1900 to 2100", [](SunSettings& bad) { bad.to_s = 5'000'000'000; });
  refuse("years 1900 to 2100",
         [](SunSettings& bad) { bad.from_s = std::numeric_limits<std::int64_t>::min(); });
  refuse("100000 steps", [](SunSettings& bad) { bad.to_s = 400'000'000; });
  refuse("turbidity", [](SunSettings& bad) { bad.linke_turbidity = 0.5; });
  refuse("azimuths", [](SunSettings& bad) { bad.azimuths = 3; });
  refuse("refraction", [](SunSettings& bad) { bad.curve = {6e6, 2.0}; });
}

}  // namespace
}  // namespace offing::scene

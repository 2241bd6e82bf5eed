#include "host/cli/pictures/sea_map.h"

#include <cmath>
#include <cstddef>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"

namespace offing::cli {
namespace {

constexpr double hs_m = 2.0;

/// Heights that all are zero, or those of a wave along +x with so many crests over the patch.
ocean::SurfaceFields sea_of(int size, int crests = 0, double amplitude_m = 1.0) {
  const std::vector<float> zeros(static_cast<std::size_t>(size) * size);
  ocean::SurfaceFields fields{size, zeros, zeros, zeros, zeros, zeros, zeros, zeros, zeros, zeros, zeros};
  for (std::size_t i = 0; crests > 0 && i < zeros.size(); ++i) {
    const double phase_rad = 2.0 * std::numbers::pi * crests * static_cast<double>(i % size) / size;
    fields.displacement_y[i] = static_cast<float>(amplitude_m * std::cos(phase_rad));
  }
  return fields;
}

RgbImage map_of(const ocean::SurfaceFields& fields, double patch_m,
                const ocean::GerstnerInstant& waves = {{}, 0.0}, const std::vector<float>& foam = {}) {
  const SeaMapCascade cascade{patch_m, &fields, foam};
  return draw_sea_map({&cascade, 1}, waves, hs_m);
}

double brightness(const RgbImage& map, int column, int row) {
  const std::uint8_t* const pixel = &map.rgb[3 * (static_cast<std::size_t>(row) * map.width + column)];
  return pixel[0] + pixel[1] + pixel[2];
}

double mean_brightness(const RgbImage& map) {
  double sum = 0.0;
  for (const std::uint8_t value : map.rgb) sum += value;
  return 3.0 * sum / static_cast<double>(map.rgb.size());
}

/// Amplitude of the component with so many periods across the map, along a row.
double share_of(const RgbImage& map, int periods) {
  double cosine = 0.0, sine = 0.0;
  for (int column = 0; column < map.width; ++column) {
    const double phase_rad = 2.0 * std::numbers::pi * periods * column / map.width;
    cosine += brightness(map, column, map.height / 2) * std::cos(phase_rad);
    sine += brightness(map, column, map.height / 2) * std::sin(phase_rad);
  }
  return std::hypot(cosine, sine) / map.width;
}

// Fails if heights do not stand where they are: of 5 crests the fifth harmonic must dominate all its
// neighbours.
TEST(SeaMap, ShowsTheCrestsOfAWave) {
  const RgbImage map = map_of(sea_of(256, 5), 500.0);
  for (const int other : {1, 2, 3, 4, 6, 7})
    EXPECT_GT(share_of(map, 5), 10.0 * share_of(map, other)) << other;
}

// Fails if light does not come from the left (x < 0): the face that rises toward +x looks at it.
TEST(SeaMap, IsLitFromTheLeft) {
  const RgbImage map = map_of(sea_of(256, 1), 20.0);
  EXPECT_GT(brightness(map, 256 * 3 / 4, 100), brightness(map, 256 / 4, 100) + 30.0);
}

// Fails if a shorter cascade is drawn at the wrong scale: its patch of 25 m repeats 20 times over 500 m.
TEST(SeaMap, RepeatsShorterCascades) {
  const ocean::SurfaceFields still = sea_of(256), waves = sea_of(256, 1);
  const std::vector<SeaMapCascade> cascades{{500.0, &still, {}}, {25.0, &waves, {}}};
  const RgbImage map = draw_sea_map(cascades, {{}, 0.0}, hs_m);
  EXPECT_GT(share_of(map, 20), 10.0 * share_of(map, 10));
  EXPECT_GT(share_of(map, 20), 10.0 * share_of(map, 19));
}

// Fails if waves shorter than a pixel turn into a pattern (moire): the map of still water has one colour,
// give or take the dither of one step.
TEST(SeaMap, AveragesWavesShorterThanAPixel) {
  const ocean::SurfaceFields still = sea_of(256), waves = sea_of(256, 64);
  const std::vector<SeaMapCascade> cascades{{500.0, &still, {}}, {3.0, &waves, {}}};
  const RgbImage map = draw_sea_map(cascades, {{}, 0.0}, hs_m);
  for (int column = 0; column < map.width; ++column)
    EXPECT_NEAR(brightness(map, column, 7), mean_brightness(map), 4.0);
}

// Fails if long waves are left out, or stand elsewhere than GerstnerInstant says. The gate is a step of a
// byte in each colour: both maps are made of the same heights, rounded otherwise.
TEST(SeaMap, HasTheLongWaves) {
  ocean::GerstnerSea sea;
  for (const double direction_rad : {0.4, -2.0}) {
    sea.waves.push_back({.amplitude_m = 0.6,
                         .wavenumber_radpm = 2.0 * std::numbers::pi / 170.0,
                         .direction_rad = direction_rad,
                         .omega_radps = 0.6,
                         .phase_rad = 0.3});
  }
  const ocean::GerstnerInstant instant(sea, 5.0);
  const RgbImage map = map_of(sea_of(256), 500.0, instant);
  ocean::SurfaceFields same = sea_of(256);
  for (std::size_t i = 0; i < same.displacement_y.size(); ++i) {
    const double column = static_cast<double>(i % 256), row = static_cast<double>(i / 256);
    same.displacement_y[i] =
        static_cast<float>(instant.at(500.0 / 256.0 * column, 500.0 / 256.0 * row).displacement_y_m);
  }
  const RgbImage expected = map_of(same, 500.0);
  for (int row : {0, 9, 128, 255}) {
    for (int column = 0; column < 256; ++column)
      EXPECT_NEAR(brightness(map, column, row), brightness(expected, column, row), 3.0);
  }
}

// Fails if foam is not seen.
TEST(SeaMap, FoamIsBright) {
  const ocean::SurfaceFields still = sea_of(256);
  EXPECT_GT(mean_brightness(map_of(still, 500.0, {{}, 0.0}, std::vector<float>(256 * 256, 0.5f))),
            mean_brightness(map_of(still, 500.0)) + 100.0);
}

// Fails if seas of fewer or more samples have pictures out of proportion.
TEST(SeaMap, HasAReadableSize) {
  EXPECT_EQ(map_of(sea_of(16, 1), 500.0).width, 256);
  EXPECT_EQ(map_of(sea_of(512, 1), 500.0).width, 512);
  const RgbImage large = map_of(sea_of(2048, 5), 500.0);
  EXPECT_EQ(large.width, 1024);
  EXPECT_GT(share_of(large, 5), 10.0 * share_of(large, 4));
}

TEST(SeaMap, NeedsACascade) {
  EXPECT_THROW(draw_sea_map({}, {{}, 0.0}, hs_m), Error);
}

}  // namespace
}  // namespace offing::cli

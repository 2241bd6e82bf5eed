// Colours of maps on the ground, by the light that comes from them, against their linear means.
#include "host/terrain/shading/colour_layer.h"

#include <cmath>
#include <functional>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/terrain/terrain_painter.h"

namespace offing {
namespace {

using terrain::Texel;

using std::numbers::pi;
constexpr int side_px = 33;
using Colour = std::array<int, 4>;

/// 65 x 65 posts of flat ground, 2 m apart.
test::HeightMap flat() {
  test::HeightMap map{"flat", {.columns = 65, .rows = 65, .spacing_x_m = 2.0, .spacing_z_m = 2.0}, {}};
  map.heights_m.assign(65 * 65, 0.0f);
  return map;
}

/// Light of the same strength in all colours; beside colours the ground is water.
test::PaintedTerrain grey_light() {
  test::PaintedTerrain scene;
  TerrainLight& light = scene.light;
  light.sun_green_klx = light.sun_blue_klx = light.sun_red_klx;
  light.sky_green_klx = light.sky_blue_klx = light.sky_red_klx;
  return scene;
}

ColourMap colours_of(int columns, int rows, const std::function<Colour(int, int)>& colour) {
  ColourMap map{
      .columns = columns, .rows = rows, .rgba = {}, .left = 0.0, .top = 0.0, .right = 64.0, .bottom = 64.0};
  for (int row = 0; row < rows; ++row) {
    for (int column = 0; column < columns; ++column) {
      for (const int value : colour(column, row)) map.rgba.push_back(static_cast<std::uint8_t>(value));
    }
  }
  return map;
}

Camera looking_down(double height_m, double width_m) {
  return {.eye_m = {64.0, height_m, 64.0},
          .pitch_rad = -0.5 * pi,
          .vertical_field_of_view_rad = 2.0 * std::atan(0.5 * width_m / height_m),
          .width_px = side_px,
          .height_px = side_px};
}

/// Albedos of the pixels: their light over that of a white surface.
std::vector<Texel> albedos(const ColourMap& colours, const Camera& camera) {
  const test::PaintedTerrain scene = grey_light();
  test::TerrainPainter painter(flat(), scene);
  const terrain::ColourLayer layer(painter.device(), colours);
  std::vector<Texel> image = painter.draw(camera, {.sampling = {.rays = 1}, .colours = &layer});
  const double white = (100.0 * std::sin(scene.sun_elevation_rad) + 10.0) / pi;
  for (Texel& texel : image) {
    for (std::size_t i = 0; i < 3; ++i) texel[i] = static_cast<float>(texel[i] / white);
  }
  return image;
}

double linear_of(int srgb) {
  const double value = srgb / 255.0;
  return value <= 0.04045 ? value / 12.92 : std::pow((value + 0.055) / 1.055, 2.4);
}

// A checkerboard of two greys, 1 m a field, seen so that a pixel covers 12 m: its albedo is the mean of the
// two, 0.31, not that of their bytes, 0.22. A pixel sees 12 x 12 fields, of which a row too many is 8 %
// of the contrast: gate 0.02. Fails if colours are averaged before they are decoded, or if pixels see but a
// few fields.
TEST(ColourLayerTest, FarColoursAreTheMeanOfTheirLight) {
  const ColourMap board = colours_of(128, 128, [](int column, int row) {
    const int grey = ((column ^ row) & 1) != 0 ? 200 : 60;
    return Colour{grey, grey, grey, 255};
  });
  const double mean = 0.5 * (linear_of(200) + linear_of(60));
  const std::vector<Texel> image = albedos(board, looking_down(5000.0, 12.0 * side_px));
  // Those whose 12 m are on the map: 5 from the middle.
  for (int row = 16 - 4; row <= 16 + 4; ++row) {
    for (int column = 16 - 4; column <= 16 + 4; ++column) {
      EXPECT_NEAR(image[static_cast<std::size_t>(row * side_px + column)][0], mean, 0.02)
          << column << ", " << row;
    }
  }
}

// Long footprints: the same board toward the horizon, where a pixel is many times as long as wide. No pixel
// beyond may differ from the mean by more than the 4 places along it allow, 0.1; one alone would show the
// fields, 0.27 from the mean.
TEST(ColourLayerTest, GrazedColoursAreMeansToo) {
  const ColourMap board = colours_of(256, 256, [](int column, int row) {
    const int grey = ((column ^ row) & 1) != 0 ? 200 : 60;
    return Colour{grey, grey, grey, 255};
  });
  Camera camera{.eye_m = {64.0, 3.0, 127.0},
                .pitch_rad = -0.05,
                .vertical_field_of_view_rad = 0.04,
                .width_px = 64,
                .height_px = 16};
  const double mean = 0.5 * (linear_of(200) + linear_of(60));
  for (const Texel& texel : albedos(board, camera)) {
    if (texel[3] < 1.0f) continue;
    EXPECT_NEAR(texel[0], mean, 0.1);
  }
}

// Texels of 8 m, 4 of them on half the map's width from its 16th column and 20th row: the middle of each
// shows its colour, to 1/255 of sRGB as linear light, and beside the map is water. Fails if the map is
// shifted, mirrored, or of another size.
TEST(ColourLayerTest, LiesWhereItIsPlaced) {
  ColourMap patches = colours_of(4, 2, [](int column, int row) {
    return Colour{30 + 60 * column, 250 - 100 * row, 20 + 25 * (column + row), 255};
  });
  patches.left = 16.0;
  patches.top = 20.0;
  patches.right = 32.0;
  patches.bottom = 28.0;
  const Camera camera = looking_down(1000.0, 2.0 * side_px);
  const std::vector<Texel> image = albedos(patches, camera);
  const auto at = [&](double x_m, double z_m) {
    const int column = static_cast<int>(std::floor((x_m - 64.0) / 2.0 + 0.5 * side_px));
    const int row = static_cast<int>(std::floor((z_m - 64.0) / 2.0 + 0.5 * side_px));
    return image[static_cast<std::size_t>(row * side_px + column)];
  };
  for (int row = 0; row < 2; ++row) {
    for (int column = 0; column < 4; ++column) {
      const Texel found = at(32.0 + 8.0 * (column + 0.5), 40.0 + 8.0 * (row + 0.5));
      EXPECT_NEAR(found[0], linear_of(30 + 60 * column), 0.01) << column << ", " << row;
      EXPECT_NEAR(found[1], linear_of(250 - 100 * row), 0.01) << column << ", " << row;
      EXPECT_NEAR(found[2], linear_of(20 + 25 * (column + row)), 0.01) << column << ", " << row;
    }
  }
  constexpr double water_red = 0.042;  // of kernels/terrain/cover/terrain_cover.clh
  EXPECT_NEAR(at(68.0, 48.0)[0], water_red, 1e-4);
  EXPECT_NEAR(at(48.0, 60.0)[0], water_red, 1e-4);
}

// Ground that the map does not cover has the cover of its height; where it covers half, half of both.
TEST(ColourLayerTest, LeavesGroundThatItDoesNotCover) {
  const ColourMap none = colours_of(3, 5, [](int, int) { return Colour{255, 255, 255, 0}; });
  const ColourMap half = colours_of(3, 5, [](int, int) { return Colour{255, 255, 255, 146}; });  // 4/7
  EXPECT_NEAR(albedos(none, looking_down(500.0, 20.0))[40][0], 0.042, 1e-4);
  EXPECT_NEAR(albedos(half, looking_down(500.0, 20.0))[40][0], 4.0 / 7.0 + 3.0 / 7.0 * 0.042, 1e-3);
}

TEST(ColourLayerTest, RefusesMapsThatDoNotFit) {
  const ocl::Device device = ocl::Device::open();
  const ColourMap good = colours_of(3, 2, [](int, int) { return Colour{1, 2, 3, 255}; });
  EXPECT_NO_THROW(terrain::ColourLayer(device, good));
  ColourMap few = good, nowhere = good, turned = good;
  few.rgba.pop_back();
  nowhere.left = std::numeric_limits<double>::quiet_NaN();
  turned.bottom = -1.0;
  for (const ColourMap& map : {few, nowhere, turned, ColourMap{}}) {
    EXPECT_THROW(terrain::ColourLayer(device, map), Error);
  }
}

}  // namespace
}  // namespace offing

#include "host/cli/sea_map.h"

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/cli/test_sea.h"

namespace offing::cli {
namespace {

int brightness(const RgbImage& image, int column, int row) {
  const std::uint8_t* const pixel = &image.rgb[3 * (static_cast<std::size_t>(row) * image.width + column)];
  return pixel[0] + pixel[1] + pixel[2];
}

// Fails if the map is shifted, transposed or shows labels instead of places: the crest of a wave along +x
// that is shifted by 8 m as a whole must appear 8 m further right, in every row.
TEST(SeaMap, ShowsCrestsWhereTheWaterIs) {
  const double length_m = 64.0;
  ocean::SurfaceFields fields = one_wave(64, length_m, 1, 1.0);
  for (float& shift : fields.displacement_x) shift = 8.0f;
  for (float& gradient : fields.gradient_xx) gradient = 0.0f;
  for (float& slope : fields.slope_x) slope = 0.0f;  // even light: brightness is elevation alone
  MapView view{64, 64, 32.0, 32.0, length_m};
  const RgbImage image = render_sea_map(surface_of(fields, length_m), view);
  for (int row = 0; row < 64; row += 9) {
    int brightest = 0;
    for (int column = 0; column < 64; ++column) {
      if (brightness(image, column, row) > brightness(image, brightest, row)) brightest = column;
    }
    EXPECT_NEAR(brightest + 0.5, 8.0, 1.6) << row;  // the top is flat over a pixel or two in 8-bit colour
  }
}

// Fails if the patch border shows: a map two patches wide repeats exactly.
TEST(SeaMap, RepeatsWithThePatch) {
  const PreviewSurface surface = surface_of(noisy_slopes(32, 0.1f), 32.0);
  const RgbImage image = render_sea_map(surface, {64, 32, 0.0, 0.0, 64.0});
  for (int row = 0; row < 32; ++row) {
    for (int column = 0; column < 32; ++column) {
      ASSERT_EQ(brightness(image, column, row), brightness(image, column + 32, row));
    }
  }
}

// Fails if a map without extent is drawn.
TEST(SeaMap, BadViewsAreRefused) {
  const PreviewSurface surface = surface_of(calm_sea(16), 64.0);
  EXPECT_THROW(render_sea_map(surface, {64, 64, 0.0, 0.0, 0.0}), Error);
  EXPECT_THROW(render_sea_map(surface, {4, 64, 0.0, 0.0, 10.0}), Error);
}

}  // namespace
}  // namespace offing::cli

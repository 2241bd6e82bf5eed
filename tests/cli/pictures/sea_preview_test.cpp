#include "host/cli/pictures/sea_preview.h"

#include <limits>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/cli/pictures/foam_texture.h"
#include "tests/cli/pictures/test_sea.h"

namespace offing::cli {
namespace {

PreviewView small_view() {
  PreviewView view;
  view.width = 160;
  view.height = 90;
  view.sun_azimuth_rad = 3.0;  // behind: no glitter in view
  return view;
}

int brightness(const RgbImage& image, int column, int row) {
  const std::uint8_t* const pixel = &image.rgb[3 * (static_cast<std::size_t>(row) * image.width + column)];
  return pixel[0] + pixel[1] + pixel[2];
}

/// The row where the picture darkens most from one row to the next: rough water against the sky over it.
int outline_row(const RgbImage& image) {
  std::vector<int> sums(image.height);
  for (int row = 0; row < image.height; ++row) {
    for (int column = 0; column < image.width; ++column) sums[row] += brightness(image, column, row);
  }
  int outline = 1;
  for (int row = 2; row < image.height; ++row) {
    if (sums[row - 1] - sums[row] > sums[outline - 1] - sums[outline]) outline = row;
  }
  return outline;
}

// Fails if the camera's pitch or field of view is wrong: the horizon lies tan(6 deg) above the middle, in
// pixels of 2 tan(27.5 deg) / 160: row 45 - 16.2 = 28.8. Gate 2 rows: haze softens the last one.
TEST(SeaPreview, HorizonIsWhereTheCameraPutsIt) {
  const RgbImage image = render_sea_preview(surface_of(noisy_slopes(64, 0.3f), 64.0), small_view());
  const double horizon = 45.0 - std::tan(6.0 * std::numbers::pi / 180.0) /
                                    (2.0 * std::tan(27.5 * std::numbers::pi / 180.0) / 160.0);
  EXPECT_NEAR(outline_row(image), horizon, 2.0);
}

// Fails if heights are not to scale. From 4 m in a trough, the next crest of a wave of amplitude 6 m and
// length 128 m stands 2 m above the eye in 64 m: 1.8 deg or 4.8 rows over the horizon, which it hides; one
// of 0.1 m hides nothing.
TEST(SeaPreview, HighSeasRiseAboveTheHorizon) {
  PreviewView view = small_view();
  view.camera_height_m = 4.0;
  view.eye_x_m = 64.0;
  const double length_m = 128.0;
  const auto outline = [&](double amplitude_m) {
    const ocean::SurfaceFields fields = with_noise(one_wave(64, length_m, 1, amplitude_m), 0.3f);
    return outline_row(render_sea_preview(surface_of(fields, length_m), view));
  };
  EXPECT_NEAR(outline(0.1), 28.8, 2.0);
  EXPECT_NEAR(outline(6.0), 28.8 - 4.8, 2.0);
}

// Fails if the picture depends on which thread did what, or the patch border shows: a patch length of 64 m
// further on, every bit is the same.
TEST(SeaPreview, RepeatsExactlyWithThePatch) {
  const PreviewSurface surface = surface_of(noisy_slopes(64, 0.1f), 64.0);
  PreviewView view = small_view();
  const RgbImage here = render_sea_preview(surface, view);
  EXPECT_EQ(here.rgb, render_sea_preview(surface, view).rgb);
  view.eye_x_m += 64.0;
  view.eye_z_m -= 128.0;
  EXPECT_EQ(here.rgb, render_sea_preview(surface, view).rgb);
}

// Fails if far, unresolved waves flicker from pixel to pixel: white noise in every sample must look even
// where a pixel covers some hundred of them. Gate: neighbours within 12 of 765; without filtering they
// differ by 100 and more.
TEST(SeaPreview, FarWaterHasNoGrain) {
  const RgbImage image = render_sea_preview(surface_of(noisy_slopes(256, 0.2f), 64.0), small_view());
  for (int row = 31; row < 36; ++row) {
    for (int column = 1; column < 160; ++column) {
      ASSERT_LE(std::abs(brightness(image, column, row) - brightness(image, column - 1, row)), 24)
          << row << " " << column;
    }
  }
}

// Fails if foam is drawn with another coverage than asked, close by or averaged over a large pixel.
// Bound: the noise is not quite normal; measured worst 0.06 at 0.2. Gate 0.09.
TEST(FoamTexture, CoversWhatItIsAskedTo) {
  for (const float coverage : {0.0f, 0.05f, 0.2f, 0.5f, 0.8f, 1.0f}) {
    for (const float footprint_m : {0.01f, 0.3f, 5.0f}) {
      double sum = 0.0;
      for (int row = 0; row < 100; ++row) {
        for (int column = 0; column < 100; ++column) {
          const float opacity = foam_opacity(0.37 * column, 0.41 * row, coverage, footprint_m);
          ASSERT_GE(opacity, 0.0f);
          ASSERT_LE(opacity, 1.0f);
          sum += opacity;
        }
      }
      EXPECT_NEAR(sum / 10000, coverage, footprint_m > 2.0f ? 1e-5 : 0.09) << coverage << " " << footprint_m;
    }
  }
}

// Fails if who stops a bake has to wait for a picture that takes seconds.
TEST(SeaPreview, StopsWhenAsked) {
  CancelToken cancel;
  cancel.cancel();
  try {
    render_sea_preview(surface_of(noisy_slopes(64, 0.3f), 64.0), small_view(), cancel);
    ADD_FAILURE() << "was drawn to its end";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::cancelled);
  }
}

// Fails if a view that cannot be drawn ends in an endless mesh or a crash instead of an error.
TEST(SeaPreview, BadViewsAreRefused) {
  const PreviewSurface surface = surface_of(calm_sea(16), 64.0);
  const auto refused = [&](auto change) {
    PreviewView view = small_view();
    change(view);
    EXPECT_THROW(render_sea_preview(surface, view), Error);
  };
  const double nan = std::numeric_limits<double>::quiet_NaN();
  refused([](PreviewView& view) { view.width = 0; });
  refused([](PreviewView& view) { view.samples = 9; });
  refused([](PreviewView& view) { view.camera_height_m = 0.0; });
  refused([&](PreviewView& view) { view.camera_height_m = nan; });
  refused([](PreviewView& view) { view.pitch_deg = -90.0; });
  refused([](PreviewView& view) { view.fov_deg = 180.0; });
  refused([&](PreviewView& view) { view.yaw_rad = nan; });
  refused([](PreviewView& view) { view.sun_elevation_deg = -5.0; });
}

}  // namespace
}  // namespace offing::cli

#include "host/cli/pictures/preview_raster.h"

#include <atomic>
#include <stdexcept>

#include <gtest/gtest.h>

#include "host/base/parallel_rows.h"

namespace offing::cli {
namespace {

/// A screen-filling quad of two rows and two columns; label x runs from 0 at the left to 1 at the right.
std::vector<ScreenVertex> quad(float left_nearness, float right_nearness, float label_z) {
  return {{-1, -1, left_nearness, 0, label_z},
          {33, -1, right_nearness, 1, label_z},
          {-1, 33, left_nearness, 0, label_z},
          {33, 33, right_nearness, 1, label_z}};
}

// Fails if labels are interpolated on the screen instead of in space: half way between nearness 3 and 1 lies
// at (0 * 3 + 1 * 1) / 4 of the label range. Gate 1e-5: a few roundings.
TEST(PreviewRaster, InterpolatesInPerspective) {
  const std::vector<RasterSample> samples = rasterise(quad(3.0f, 1.0f, 0.0f), 2, 2, 32, 32);
  const float share = 16.5f / 34.0f + 1.0f / 34.0f;  // centre of column 16 between -1 and 33
  EXPECT_NEAR(samples[16 * 32 + 16].nearness, 3.0f - 2.0f * share, 1e-5);
  EXPECT_NEAR(samples[16 * 32 + 16].label_x, share / (3.0f - 2.0f * share), 1e-5);
}

// Fails if what is drawn last covers what is nearer, or a sample stays empty along the diagonal or a strip's
// border.
TEST(PreviewRaster, NearestSurfaceWinsAndCoversAll) {
  std::vector<ScreenVertex> mesh = quad(2.0f, 2.0f, 7.0f);
  const std::vector<ScreenVertex> behind = quad(1.0f, 1.0f, 9.0f);
  // Two sheets in one mesh; the strip of cells between them is hidden behind the eye.
  const ScreenVertex hidden{};
  mesh.insert(mesh.end(), {hidden, hidden});
  mesh.insert(mesh.end(), behind.begin(), behind.end());
  for (const RasterSample& sample : rasterise(mesh, 2, 5, 32, 32)) {
    EXPECT_FLOAT_EQ(sample.label_z, 7.0f);
    EXPECT_FLOAT_EQ(sample.nearness, 2.0f);
  }
}

// Fails if a cell with a corner behind the eye is drawn: its corner has no place on the screen.
TEST(PreviewRaster, CellsBehindTheEyeAreLeftOut) {
  for (const RasterSample& sample : rasterise(quad(1.0f, -1.0f, 0.0f), 2, 2, 32, 32)) {
    EXPECT_EQ(sample.nearness, 0.0f);
  }
}

// Fails if a row is left out or done twice, or a thread's exception ends the program.
TEST(ParallelRows, DoesEachRowOnceAndReportsFailures) {
  std::vector<std::atomic<int>> counts(1000);
  parallel_rows(1000, [&](int row) { ++counts[row]; });
  for (const std::atomic<int>& count : counts) ASSERT_EQ(count, 1);
  EXPECT_THROW(parallel_rows(1000,
                             [](int row) {
                               if (row == 500) throw std::runtime_error("row");
                             }),
               std::runtime_error);
}

}  // namespace
}  // namespace offing::cli

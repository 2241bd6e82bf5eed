#include "host/cli/pictures/spectrum_plot.h"

#include <cmath>
#include <numbers>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/cli/pictures/plot_canvas.h"

namespace offing::cli {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;

/// A narrow sea of 0.25 Hz that travels toward `direction_rad`, frequencies up to 0.5 Hz.
WaveSpectrum narrow_sea(double direction_rad) {
  WaveSpectrum record;
  for (int i = 1; i <= 50; ++i) {
    const double f = 0.01 * i;
    record.frequencies_hz.push_back(f);
    record.energy.push_back(std::exp(-std::pow((f - 0.25) / 0.05, 2)));
  }
  const int directions = 36;
  std::vector<double> row;
  double sum = 0.0;
  for (int i = 0; i < directions; ++i) {
    record.directions_rad.push_back(2.0 * std::numbers::pi * i / directions);
    row.push_back(std::exp(20.0 * std::cos(record.directions_rad[i] - direction_rad)));
    sum += row.back() * 2.0 * std::numbers::pi / directions;
  }
  for (std::size_t f = 0; f < record.energy.size(); ++f) {
    for (const double value : row) record.spreading.push_back(value / sum);
  }
  return record;
}

/// Centre of the darkest coloured place inside the rose, from its middle.
Point darkest_in_rose(const RgbImage& image) {
  const int middle_column = 895, middle_row = 335;
  Point weighted;
  double weight = 0.0;
  for (int row = -210; row <= 210; ++row) {
    for (int column = -210; column <= 210; ++column) {
      const std::uint8_t* const pixel =
          &image.rgb[3 * (static_cast<std::size_t>(middle_row + row) * image.width + middle_column + column)];
      const int brightness = pixel[0] + pixel[1] + pixel[2];
      if (std::hypot(column, row) > 205 || brightness > 250) continue;  // the grid is lighter
      weighted.x += column;
      weighted.y += row;
      weight += 1.0;
    }
  }
  return {weighted.x / weight, weighted.y / weight};
}

// Fails if the rose is mirrored or turned: +x is east and drawn to the right, +z south and drawn downward;
// and if radius is not frequency: the peak at 0.25 Hz lies on 0.25 / end of 215 pixels. Gate 8 pixels: the
// blot is 60 wide and the grid crosses it.
TEST(SpectrumPlot, RosePointsWhereTheSeaTravels) {
  // The last frequency with 1 % of the peak is 0.35 Hz (0.05 sqrt(ln 100) = 0.107 above 0.25), shown to 0.42
  // Hz.
  const double radius = 215.0 * 0.25 / 0.42;
  for (const double direction_rad : {0.0, 0.5 * std::numbers::pi, 4.0}) {
    const Point found = darkest_in_rose(draw_spectrum_plot(narrow_sea(direction_rad), {}));
    EXPECT_NEAR(found.x, radius * std::cos(direction_rad), 8.0) << direction_rad;
    EXPECT_NEAR(found.y, radius * std::sin(direction_rad), 8.0) << direction_rad;
  }
}

// Fails if bearings, which text gives as those where the sea comes from, are drawn where it goes: opposite.
TEST(SpectrumPlot, RoseFollowsBearings) {
  const double radius = 215.0 * 0.25 / 0.42;
  const Point found = darkest_in_rose(draw_spectrum_plot(narrow_sea(0.0), {}, DirectionStyle::from_bearing));
  EXPECT_NEAR(found.x, -radius, 8.0);
  EXPECT_NEAR(found.y, 0.0, 8.0);
}

// Fails if a record without directions or without energy cannot be drawn, or a plot differs from run to run.
TEST(SpectrumPlot, DrawsWhatRecordsLack) {
  WaveSpectrum record = narrow_sea(0.0);
  const RgbImage directional = draw_spectrum_plot(record, {});
  EXPECT_EQ(directional.rgb, draw_spectrum_plot(record, {}).rgb);
  record.directions_rad.clear();
  record.spreading.clear();
  EXPECT_NE(directional.rgb, draw_spectrum_plot(record, {}).rgb);
  for (double& energy : record.energy) energy = 0.0;
  EXPECT_EQ(draw_spectrum_plot(record, {}).width, 1240);
  record = narrow_sea(0.0);
  for (double& energy : record.energy) energy = 0.0;
  EXPECT_EQ(draw_spectrum_plot(record, {}).width, 1240);
}

// Fails if the heading has figures of its own instead of those that all texts give.
TEST(SpectrumPlot, ShowsTheFiguresOfTheState) {
  const WaveSpectrum record = narrow_sea(0.0);
  const RgbImage plain = draw_spectrum_plot(record, {.hs_m = 1.0, .peak_period_s = 4.0});
  EXPECT_EQ(draw_spectrum_plot(record, {.hs_m = 1.0, .peak_period_s = 4.0}).rgb, plain.rgb);
  EXPECT_NE(draw_spectrum_plot(record, {.hs_m = 1.1, .peak_period_s = 4.0}).rgb, plain.rgb);
  EXPECT_NE(draw_spectrum_plot(record, {.hs_m = 1.0, .peak_period_s = 4.2}).rgb, plain.rgb);
}

// Fails if arrays that do not match reach the drawing, which reads them without checks.
TEST(SpectrumPlot, MismatchedRecordsAreRefused) {
  WaveSpectrum record = narrow_sea(0.0);
  record.energy.pop_back();
  EXPECT_THROW(draw_spectrum_plot(record, {}), Error);
  record = narrow_sea(0.0);
  record.spreading.pop_back();
  EXPECT_THROW(draw_spectrum_plot(record, {}), Error);
  EXPECT_THROW(draw_spectrum_plot({}, {}), Error);
}

// Fails if axes get odd numbers, miss the end or run past it.
TEST(SpectrumPlot, TicksAreRound) {
  EXPECT_THAT(round_ticks(0.42, 7),
              ElementsAre(DoubleNear(0, 0), DoubleNear(0.1, 1e-12), DoubleNear(0.2, 1e-12),
                          DoubleNear(0.3, 1e-12), DoubleNear(0.4, 1e-12)));
  EXPECT_THAT(round_ticks(50.0, 5), ElementsAre(0, 10, 20, 30, 40, 50));
  EXPECT_EQ(round_ticks(3e-6, 6).size(), 7u);
}

}  // namespace
}  // namespace offing::cli

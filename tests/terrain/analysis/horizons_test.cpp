// Horizons of posts by azimuth, against horizons found by steps over the surface in double precision.
#include "host/terrain/analysis/horizons.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/ocl/expect_error.h"
#include "tests/terrain/example_maps.h"

namespace offing {
namespace {

using std::numbers::pi;

/// The height of bilinear ground at (x, z) cells.
double surface_m(const test::HeightMap& map, double x, double z) {
  const int left = std::min(static_cast<int>(x), map.grid.columns - 2),
            top = std::min(static_cast<int>(z), map.grid.rows - 2);
  const double u = x - left, v = z - top;
  const auto at = [&](int column, int row) { return static_cast<double>(map.at(column, row)); };
  return (1.0 - v) * ((1.0 - u) * at(left, top) + u * at(left + 1, top)) +
         v * ((1.0 - u) * at(left, top + 1) + u * at(left + 1, top + 1));
}

/// The greatest rise to the ground by steps of a fiftieth of a cell; 0 or more.
double horizon_by_steps(const test::HeightMap& map, int column, int row, double azimuth_rad,
                        double bend_perm) {
  const auto& grid = map.grid;
  const double step_m = 0.02 * std::min(grid.spacing_x_m, grid.spacing_z_m);
  const double per_x = std::sin(azimuth_rad) / grid.spacing_x_m,
               per_z = -std::cos(azimuth_rad) / grid.spacing_z_m;
  double horizon = 0.0;
  for (double way_m = step_m;; way_m += step_m) {
    const double x = column + way_m * per_x, z = row + way_m * per_z;
    if (x < 0.0 || z < 0.0 || x > grid.columns - 1 || z > grid.rows - 1) return horizon;
    const double rise = (surface_m(map, x, z) - static_cast<double>(map.at(column, row))) / way_m;
    horizon = std::max(horizon, rise - bend_perm * way_m);
  }
}

// The walk leaves out ground that would lift a horizon by less than 0.001, and begins 2e-5 of a cell above
// the ground, which is as much again of ground a fiftieth of a cell away: horizons are 0.002 too low at most.
// Steps of a fiftieth of a cell miss a ridge by up to a hundredth, 0.01 of the slopes next to it a cell away
// or farther: 0.02 on these hills. Fails if a ridge is passed over, a horizon of another post is taken,
// azimuths turn the other way, or the Earth falls away on the wrong side.
TEST(HorizonsTest, AreThoseOfStepsOverTheSurface) {
  const test::HeightMap map =
      test::valleys({.columns = 90, .rows = 140, .spacing_x_m = 8.0, .spacing_z_m = 10.0});
  const ocl::Device device = ocl::Device::open();
  const terrain::HeightField field(device, map.grid, map.heights_m);
  for (const double radius_m : {terrain::EarthCurve{}.radius_m, 20e3}) {
    const terrain::EarthCurve curve{radius_m, 0.13};
    constexpr int azimuths = 24;
    terrain::Horizons horizons(device, field, azimuths, {}, curve);
    std::vector<float> rises;
    double low = 0.0, high = 0.0;
    for (const terrain::RowBand& band : horizons.bands()) {
      horizons.at(band);
      rises.resize(static_cast<std::size_t>(90 * band.rows));
      for (int azimuth = 0; azimuth < azimuths; ++azimuth) {
        horizons.read(static_cast<std::size_t>(azimuth), rises);
        for (int row = 3 + azimuth % 5; row < band.rows; row += 17) {
          for (int column = 2 + azimuth % 7; column < 90; column += 19) {
            const double expected = horizon_by_steps(map, column, band.first_row + row,
                                                     2.0 * pi * azimuth / azimuths, curve.bend_perm());
            const double found = static_cast<double>(rises[static_cast<std::size_t>(90 * row + column)]);
            low = std::min(low, found - expected);
            high = std::max(high, found - expected);
          }
        }
      }
    }
    EXPECT_GT(low, -0.002) << radius_m;
    EXPECT_LT(high, 0.02) << radius_m;
  }
}

// Fails if a part of the azimuths is not that part, or a band of rows is not that band.
TEST(HorizonsTest, SomeAreAsAmongAll) {
  const test::HeightMap map =
      test::valleys({.columns = 50, .rows = 70, .spacing_x_m = 8.0, .spacing_z_m = 10.0});
  const ocl::Device device = ocl::Device::open();
  const terrain::HeightField field(device, map.grid, map.heights_m);
  terrain::Horizons all(device, field, 16), some(device, field, 16, {3, 14});
  ASSERT_EQ(all.bands().size(), 2u);
  const terrain::RowBand band = all.bands()[1];
  EXPECT_EQ(band.first_row, 64);
  all.at(band);
  some.at(band);
  std::vector<float> one(50 * 6), other(50 * 6);
  for (std::size_t i = 0; i < 2; ++i) {
    all.read(i == 0 ? 3 : 14, one);
    some.read(i, other);
    EXPECT_EQ(one, other);
  }
  test::expect_error(ErrorKind::bad_usage, "rows", [&] { all.at({60, 20}); });
  test::expect_error(ErrorKind::bad_usage, "rows", [&] { all.at({0, 70}); });
  test::expect_error(ErrorKind::bad_input, "azimuths", [&] { terrain::Horizons(device, field, 7); });
}

}  // namespace
}  // namespace offing

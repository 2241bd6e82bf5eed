// Sky-view factors against closed forms, each to 1 %.
#include "host/terrain/analysis/sky_view.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/terrain/example_maps.h"

namespace offing {
namespace {

using std::numbers::pi;

/// Factors [rows][columns] of ground of some height at (x, z) m from the map's first post.
std::vector<double> sky_views(const terrain::PostGrid& grid,
                              const std::function<double(double, double)>& height_m) {
  std::vector<float> heights_m;
  for (int row = 0; row < grid.rows; ++row) {
    for (int column = 0; column < grid.columns; ++column) {
      heights_m.push_back(static_cast<float>(height_m(column * grid.spacing_x_m, row * grid.spacing_z_m)));
    }
  }
  const ocl::Device device = ocl::Device::open();
  const terrain::HeightField field(device, grid, heights_m);
  terrain::Horizons horizons(device, field, terrain::usual_azimuths);
  terrain::SkyView sky(device, horizons);
  std::vector<double> factors;
  std::vector<float> some;
  for (const terrain::RowBand& band : horizons.bands()) {
    some.resize(static_cast<std::size_t>(band.rows) * static_cast<std::size_t>(grid.columns));
    horizons.at(band);
    sky.read(band, some);
    factors.insert(factors.end(), some.begin(), some.end());
  }
  return factors;
}

// A plane that rises at an angle b sees (1 + cos b) / 2 of the sky: the rest of it lies behind the plane.
// Here the trapezoid rule over 64 azimuths is exact but for rounding of floats: measured 1e-6. Fails if the
// slope is not part of the cosine, or the plane hides the sky before it.
TEST(SkyViewTest, OfPlanes) {
  const terrain::PostGrid grid{.columns = 67, .rows = 71, .spacing_x_m = 3.0, .spacing_z_m = 5.0};
  for (const double view : sky_views(grid, [](double, double) { return 7.0; })) EXPECT_NEAR(view, 1.0, 1e-5);
  for (const double angle_rad : {pi / 12.0, pi / 6.0, pi / 4.0, pi / 3.0}) {
    const double slope = std::tan(angle_rad), expected = 0.5 * (1.0 + std::cos(angle_rad));
    for (const double view :
         sky_views(grid, [&](double x, double z) { return slope * (0.6 * x - 0.8 * z); })) {
      ASSERT_NEAR(view / expected, 1.0, 1e-5) << angle_rad;
    }
  }
}

// Level ground before an endless wall, a steep ramp with a plateau, that rises to an angle g: (1 + cos g)
// / 2. The wall ends 600 m to both sides, beyond which are 2e-4 of what it hides. Horizons are 0.001 of rise
// too low at most, and azimuths cut the wall's ends: measured 0.1 %. Fails if the wall's top is missed or
// weighed wrongly.
TEST(SkyViewTest, BeforeARampWall) {
  const terrain::PostGrid grid{.columns = 101, .rows = 241, .spacing_x_m = 5.0, .spacing_z_m = 5.0};
  const std::vector<double> views =
      sky_views(grid, [](double x, double) { return std::clamp(4.0 * (x - 300.0), 0.0, 100.0); });
  for (const int column : {5, 25, 40, 50, 58}) {
    const double wall_rad = std::atan2(100.0, 325.0 - 5.0 * column);
    const double view = views[static_cast<std::size_t>(120 * 101 + column)];
    EXPECT_NEAR(view / (0.5 * (1.0 + std::cos(wall_rad))), 1.0, 0.002) << column;
  }
}

// A cone that stands on level ground is nowhere above the planes that touch it, and so sees what they do:
// measured 4e-5. The middle of a round pit with a level floor and such sides sees cos^2 of its rim's
// elevation. Between posts the rim is up to 1 of 60 cells farther away: 0.5 % of the light. Measured 0.2 %.
// Fails if a hill hides the sky behind it, or azimuths count twice.
TEST(SkyViewTest, OfAConeAndAPit) {
  const terrain::PostGrid grid{.columns = 161, .rows = 161, .spacing_x_m = 5.0, .spacing_z_m = 5.0};
  const auto radius_m = [](double x, double z) { return std::hypot(x - 400.0, z - 400.0); };
  for (const double angle_rad : {pi / 9.0, pi / 5.0}) {
    const double slope = std::tan(angle_rad);
    const std::vector<double> hill =
        sky_views(grid, [&](double x, double z) { return slope * std::max(300.0 - radius_m(x, z), 0.0); });
    for (const auto& [column, row] : {std::pair{110, 80}, {80, 50}, {55, 60}, {98, 104}}) {
      const double view = hill[static_cast<std::size_t>(161 * row + column)];
      EXPECT_NEAR(view / (0.5 * (1.0 + std::cos(angle_rad))), 1.0, 1e-3) << column << ' ' << row;
    }
    const std::vector<double> pit = sky_views(
        grid, [&](double x, double z) { return slope * (std::clamp(radius_m(x, z), 100.0, 300.0) - 100.0); });
    const double rim_rad = std::atan(slope * 200.0 / 300.0);
    EXPECT_NEAR(pit[161 * 80 + 80] / std::pow(std::cos(rim_rad), 2.0), 1.0, 0.005);
  }
}

// In a bowl, a part of a sphere down to an angle a from its axis, every point sees the same share of the sky,
// (1 + cos a) / 2: in a sphere, each part gets the same light from each other part of a size. The rim lies
// between posts, up to 1 of 100 of the radius away, which moves the light near it by 0.5 %. Measured 0.2 %.
// Fails if the light of inclined ground is not weighed by the cosine on both sides.
TEST(SkyViewTest, InABowl) {
  const terrain::PostGrid grid{.columns = 241, .rows = 241, .spacing_x_m = 5.0, .spacing_z_m = 5.0};
  for (const double angle_rad : {pi / 4.0, pi / 3.0}) {
    const double rim_m = 500.0, sphere_m = rim_m / std::sin(angle_rad);
    const std::vector<double> views = sky_views(grid, [&](double x, double z) {
      const double radius_m = std::min(std::hypot(x - 600.0, z - 600.0), rim_m);
      return -std::sqrt(sphere_m * sphere_m - radius_m * radius_m);
    });
    const double expected = 0.5 * (1.0 + std::cos(angle_rad));
    for (const auto& [column, row] : {std::pair{120, 120}, {150, 120}, {120, 70}, {75, 95}, {180, 160}}) {
      const double view = views[static_cast<std::size_t>(241 * row + column)];
      EXPECT_NEAR(view / expected, 1.0, 0.005) << angle_rad << ": " << column << ' ' << row;
    }
  }
}

}  // namespace
}  // namespace offing

// The sky on a device against double precision, and what holds for any sky.
#include "host/sky/clear_sky.h"

#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "host/sky/sun_position.h"
#include "tests/ocl/expect_error.h"
#include "tests/sky/sky_reference.h"

namespace offing::sky {
namespace {

using std::numbers::pi;
using Direction = std::array<double, 3>;
constexpr double degree = pi / 180.0;

Direction at(double azimuth_deg, double elevation_deg) {
  return direction_of(azimuth_deg * degree, elevation_deg * degree);
}

class ClearSkyTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    device_ = std::make_unique<ocl::Device>(ocl::Device::open());
    sky_ = std::make_unique<ClearSky>(*device_, Atmosphere{});
  }
  static void TearDownTestSuite() {
    sky_.reset();
    device_.reset();
  }

  static Rgb sky_light(const Direction& direction) {
    return sky_->read_light(std::vector{direction}).sky_kcdpm2.front();
  }

  static std::unique_ptr<ocl::Device> device_;
  static std::unique_ptr<ClearSky> sky_;
};

std::unique_ptr<ocl::Device> ClearSkyTest::device_;
std::unique_ptr<ClearSky> ClearSkyTest::sky_;

// Fails if optical depths or the table's coordinates are wrong. The rows next to the ground stand 6, 25, 56 m
// high; between them the horizon's dip bends depths by up to (0.08 degrees)^2 / 8 * 3.6 air masses a square
// degree, 0.003 air masses of depth 0.2. Bound with the columns 1e-3, beside thrice that in red, which is 2.5
// times the luminance there. Measured 0.0033, half a degree above the horizon; 0.0002 above 10 degrees. Gate
// 0.005.
TEST_F(ClearSkyTest, SunlightIsThatOfTheReference) {
  const SkyReference reference{Atmosphere{}};
  double worst = 0.0;
  for (const double altitude_m : {1.0, 30.0, 1000.0, 12'000.0}) {
    for (const double elevation_deg : {90.0, 60.0, 30.0, 10.0, 5.0, 2.0, 1.0, 0.5}) {
      sky_->at({.sun_direction = at(77.0, elevation_deg), .eye_altitude_m = altitude_m});
      const Rgb expected = rgb_of_sunlight(reference.sunlight(altitude_m, std::sin(elevation_deg * degree)));
      const Rgb found = sky_->read_illuminance().sun_klx;
      for (std::size_t c = 0; c < 3; ++c) {
        worst = std::max(worst, std::abs(found[c] - std::max(0.0, expected[c])) / luminance(expected));
      }
    }
  }
  RecordProperty("worst_1e6", static_cast<int>(worst * 1e6));
  EXPECT_LT(worst, 0.005);
}

// Fails if a direction or a sun is not checked.
TEST_F(ClearSkyTest, RefusesBadViews) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto refuses = [](const SkyView& view, const char* part) {
    test::expect_error(ErrorKind::bad_input, part, [&] { sky_->at(view); });
  };
  refuses({.sun_direction = {0.0, 0.0, 0.0}}, "sun_direction");
  refuses({.sun_direction = {0.0, 2.0, 0.0}}, "sun_direction");
  refuses({.sun_direction = {nan, 1.0, 0.0}}, "sun_direction");
  refuses({.sun_distance_au = 0.0}, "sun_distance_au");
  refuses({.eye_altitude_m = -1.0}, "eye_altitude_m");
  refuses({.eye_altitude_m = 100'000.0}, "eye_altitude_m");
  refuses({.eye_altitude_m = nan}, "eye_altitude_m");
}

}  // namespace
}  // namespace offing::sky

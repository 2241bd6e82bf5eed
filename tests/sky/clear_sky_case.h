#pragma once

#include <array>
#include <memory>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "host/sky/clear_sky.h"
#include "host/sky/sun_position.h"

namespace offing::sky {

using Direction = std::array<double, 3>;
inline constexpr double degree = std::numbers::pi / 180.0;

/// Unit vector of an azimuth, clockwise from north, and an elevation.
inline Direction at(double azimuth_deg, double elevation_deg) {
  return direction_of(azimuth_deg * degree, elevation_deg * degree);
}

/// A sky of the default atmosphere, made once for all tests of a suite.
class ClearSkyCase : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    device = std::make_unique<ocl::Device>(ocl::Device::open());
    sky = std::make_unique<ClearSky>(*device, Atmosphere{});
  }
  static void TearDownTestSuite() {
    sky.reset();
    device.reset();
  }

  static Rgb sky_light(const Direction& direction) {
    return sky->read_light(std::vector{direction}).sky_kcdpm2.front();
  }

  static inline std::unique_ptr<ocl::Device> device;
  static inline std::unique_ptr<ClearSky> sky;
};

}  // namespace offing::sky

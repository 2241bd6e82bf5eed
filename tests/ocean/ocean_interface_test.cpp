// What Ocean refuses, and what stays the same when it is asked in another order.
#include <limits>

#include <gtest/gtest.h>

#include "host/ocean/cascades.h"
#include "host/ocean/ocean.h"
#include "host/ocean/spectrum_parameters.h"
#include "tests/ocl/expect_error.h"

namespace offing::ocean {
namespace {

class OceanInterfaceTest : public testing::Test {
 protected:
  OceanParameters parameters() const {
    return {.size = 32,
            .cascades = cascades_from_patches(std::vector{80.0, 15.0}, 32),
            .foam = {.onset_jacobian = 1.0}};
  }
  Ocean sea(const OceanParameters& wanted) { return Ocean(device_, spectrum_, wanted); }
  void expect_refused(const std::string& name, const OceanParameters& wanted) {
    test::expect_error(ErrorKind::bad_input, name, [&] { sea(wanted); });
  }

  ocl::Device device_ = ocl::Device::open();
  SeaSpectrum spectrum_ = make_sea_spectrum({});
};

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

// Fails if a parameter out of range reaches the device: wrong results, or a crash, instead of an error that
// names it.
TEST_F(OceanInterfaceTest, RefusesParametersOutOfRange) {
  const auto changed = [&](auto change) {
    OceanParameters wanted = parameters();
    change(wanted);
    return wanted;
  };
  expect_refused("size", changed([](auto& p) { p.size = 48; }));
  expect_refused("size", changed([](auto& p) { p.size = 8192; }));
  expect_refused("cascade count", changed([](auto& p) { p.cascades.clear(); }));
  expect_refused("cascade count", changed([](auto& p) { p.cascades.resize(5, p.cascades[0]); }));
  expect_refused("patch_length_m", changed([](auto& p) { p.cascades[1].patch_length_m = -1.0; }));
  expect_refused("k_min_radpm", changed([](auto& p) { p.cascades[1].k_min_radpm = 1e9; }));
  expect_refused("choppiness", changed([](auto& p) { p.choppiness = nan; }));
  expect_refused("loop_period_s", changed([](auto& p) { p.loop_period_s = 0.0; }));
  expect_refused("foam.width", changed([](auto& p) { p.foam.width = 0.0; }));
  expect_refused("foam.decay_s", changed([](auto& p) { p.foam.decay_s = -1.0; }));
  expect_refused("foam.step_s", changed([](auto& p) { p.foam.step_s = nan; }));
}

// Fails if a question out of range is answered.
TEST_F(OceanInterfaceTest, RefusesQuestionsOutOfRange) {
  SpectrumParameters shallow;
  shallow.dispersion.depth_m = 6.0;
  Ocean ocean(device_, make_sea_spectrum(shallow), parameters());
  ocean.at(0.0);
  const auto refuses = [](const std::string& name, auto call) {
    test::expect_error(ErrorKind::bad_input, name, call);
  };
  refuses("time_s", [&] { ocean.at(nan); });
  refuses("time_s", [&] { ocean.at(2e8); });
  refuses("cascade index", [&] { ocean.read_surface(2); });
  refuses("cascade index", [&] { ocean.read_velocity(-1); });
  refuses("cascade index", [&] { ocean.read_foam(2); });
  refuses("cascade index", [&] { ocean.mode_variance(2); });
  refuses("depth_m", [&] { ocean.read_velocity(0, 6.1); });
  refuses("columns", [&] { ocean.read_composed({.columns = 0, .rows = 4}); });
  refuses("origin_m", [&] { ocean.read_composed({.origin_z_m = nan, .columns = 4, .rows = 4}); });
  refuses("spacing_m", [&] { ocean.read_composed({.spacing_x_m = 1e7, .columns = 4, .rows = 4}); });
  refuses("depth_m", [&] { ocean.read_velocity(0, -0.1); });
}

// Fails if one read changes what the next one sees, or if a frame depends on the frames before it.
TEST_F(OceanInterfaceTest, ReadsDoNotDisturbEachOther) {
  Ocean ocean = sea(parameters());
  ocean.at(3.0);
  const SurfaceFields before = ocean.read_surface(1);
  const std::vector<float> variance = ocean.mode_variance(1);
  ocean.read_foam(0);
  ocean.read_velocity(1, 0.5);
  ocean.read_composed({.columns = 5, .rows = 4});
  EXPECT_EQ(ocean.read_surface(1).displacement_y, before.displacement_y);
  EXPECT_EQ(ocean.mode_variance(1), variance);
  ocean.at(1e5);
  ocean.read_surface(0);
  ocean.at(3.0);
  Ocean moved = std::move(ocean);
  EXPECT_EQ(moved.read_surface(1).gradient_xz, before.gradient_xz);
}

// Fails if a new seed leaves waves of the old one, or if coming back to a seed gives another sea.
TEST_F(OceanInterfaceTest, ReseedingDrawsAnotherSeaAndBack) {
  Ocean ocean = sea(parameters());
  ocean.at(3.0);
  const std::vector<float> first = ocean.read_surface(0).displacement_y;
  const std::vector<float> first_foam = ocean.read_foam(0);
  ocean.reseed(2);
  EXPECT_EQ(ocean.parameters().seed, 2u);
  ocean.at(3.0);
  EXPECT_NE(ocean.read_surface(0).displacement_y, first);
  EXPECT_NE(ocean.read_foam(0), first_foam);
  ocean.reseed(1);
  ocean.at(3.0);
  EXPECT_EQ(ocean.read_surface(0).displacement_y, first);
  EXPECT_EQ(ocean.read_foam(0), first_foam);
}

}  // namespace
}  // namespace offing::ocean

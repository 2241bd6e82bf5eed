// Foam against its definition: max over j = 0 ... M of c(J(t_q - j step)) e^{-(t - t_q + j step) / decay} and
// of c(J(t_q + step)) (t - t_q) / step, with t_q = step floor(t / step), M = ceil(4 decay / step), c(J) =
// clamp((onset
// - J) / width, 0, 1).
//
// Coverage is kept in half precision: 2^-11 relative. J is that of read_surface in single precision: where c
// is between 0 and 1, 1e-6 / width more. Gate 2^-11 + 1e-5.
#include "host/ocean/surface/foam.h"

#include <algorithm>
#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "host/ocean/surface/ocean.h"
#include "tests/ocl/expect_error.h"

namespace offing::ocean {
namespace {

constexpr double gate = 0x1p-11 + 1e-5;

constexpr int size = 16;

class FoamTest : public testing::Test {
 protected:
  // Low waves: an onset near 1 gives every coverage from 0 to 1.
  OceanParameters parameters() const {
    return {
        .size = size,
        .cascades = cascades_from_patches(std::vector{120.0, 21.0}, size),
        .choppiness = 1.2,
        .foam = {
            .onset_jacobian = 1.0, .width = 0.3, .min_wavelength_m = 0.0, .decay_s = 0.8, .step_s = 0.25}};
  }
  Ocean sea(const OceanParameters& wanted) { return Ocean(device_, spectrum_, wanted); }

  // The formula, with J of `sea` at the past instants, `step_s` apart.
  std::vector<double> defined_foam(Ocean& sea, int cascade, double time_s, double step_s) {
    const FoamParameters& foam = sea.parameters().foam;
    const double newest_s = step_s * std::floor(time_s / step_s + 1e-9);
    const int count = static_cast<int>(std::ceil(4.0 * foam.decay_s / step_s - 1e-9));
    std::vector<double> expected(static_cast<std::size_t>(size * size), 0.0);
    for (int j = -1; j <= count; ++j) {
      sea.at(newest_s - j * step_s);
      const std::vector<float> jacobian = sea.read_surface(cascade).jacobian;
      const double since_s = time_s - newest_s;
      const double weight = j < 0 ? since_s / step_s : std::exp(-(since_s + j * step_s) / foam.decay_s);
      for (std::size_t i = 0; i < expected.size(); ++i) {
        const double coverage = std::clamp((*foam.onset_jacobian - jacobian[i]) / *foam.width, 0.0, 1.0);
        expected[i] = std::max(expected[i], coverage * weight);
      }
    }
    return expected;
  }

  void expect_foam(const std::vector<float>& foam, const std::vector<double>& expected, double time_s) {
    double worst = 0.0, least = 1.0, most = 0.0;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      worst = std::max(worst, std::abs(foam[i] - expected[i]));
      least = std::min<double>(least, foam[i]);
      most = std::max<double>(most, foam[i]);
    }
    EXPECT_LT(worst, gate) << time_s;
    EXPECT_GE(least, 0.0);
    EXPECT_LE(most, 1.0);
    EXPECT_GT(most - least, 0.3) << "the test sees no foam, or nothing else";
  }

  ocl::Device device_ = ocl::Device::open();
  SeaSpectrum spectrum_ = make_sea_spectrum({});
};

// Fails if foam depends on which times were asked before, if an instant is skipped or shifted, or if
// cascades are mixed up. Forth, back, far away, and just before and at an instant.
TEST_F(FoamTest, IsItsFormulaAtAnyTimeInAnyOrder) {
  Ocean asked = sea(parameters()), other = sea(parameters());
  for (const double time_s : {0.0, 7.1, 7.24999, 7.25, 6.9, 1e6 + 0.1, -3.2, 7.1}) {
    asked.at(time_s);
    for (const int cascade : {1, 0}) {
      expect_foam(asked.read_foam(cascade), defined_foam(other, cascade, time_s, 0.25), time_s);
    }
  }
}

// Fails if what is kept from frame to frame differs in a bit from what a fresh start computes.
TEST_F(FoamTest, KeptCoveragesAreThoseOfAFreshStart) {
  Ocean asked = sea(parameters());
  for (const double time_s : {2.0, 2.3, 2.6, 1.9}) {
    asked.at(time_s);
    Ocean fresh = sea(parameters());
    fresh.at(time_s);
    EXPECT_EQ(asked.read_foam(0), fresh.read_foam(0)) << time_s;
  }
}

// Fails if foam jumps where the loop closes. 3.3 s hold 13.2 steps of 0.25 s: there are 14 of 3.3 / 14 s.
// With a decay of 0.8 s the past 3.2 s fit; with 5 s the same instants come up several times.
TEST_F(FoamTest, RepeatsWithTheLoop) {
  for (const double decay_s : {0.8, 5.0}) {
    OceanParameters looping = parameters();
    looping.loop_period_s = 3.3;
    looping.foam.decay_s = decay_s;
    Ocean asked = sea(looping), other = sea(looping);
    for (const double time_s : {0.0, 0.1, 1.7, 3.2}) {
      asked.at(time_s);
      const std::vector<float> foam = asked.read_foam(0);
      expect_foam(foam, defined_foam(other, 0, time_s, 3.3 / 14.0), time_s);
      asked.at(time_s + 3.3);
      EXPECT_EQ(asked.read_foam(0), foam) << time_s;
    }
  }
}

// Fails if foam appears on a calm sea, or does not fade: with an onset at which nothing ever foams it is 0.
TEST_F(FoamTest, NoneWithoutFolding) {
  OceanParameters calm = parameters();
  calm.foam.onset_jacobian = -9.0;
  Ocean ocean = sea(calm);
  ocean.at(1.0);
  for (const float foam : ocean.read_foam(0)) EXPECT_EQ(foam, 0.0f);
}

// Fails if values that each are in range together ask for millions of past instants: minutes and gigabytes
// for one frame, without a word. 100 steps are allowed, also where products are rounded (100 x 0.011 < 1.1).
TEST_F(FoamTest, RefusesMoreInstantsThanAFrameHasTimeFor) {
  OceanParameters wanted = parameters();
  wanted.foam.decay_s = 3600.0;
  wanted.foam.step_s = 0.25;
  const std::string hint = test::expect_error(
      ErrorKind::bad_input, "at most 100 steps, found 3600 s in steps of 0.25 s", [&] { sea(wanted); });
  EXPECT_THAT(hint, testing::HasSubstr("foam.step_s to 36 or more, or foam.decay_s to 25 or less"));
  wanted.foam.step_s = 35.9;
  test::expect_error(ErrorKind::bad_input, "ocean.foam", [&] { sea(wanted); });
  for (const auto& [decay_s, step_s] : {std::pair{3600.0, 36.0}, {1.1, 0.011}, {0.01, 60.0}}) {
    wanted.foam.decay_s = decay_s;
    wanted.foam.step_s = step_s;
    EXPECT_NO_THROW(sea(wanted));
  }
}

// Fails if coverages are kept that the device cannot hold beside the maps. At most 401 instants of four
// cascades of 4096 need 53.8 GB: refused by a device of 100 GB, taken by one of 110 GB.
TEST(FoamMemoryTest, IsAtMostHalfOfTheDevice) {
  ocl::DeviceInfo device;
  device.name = "Small Device";
  device.global_memory_bytes = 100'000'000'000;
  constexpr std::size_t texels = std::size_t{4} * 4096 * 4096;
  test::expect_error(ErrorKind::out_of_memory,
                     "401 past instants need 53.8 GB on Small Device, expected at most 50 GB",
                     [&] { require_foam_fits(device, 401, texels); });
  device.global_memory_bytes = 110'000'000'000;
  EXPECT_NO_THROW(require_foam_fits(device, 401, texels));
}

}  // namespace
}  // namespace offing::ocean

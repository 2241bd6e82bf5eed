// The device's fields against the sea's definition, summed in double precision, for both kernel shapes.
//
// Bound on the relative root mean square error of a field: the transform's 1.3e-6 (log2(n^2) u (1 + 4 sqrt
// 2) u, n = 64, u = 2^-24, Higham 2002), 3e-7 of the phase (polynomials 1e-7, fraction of a tick 2e-7) and
// 3e-7 of the amplitudes (logarithm, sine and root to 4 ulp). Measured 1.6e-7 ... 4.4e-7. Gate 1e-6: two lost
// bits fail.
#include "tests/ocean/ocean_reference.h"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "host/ocean/cascades.h"
#include "host/ocean/spectrum_parameters.h"
#include "tests/ocean/drawn_modes.h"
#include "tests/ocean/field_statistics.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::ocean {
namespace {

constexpr double gate = 1e-6;

struct Case {
  const char* shape;  // OFFING_SHAPE
  int size;
  double depth_m;
  double capillary_length_m;
  std::optional<double> loop_period_s;
};

constexpr double deep_m = std::numeric_limits<double>::infinity();

SeaSpectrum wind_sea(const Case& test_case) {
  SpectrumParameters parameters;
  parameters.wind_speed_mps = 8.0;
  parameters.fetch_m = 30e3;
  parameters.spreading.direction_rad = 0.7;
  parameters.dispersion.depth_m = test_case.depth_m;
  parameters.dispersion.capillary_length_m = test_case.capillary_length_m;
  return make_sea_spectrum(parameters);
}

class OceanReferenceTest : public testing::TestWithParam<Case> {
 protected:
  OceanReferenceTest()
      : shape_("OFFING_SHAPE", GetParam().shape),
        spectrum_(wind_sea(GetParam())),
        parameters_{.size = GetParam().size,
                    .cascades = cascades_from_patches(std::vector{90.0, 17.0}, GetParam().size),
                    .seed = 0x123456789abcdefULL,
                    .choppiness = 0.8,
                    .loop_period_s = GetParam().loop_period_s},
        sea_(ocl::Device::open(), spectrum_, parameters_),
        reference_(spectrum_.dispersion, parameters_, {sea_.mode_variance(0), sea_.mode_variance(1)}) {}

  void expect_surface(int cascade, double time_s, Frequencies frequencies, double tolerance) {
    const SurfaceFields found = sea_.read_surface(cascade);
    const ReferenceSurface expected = reference_.surface(cascade, time_s, frequencies);
    const auto expect = [&](const char* name, const std::vector<float>& field, const RealField& reference) {
      const double error = relative_error(field, reference);
      EXPECT_LT(error, tolerance) << name << " of cascade " << cascade << " at " << time_s << " s";
      worst_ = std::max(worst_, error);
    };
    expect("dx", found.displacement_x, expected.displacement_x);
    expect("h", found.displacement_y, expected.displacement_y);
    expect("dz", found.displacement_z, expected.displacement_z);
    expect("dh/dx", found.slope_x, expected.slope_x);
    expect("dh/dz", found.slope_z, expected.slope_z);
    expect("d dx/dx", found.gradient_xx, expected.gradient_xx);
    expect("d dx/dz", found.gradient_xz, expected.gradient_xz);
    expect("d dz/dz", found.gradient_zz, expected.gradient_zz);
    expect("J", found.jacobian, expected.jacobian);
    expect("eigenvalue", found.jacobian_min_eigenvalue, expected.jacobian_min_eigenvalue);
  }

  void expect_velocity(int cascade, double time_s, double depth_m, double tolerance) {
    const VelocityFields found = sea_.read_velocity(cascade, depth_m);
    const ReferenceVelocity expected = reference_.velocity(cascade, time_s, depth_m, Frequencies::of_clock);
    const auto expect = [&](const char* name, const std::vector<float>& field, const RealField& reference) {
      const double error = relative_error(field, reference);
      EXPECT_LT(error, tolerance) << name << " of cascade " << cascade << " at " << time_s << " s, "
                                  << depth_m << " m deep";
      worst_ = std::max(worst_, error);
    };
    expect("vx", found.x, expected.x);
    expect("vy", found.y, expected.y);
    expect("vz", found.z, expected.z);
  }

  test::ScopedEnvironment shape_;
  SeaSpectrum spectrum_;
  OceanParameters parameters_;
  Ocean sea_;
  OceanReference reference_;
  double worst_ = 0.0;
};

// Fails if a sign, factor, symmetry, packing or index of any field is wrong, at any time within the clock's
// four years: 1e7 s is four months, where a phase kept in single precision would be off by whole turns.
TEST_P(OceanReferenceTest, IsTheSumOfItsWaves) {
  for (const double time_s : {0.0, -3.3, 12345.678, 1e7}) {
    sea_.at(time_s);
    for (const int cascade : {0, 1}) expect_surface(cascade, time_s, Frequencies::of_clock, gate);
  }
  RecordProperty("worst", std::to_string(worst_ * 1e9) + "e-9");
}

class VelocityReferenceTest : public OceanReferenceTest {};

// Fails if velocities at the surface or in depth, deep or shallow, are not those of linear theory.
TEST_P(VelocityReferenceTest, IsTheSumOfItsWaves) {
  for (const double time_s : {0.0, 12345.678}) {
    sea_.at(time_s);
    for (const double depth_m : {0.0, 0.4, 3.0}) {
      expect_velocity(0, time_s, depth_m, gate);
    }
    expect_velocity(1, time_s, 0.1, gate);
  }
  RecordProperty("worst", std::to_string(worst_ * 1e9) + "e-9");
}

std::string case_name(const testing::TestParamInfo<Case>& info) {
  return std::string(info.param.shape) + "_" + std::to_string(info.param.size);
}

INSTANTIATE_TEST_SUITE_P(
    Seas, OceanReferenceTest,
    testing::Values(Case{"strip", 16, deep_m, 0.0, {}}, Case{"group", 16, deep_m, 0.0, 17.3},
                    Case{"group", 32, 4.0, 2.73e-3, {}}, Case{"strip", 64, 4.0, 2.73e-3, {}},
                    Case{"group", 64, 12.0, 0.0, {}}, Case{"strip", 256, deep_m, 0.0, 17.3}),
    case_name);

INSTANTIATE_TEST_SUITE_P(Seas, VelocityReferenceTest,
                         testing::Values(Case{"group", 32, 4.0, 2.73e-3, {}},
                                         Case{"strip", 64, 12.0, 0.0, {}},
                                         Case{"strip", 256, deep_m, 0.0, 17.3}),
                         case_name);

// Fails if frequencies are rounded more coarsely than stated: each is within 2^-28 Hz of the dispersion
// relation, so that waves are late by at most 2 pi 2^-28 t rad, uniformly distributed: 1/sqrt(3) of that in
// the mean square, 8.1e-6 at t = 600 s, 0.1 s of a wave's time in four months.
TEST(OceanFrequencyTest, FollowTheDispersionRelation) {
  const SeaSpectrum spectrum = make_sea_spectrum({});
  const OceanParameters parameters{.size = 64, .cascades = cascades_from_patches(std::vector{200.0}, 64)};
  Ocean sea(ocl::Device::open(), spectrum, parameters);
  const OceanReference reference(spectrum.dispersion, parameters, {sea.mode_variance(0)});
  for (const double time_s : {0.0, 20.0, 600.0}) {
    sea.at(time_s);
    const double late_rad = 2.0 * std::numbers::pi * 0x1p-28 * time_s / std::sqrt(3.0);
    EXPECT_LT(relative_error(sea.read_surface(0).displacement_y,
                             reference.surface(0, time_s, Frequencies::exact).displacement_y),
              gate + 2.0 * late_rad)
        << time_s;
  }
}

// Fails if waves faster than the usual 32 ticks a second are slowed down to 32 Hz, or turned round: ripples
// of 2 mm, 240 Hz, on a patch of 2 cm. Looked at by horizontal displacement and velocity: the height of such
// waves is 1000 times smaller than the gradient that shares its transform, which costs it two bits.
TEST(OceanFrequencyTest, RipplesKeepTheirFrequency) {
  SpectrumParameters breeze;
  breeze.wind_speed_mps = 2.0;
  breeze.fetch_m = 100.0;
  breeze.dispersion.capillary_length_m = 2.73e-3;
  const SeaSpectrum spectrum = make_sea_spectrum(breeze);
  const OceanParameters parameters{.size = 16, .cascades = {{0.02, 0.0, 1e9}}};
  Ocean sea(ocl::Device::open(), spectrum, parameters);
  const OceanReference reference(spectrum.dispersion, parameters, {sea.mode_variance(0)});
  EXPECT_GT(reference.fastest_hz(), 200.0);
  for (const double time_s : {0.0, 0.01, 8.3, 1e4}) {
    sea.at(time_s);
    EXPECT_LT(relative_error(sea.read_surface(0).displacement_x,
                             reference.surface(0, time_s, Frequencies::of_clock).displacement_x),
              gate)
        << time_s;
    EXPECT_LT(
        relative_error(sea.read_velocity(0).y, reference.velocity(0, time_s, 0.0, Frequencies::of_clock).y),
        gate)
        << time_s;
  }
}

// Fails if any wave of the smallest patches is further from the dispersion relation than half a step of the
// clock, or shares the clock's last rate with faster ones.
TEST(OceanFrequencyTest, NoPatchIsTooSmallForTheClock) {
  SpectrumParameters breeze;
  breeze.dispersion.capillary_length_m = 2.73e-3;
  const SeaSpectrum spectrum = make_sea_spectrum(breeze);
  const ocl::Device device = ocl::Device::open();
  for (const double patch_length_m : {0.01, 0.5, 2.0}) {
    constexpr int size = 512;
    const WaveModes modes(device, spectrum, std::vector{Cascade{patch_length_m, 0.0, 1e9}}, size, {});
    const std::vector<std::uint32_t> rates = drawn_rates(modes, 0);
    double worst = 0.0;
    for (int row = 0; row < size / 2; ++row) {
      for (int column = row == 0 ? 1 : 0; column < size / 2; ++column) {
        const double omega_radps = spectrum.dispersion.omega_radps(2.0 * std::numbers::pi / patch_length_m *
                                                                   std::hypot(column, row));
        const double rate = rates[static_cast<std::size_t>(row * size + column)];
        worst = std::max(worst, std::abs(rate - omega_radps / modes.radps_per_rate()));
      }
    }
    EXPECT_LE(worst, 0.5 + 1e-6) << patch_length_m;
  }
}

}  // namespace
}  // namespace offing::ocean

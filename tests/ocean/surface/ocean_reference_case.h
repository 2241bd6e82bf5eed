#pragma once

#include <limits>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "host/ocean/spectrum/spectrum_parameters.h"
#include "host/ocean/surface/cascades.h"
#include "tests/ocean/surface/field_statistics.h"
#include "tests/ocean/surface/ocean_reference.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::ocean {

/// A sea that is compared with its reference.
struct Case {
  const char* shape;  // OFFING_SHAPE
  int size;
  double depth_m;
  double capillary_length_m;
  std::optional<double> loop_period_s;
};

inline constexpr double deep_m = std::numeric_limits<double>::infinity();

inline SeaSpectrum wind_sea(const Case& test_case) {
  SpectrumParameters parameters;
  parameters.wind_speed_mps = 8.0;
  parameters.fetch_m = 30e3;
  parameters.spreading.direction_rad = 0.7;
  parameters.dispersion.depth_m = test_case.depth_m;
  parameters.dispersion.capillary_length_m = test_case.capillary_length_m;
  return make_sea_spectrum(parameters);
}

/// A sea of two cascades beside its reference.
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

class VelocityReferenceTest : public OceanReferenceTest {};

/// Such as "simd_64".
inline std::string case_name(const testing::TestParamInfo<Case>& info) {
  return std::string(info.param.shape) + "_" + std::to_string(info.param.size);
}

}  // namespace offing::ocean

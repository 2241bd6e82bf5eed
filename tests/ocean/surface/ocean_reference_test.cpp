// The device's fields against the sea's definition, summed in double precision, for both kernel shapes.
//
// Bound on the relative root mean square error of a field: the transform's 1.3e-6 (log2(n^2) u (1 + 4 sqrt
// 2) u, n = 64, u = 2^-24, Higham 2002), 3e-7 of the phase (polynomials 1e-7, fraction of a tick 2e-7) and
// 3e-7 of the amplitudes (logarithm, sine and root to 4 ulp). Measured 1.6e-7 ... 4.4e-7. Gate 1e-6: two lost
// bits fail.
//
// The seas are in ocean_reference_seas.cpp and, those that take a minute to compile, in short_rows_test.cpp.
#include "tests/ocean/surface/ocean_reference_case.h"

namespace offing::ocean {
namespace {

constexpr double gate = 1e-6;

// Fails if a sign, factor, symmetry, packing or index of any field is wrong, at any time within the clock's
// four years: 1e7 s is four months, where a phase kept in single precision would be off by whole turns.
TEST_P(OceanReferenceTest, IsTheSumOfItsWaves) {
  for (const double time_s : {0.0, -3.3, 12345.678, 1e7}) {
    sea_.at(time_s);
    for (const int cascade : {0, 1}) expect_surface(cascade, time_s, Frequencies::of_clock, gate);
  }
  RecordProperty("worst", std::to_string(worst_ * 1e9) + "e-9");
}

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

}  // namespace
}  // namespace offing::ocean

// Seas of short rows against their reference (ocean_reference_test.cpp). Apart, because PoCL
// compiles these kernels for a minute.
#include "tests/ocean/surface/ocean_reference_case.h"

namespace offing::ocean {

INSTANTIATE_TEST_SUITE_P(ShortRows, OceanReferenceTest,
                         testing::Values(Case{"simd", 64, 4.0, 2.73e-3, {}},
                                         Case{"workgroup", 64, 12.0, 0.0, {}}),
                         case_name);

INSTANTIATE_TEST_SUITE_P(ShortRows, VelocityReferenceTest, testing::Values(Case{"simd", 64, 12.0, 0.0, {}}),
                         case_name);

}  // namespace offing::ocean

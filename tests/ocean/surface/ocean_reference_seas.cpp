// The seas that each run of the tests compares with their reference. Few sizes, because
// each is a program to compile.
#include "tests/ocean/surface/ocean_reference_case.h"

namespace offing::ocean {

INSTANTIATE_TEST_SUITE_P(Seas, OceanReferenceTest,
                         testing::Values(Case{"simd", 16, deep_m, 0.0, {}},
                                         Case{"workgroup", 16, deep_m, 0.0, 17.3},
                                         Case{"workgroup", 32, 4.0, 2.73e-3, {}},
                                         Case{"simd", 256, deep_m, 0.0, 17.3}),
                         case_name);

INSTANTIATE_TEST_SUITE_P(Seas, VelocityReferenceTest,
                         testing::Values(Case{"workgroup", 32, 4.0, 2.73e-3, {}},
                                         Case{"simd", 256, deep_m, 0.0, 17.3}),
                         case_name);

}  // namespace offing::ocean

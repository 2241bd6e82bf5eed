// The kernels that turn modes into fields, of every size and family, against sums of their modes in double
// precision (host/ocean/surface/mode_self_test.h). The gate is that of tests/fft/fft2d_test.cpp, 3 u
// log2(n^2)^(1/2) with u = 2^-24, for each pair of fields.
#include <algorithm>
#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/ocean/surface/mode_self_test.h"
#include "host/ocean/surface/surface_maps.h"
#include "host/ocean/surface/velocity_map.h"
#include "kernels/shared/mode_layout.h"

namespace offing::ocean {
namespace {

struct Case {
  ocl::KernelShape family;
  int size;
};

std::string name_of(const Case& c) {
  return (c.family == ocl::KernelShape::simd ? "simd_" : "workgroup_") + std::to_string(c.size);
}
void PrintTo(const Case& c, std::ostream* out) {
  *out << name_of(c);
}
std::string case_name(const testing::TestParamInfo<Case>& info) {
  return name_of(info.param);
}

class TransformSizesTest : public testing::TestWithParam<Case> {
 protected:
  double error_of(const ModeTransform::Request& request) {
    const auto [family, size] = GetParam();
    const int columns = std::max(size / 2, MODE_BLOCK_COLUMNS);
    const ModeTransform::Grid grid{.size = size, .columns = columns, .cascade_count = 1};
    ModeTransform transform(device_, grid, request, family);
    const double error = request.self_test(device_, transform, grid, request);
    RecordProperty(std::string(request.second_kernel), std::to_string(error * 1e9) + "e-9");
    return error;
  }
  double gate_of_a_pair() const { return 3.0 * 0x1p-24 * std::sqrt(2.0 * std::log2(GetParam().size)); }

  ocl::Device device_ = ocl::Device::open();
};

// Fails where a compiler gets a family wrong at any size. Intel's did, wherever fields were negated values of
// each other (host/ocl/quirks.cpp).
TEST_P(TransformSizesTest, SurfaceIsTheSumOfItsModes) {
  EXPECT_LT(error_of(surface_request()), 4.0 * gate_of_a_pair());
}

TEST_P(TransformSizesTest, VelocityIsTheSumOfItsModes) {
  EXPECT_LT(error_of(velocity_request()), 2.0 * gate_of_a_pair());
}

std::vector<Case> all_cases() {
  std::vector<Case> cases;
  for (int size = 64; size <= 4096; size *= 2) cases.push_back({ocl::KernelShape::simd, size});
  for (int size = 16; size <= 4096; size *= 2) cases.push_back({ocl::KernelShape::workgroup, size});
  return cases;
}
INSTANTIATE_TEST_SUITE_P(Sizes, TransformSizesTest, testing::ValuesIn(all_cases()), case_name);

}  // namespace
}  // namespace offing::ocean

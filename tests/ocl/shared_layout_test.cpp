#include "tests/ocl/shared_layout.h"

#include <gtest/gtest.h>

#include "kernels/shared/ocean_params.h"
#include "kernels/shared/random.h"

namespace offing {
namespace {

using Layout = std::vector<std::size_t>;

// Each fails if a compiler pads a struct that both sides read: parameters would arrive shifted.
TEST(SharedLayoutTest, PhiloxBlock) {
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/random.h", "PhiloxBlock", {"v", "v[3]"}),
            (Layout{sizeof(PhiloxBlock), offsetof(PhiloxBlock, v), offsetof(PhiloxBlock, v[3])}));
}

TEST(SharedLayoutTest, OceanSpectrumParams) {
  using S = OceanSpectrumParams;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/ocean_params.h", "OceanSpectrumParams",
                                {"wavenumber_step_radpm", "k_min_radpm", "k_max_radpm", "log_k_first",
                                 "log_k_step", "wavenumber_count", "direction_count", "padding"}),
            (Layout{sizeof(S), offsetof(S, wavenumber_step_radpm), offsetof(S, k_min_radpm),
                    offsetof(S, k_max_radpm), offsetof(S, log_k_first), offsetof(S, log_k_step),
                    offsetof(S, wavenumber_count), offsetof(S, direction_count), offsetof(S, padding)}));
}

TEST(SharedLayoutTest, OceanComposeParams) {
  using S = OceanComposeParams;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/ocean_params.h", "OceanComposeParams",
                                {"origin_column", "origin_row", "column_step", "row_step", "cascade_count",
                                 "columns", "rows", "padding"}),
            (Layout{sizeof(S), offsetof(S, origin_column), offsetof(S, origin_row), offsetof(S, column_step),
                    offsetof(S, row_step), offsetof(S, cascade_count), offsetof(S, columns),
                    offsetof(S, rows), offsetof(S, padding)}));
}

}  // namespace
}  // namespace offing

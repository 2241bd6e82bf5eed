// Structs that host and device both read: each test fails if a compiler pads one, so that parameters would
// arrive shifted. All members are of 4 bytes: the first, some and the last.
#include <gtest/gtest.h>

#include "kernels/shared/highlights.h"
#include "tests/ocl/shared_layout.h"

namespace offing {
namespace {

using Layout = std::vector<std::size_t>;

TEST(HighlightLayoutTest, HighlightLight) {
  using S = HighlightLight;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/highlights.h", "HighlightLight",
                                {"eye", "source.nearness", "axis_x", "up_z", "is_constant"}),
            (Layout{sizeof(S), offsetof(S, eye), offsetof(S, source) + offsetof(HighlightSource, nearness),
                    offsetof(S, axis_x), offsetof(S, up_z), offsetof(S, is_constant)}));
}

TEST(HighlightLayoutTest, HighlightRecord) {
  using S = HighlightRecord;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/highlights.h", "HighlightRecord",
                                {"face", "orientation", "weight_0", "normal_x", "e_max_z", "k_min_perm"}),
            (Layout{sizeof(S), offsetof(S, face), offsetof(S, orientation), offsetof(S, weight_0),
                    offsetof(S, normal_x), offsetof(S, e_max_z), offsetof(S, k_min_perm)}));
}

}  // namespace
}  // namespace offing

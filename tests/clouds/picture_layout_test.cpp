// Structs of pictures of clouds that host and device both read: each test fails if a compiler pads one.
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "kernels/shared/cloud_picture.h"
#include "tests/ocl/shared_layout.h"

namespace offing {
namespace {

using Layout = std::vector<std::size_t>;

TEST(PictureLayoutTest, CloudPictureParams) {
  using S = CloudPictureParams;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/cloud_picture.h", "CloudPictureParams",
                                {"forward_x", "half_width", "count", "sun_x", "relief"}),
            (Layout{sizeof(S), offsetof(S, forward_x), offsetof(S, half_width), offsetof(S, count),
                    offsetof(S, sun_x), offsetof(S, relief)}));
}

TEST(PictureLayoutTest, CloudPuff) {
  using S = CloudPuff;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/cloud_picture.h", "CloudPuff",
                                {"radius_m", "right_x", "relief_x", "texels", "distance_m"}),
            (Layout{sizeof(S), offsetof(S, radius_m), offsetof(S, right_x), offsetof(S, relief_x),
                    offsetof(S, texels), offsetof(S, distance_m)}));
}

}  // namespace
}  // namespace offing

// Structs of clouds that host and device both read: each test fails if a compiler pads one.
#include <gtest/gtest.h>

#include "kernels/shared/cloud_field.h"
#include "kernels/shared/cloud_image_params.h"
#include "kernels/shared/cloud_light_params.h"
#include "kernels/shared/cloud_motion.h"
#include "kernels/shared/cloud_shadow.h"
#include "kernels/shared/clouds.h"
#include "tests/ocl/shared_layout.h"

namespace offing {
namespace {

using Layout = std::vector<std::size_t>;

TEST(CloudLayoutTest, CloudMotionParams) {
  using S = CloudMotionParams;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/cloud_motion.h", "CloudMotionParams",
                                {"drift_x", "lean", "seed_low", "sphere_x", "cloud"}),
            (Layout{sizeof(S), offsetof(S, drift_x), offsetof(S, lean), offsetof(S, seed_low),
                    offsetof(S, sphere_x), offsetof(S, cloud)}));
}

TEST(CloudLayoutTest, CloudOctave) {
  using S = CloudOctave;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/cloud_field.h", "CloudOctave",
                                {"origin_x", "step", "amplitude"}),
            (Layout{sizeof(S), offsetof(S, origin_x), offsetof(S, step), offsetof(S, amplitude)}));
}

TEST(CloudLayoutTest, CloudFieldParams) {
  using S = CloudFieldParams;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/cloud_field.h", "CloudFieldParams",
                                {"cell_m", "octaves", "bricks_y"}),
            (Layout{sizeof(S), offsetof(S, cell_m), offsetof(S, octaves), offsetof(S, bricks_y)}));
}

TEST(CloudLayoutTest, CloudParticle) {
  using S = CloudParticle;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/clouds.h", "CloudParticle",
                                {"x", "optical_mass", "texture", "turn"}),
            (Layout{sizeof(S), offsetof(S, x), offsetof(S, optical_mass), offsetof(S, texture),
                    offsetof(S, turn)}));
}

TEST(CloudLayoutTest, CloudImageParams) {
  using S = CloudImageParams;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/cloud_image_params.h", "CloudImageParams",
                                {"forward_x", "half_width", "count", "sun_x", "relief"}),
            (Layout{sizeof(S), offsetof(S, forward_x), offsetof(S, half_width), offsetof(S, count),
                    offsetof(S, sun_x), offsetof(S, relief)}));
}

TEST(CloudLayoutTest, CloudBillboard) {
  using S = CloudBillboard;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/cloud_image_params.h", "CloudBillboard",
                                {"radius_m", "right_x", "relief_x", "texels", "distance_m"}),
            (Layout{sizeof(S), offsetof(S, radius_m), offsetof(S, right_x), offsetof(S, relief_x),
                    offsetof(S, texels), offsetof(S, distance_m)}));
}

TEST(CloudLayoutTest, CloudGrid) {
  using S = CloudGrid;
  EXPECT_EQ(
      test::device_layout(ocl::Device::open(), "shared/cloud_light_params.h", "CloudGrid",
                          {"cell_x", "first", "size_x", "room"}),
      (Layout{sizeof(S), offsetof(S, cell_x), offsetof(S, first), offsetof(S, size_x), offsetof(S, room)}));
}

TEST(CloudLayoutTest, CloudScattering) {
  using S = CloudScattering;
  EXPECT_EQ(
      test::device_layout(ocl::Device::open(), "shared/cloud_light_params.h", "CloudScattering",
                          {"absorbed_share", "forward_share", "phase_table"}),
      (Layout{sizeof(S), offsetof(S, absorbed_share), offsetof(S, forward_share), offsetof(S, phase_table)}));
}

TEST(CloudLayoutTest, CloudLightParams) {
  using S = CloudLightParams;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/cloud_light_params.h", "CloudLightParams",
                                {"suns", "sun_count", "sky_red", "ground_blue"}),
            (Layout{sizeof(S), offsetof(S, suns), offsetof(S, sun_count), offsetof(S, sky_red),
                    offsetof(S, ground_blue)}));
}

TEST(CloudLayoutTest, CloudShadowParams) {
  using S = CloudShadowParams;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/cloud_shadow.h", "CloudShadowParams",
                                {"middle_x", "right_x", "up_x", "sun_x", "half_width"}),
            (Layout{sizeof(S), offsetof(S, middle_x), offsetof(S, right_x), offsetof(S, up_x),
                    offsetof(S, sun_x), offsetof(S, half_width)}));
}

}  // namespace
}  // namespace offing

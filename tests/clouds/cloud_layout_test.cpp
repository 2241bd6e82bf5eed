// Structs of clouds that host and device both read: each test fails if a compiler pads one.
#include <gtest/gtest.h>

#include "kernels/shared/cloud_field.h"
#include "kernels/shared/cloud_motion.h"
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

}  // namespace
}  // namespace offing

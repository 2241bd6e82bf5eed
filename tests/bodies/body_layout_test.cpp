// Structs that host and device both read: each test fails if a compiler pads one, so that parameters would
// arrive shifted. All members are of 4 bytes: the first, some and the last.
#include <gtest/gtest.h>

#include "kernels/shared/bodies.h"
#include "tests/ocl/shared_layout.h"

namespace offing {
namespace {

using Layout = std::vector<std::size_t>;

Layout on_device(const char* name, const std::vector<std::string>& members) {
  return test::device_layout(ocl::Device::open(), "shared/bodies.h", name, members);
}

TEST(BodyLayoutTest, BodyState) {
  using S = BodyState;
  EXPECT_EQ(on_device("BodyState",
                      {"tile_x", "x_m", "turn_w", "spin_x_radps", "displaced_m3", "flow_z_mps", "shift_z_m"}),
            (Layout{sizeof(S), offsetof(S, tile_x), offsetof(S, x_m), offsetof(S, turn_w),
                    offsetof(S, spin_x_radps), offsetof(S, displaced_m3), offsetof(S, flow_z_mps),
                    offsetof(S, shift_z_m)}));
}

TEST(BodyLayoutTest, BodyShape) {
  using S = BodyShape;
  EXPECT_EQ(
      on_device("BodyShape", {"propeller_vertex", "mass_kg", "inverse_xx", "wave_damping", "rudder_lift",
                              "lift_moment_by_yaw", "first_velocity_float", "wave_step_radps"}),
      (Layout{sizeof(S), offsetof(S, propeller_vertex), offsetof(S, mass_kg), offsetof(S, inverse_xx),
              offsetof(S, wave_damping), offsetof(S, rudder_lift), offsetof(S, lift_moment_by_yaw),
              offsetof(S, first_velocity_float), offsetof(S, wave_step_radps)}));
}

TEST(BodyLayoutTest, BodyDrive) {
  using S = BodyDrive;
  EXPECT_EQ(on_device("BodyDrive", {"thrust_n", "tile_x", "heading_rad", "lost_wave_share"}),
            (Layout{sizeof(S), offsetof(S, thrust_n), offsetof(S, tile_x), offsetof(S, heading_rad),
                    offsetof(S, lost_wave_share)}));
}

TEST(BodyLayoutTest, BodyReport) {
  using S = BodyReport;
  EXPECT_EQ(on_device("BodyReport", {"displaced_m3", "wetted_m2", "forces"}),
            (Layout{sizeof(S), offsetof(S, displaced_m3), offsetof(S, wetted_m2), offsetof(S, forces)}));
}

TEST(BodyLayoutTest, BodyMooring) {
  using S = BodyMooring;
  EXPECT_EQ(on_device("BodyMooring", {"x_m", "anchor_tile_x", "anchor_x_m", "stiffness_npm"}),
            (Layout{sizeof(S), offsetof(S, x_m), offsetof(S, anchor_tile_x), offsetof(S, anchor_x_m),
                    offsetof(S, stiffness_npm)}));
}

TEST(BodyLayoutTest, BodyWater) {
  using S = BodyWater;
  EXPECT_EQ(on_device("BodyWater", {"density_kgpm3", "wind_x_mps", "step_s", "steps", "first_step"}),
            (Layout{sizeof(S), offsetof(S, density_kgpm3), offsetof(S, wind_x_mps), offsetof(S, step_s),
                    offsetof(S, steps), offsetof(S, first_step)}));
}

TEST(BodyLayoutTest, BodyWave) {
  using S = BodyWave;
  EXPECT_EQ(on_device("BodyWave", {"phase", "phase_by_tile_z", "amplitude_m", "direction_rad"}),
            (Layout{sizeof(S), offsetof(S, phase), offsetof(S, phase_by_tile_z), offsetof(S, amplitude_m),
                    offsetof(S, direction_rad)}));
}

TEST(BodyLayoutTest, BodySea) {
  using S = BodySea;
  EXPECT_EQ(on_device("BodySea", {"waves", "question", "middle_s"}),
            (Layout{sizeof(S), offsetof(S, waves), offsetof(S, question), offsetof(S, middle_s)}));
}

TEST(BodyLayoutTest, HullPress) {
  using S = HullPress;
  EXPECT_EQ(on_device("HullPress", {"first_column", "columns", "along", "map_columns", "factor"}),
            (Layout{sizeof(S), offsetof(S, first_column), offsetof(S, columns), offsetof(S, along),
                    offsetof(S, map_columns), offsetof(S, factor)}));
}

}  // namespace
}  // namespace offing

#include "tests/ocl/shared_layout.h"

#include <gtest/gtest.h>

#include "kernels/shared/atmosphere_params.h"
#include "kernels/shared/ocean_params.h"
#include "kernels/shared/random.h"
#include "kernels/shared/sky_params.h"
#include "kernels/shared/trochoids.h"

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
                                 "columns", "rows", "trochoid_pitch", "adds_slopes"}),
            (Layout{sizeof(S), offsetof(S, origin_column), offsetof(S, origin_row), offsetof(S, column_step),
                    offsetof(S, row_step), offsetof(S, cascade_count), offsetof(S, columns),
                    offsetof(S, rows), offsetof(S, trochoid_pitch), offsetof(S, adds_slopes)}));
}

// Members of the two below are all floats: the first, some and the last.
TEST(SharedLayoutTest, AtmosphereParams) {
  using S = AtmosphereParams;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/atmosphere_params.h", "AtmosphereParams",
                                {"ground_radius_m", "rayleigh_scattering_0_perm", "ozone_absorption_3_perm",
                                 "ozone_peak_m", "sun_angular_radius_rad", "ground_albedo_3"}),
            (Layout{sizeof(S), offsetof(S, ground_radius_m), offsetof(S, rayleigh_scattering_0_perm),
                    offsetof(S, ozone_absorption_3_perm), offsetof(S, ozone_peak_m),
                    offsetof(S, sun_angular_radius_rad), offsetof(S, ground_albedo_3)}));
}

TEST(SharedLayoutTest, SkyParams) {
  using S = SkyParams;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/sky_params.h", "SkyParams",
                                {"sun_direction_x", "eye_altitude_m", "sun_angular_radius_rad", "red_0_klx",
                                 "green_0_klx", "blue_0_klx", "blue_3_klx"}),
            (Layout{sizeof(S), offsetof(S, sun_direction_x), offsetof(S, eye_altitude_m),
                    offsetof(S, sun_angular_radius_rad), offsetof(S, red_0_klx), offsetof(S, green_0_klx),
                    offsetof(S, blue_0_klx), offsetof(S, blue_3_klx)}));
}

TEST(SharedLayoutTest, TrochoidRing) {
  using S = TrochoidRing;
  EXPECT_EQ(test::device_layout(
                ocl::Device::open(), "shared/trochoids.h", "TrochoidRing",
                {"centre_x_m", "centre_z_m", "wavelength_m", "ring_radius_m", "amplitude_m", "phase"}),
            (Layout{sizeof(S), offsetof(S, centre_x_m), offsetof(S, centre_z_m), offsetof(S, wavelength_m),
                    offsetof(S, ring_radius_m), offsetof(S, amplitude_m), offsetof(S, phase)}));
}

TEST(SharedLayoutTest, TrochoidGrid) {
  using S = TrochoidGrid;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/trochoids.h", "TrochoidGrid",
                                {"spacing_x_m", "spacing_z_m", "rows", "pitch", "wave_count", "wave_pitch",
                                 "ring_count", "padding"}),
            (Layout{sizeof(S), offsetof(S, spacing_x_m), offsetof(S, spacing_z_m), offsetof(S, rows),
                    offsetof(S, pitch), offsetof(S, wave_count), offsetof(S, wave_pitch),
                    offsetof(S, ring_count), offsetof(S, padding)}));
}

}  // namespace
}  // namespace offing

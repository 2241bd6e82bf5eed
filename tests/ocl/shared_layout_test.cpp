#include "tests/ocl/shared_layout.h"

#include <gtest/gtest.h>

#include "kernels/shared/atmosphere_params.h"
#include "kernels/shared/gerstner_params.h"
#include "kernels/shared/ocean_params.h"
#include "kernels/shared/query_params.h"
#include "kernels/shared/random.h"
#include "kernels/shared/shoal_params.h"
#include "kernels/shared/sky_params.h"
#include "kernels/shared/swash_params.h"
#include "kernels/shared/wake.h"

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
                                 "columns", "rows", "gerstner_pitch", "adds_slopes"}),
            (Layout{sizeof(S), offsetof(S, origin_column), offsetof(S, origin_row), offsetof(S, column_step),
                    offsetof(S, row_step), offsetof(S, cascade_count), offsetof(S, columns),
                    offsetof(S, rows), offsetof(S, gerstner_pitch), offsetof(S, adds_slopes)}));
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

TEST(SharedLayoutTest, GerstnerRing) {
  using S = GerstnerRing;
  EXPECT_EQ(test::device_layout(
                ocl::Device::open(), "shared/gerstner_params.h", "GerstnerRing",
                {"centre_x_m", "centre_z_m", "wavelength_m", "ring_radius_m", "amplitude_m", "phase"}),
            (Layout{sizeof(S), offsetof(S, centre_x_m), offsetof(S, centre_z_m), offsetof(S, wavelength_m),
                    offsetof(S, ring_radius_m), offsetof(S, amplitude_m), offsetof(S, phase)}));
}

TEST(SharedLayoutTest, GerstnerRingInTile) {
  using S = GerstnerRingInTile;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/gerstner_params.h", "GerstnerRingInTile",
                                {"tile_x", "tile_z", "ring"}),
            (Layout{sizeof(S), offsetof(S, tile_x), offsetof(S, tile_z), offsetof(S, ring)}));
}

TEST(SharedLayoutTest, SurfaceQueryPointAndSample) {
  using P = SurfaceQueryPoint;
  EXPECT_EQ(
      test::device_layout(ocl::Device::open(), "shared/query_params.h", "SurfaceQueryPoint",
                          {"tile_x", "tile_z", "x_m", "z_m"}),
      (Layout{sizeof(P), offsetof(P, tile_x), offsetof(P, tile_z), offsetof(P, x_m), offsetof(P, z_m)}));
  using S = SurfaceQuerySample;
  EXPECT_EQ(
      test::device_layout(ocl::Device::open(), "shared/query_params.h", "SurfaceQuerySample",
                          {"height_m", "slope_x", "slope_z", "residual_m", "velocity_x_mps", "velocity_y_mps",
                           "velocity_z_mps", "pressure_pa", "acceleration_x_mps2", "error_rms_m"}),
      (Layout{sizeof(S), offsetof(S, height_m), offsetof(S, slope_x), offsetof(S, slope_z),
              offsetof(S, residual_m), offsetof(S, velocity_x_mps), offsetof(S, velocity_y_mps),
              offsetof(S, velocity_z_mps), offsetof(S, pressure_pa), offsetof(S, acceleration_x_mps2),
              offsetof(S, error_rms_m)}));
  using M = SurfaceQueryShifted;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/query_params.h", "SurfaceQueryShifted",
                                {"water", "shift_x_m", "shift_z_m"}),
            (Layout{sizeof(M), offsetof(M, water), offsetof(M, shift_x_m), offsetof(M, shift_z_m)}));
}

// Of the waves the first members, some and the last.
TEST(SharedLayoutTest, SurfaceQueryWaveAndParams) {
  using W = SurfaceQueryWave;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/query_params.h", "SurfaceQueryWave",
                                {"phase", "tile_rest_x", "rate", "turns_x_perm", "height_m", "shift_x_m",
                                 "slope_z", "velocity_y_mps", "band"}),
            (Layout{sizeof(W), offsetof(W, phase), offsetof(W, tile_rest_x), offsetof(W, rate),
                    offsetof(W, turns_x_perm), offsetof(W, height_m), offsetof(W, shift_x_m),
                    offsetof(W, slope_z), offsetof(W, velocity_y_mps), offsetof(W, band)}));
  using S = SurfaceQueryParams;
  EXPECT_EQ(test::device_layout(
                ocl::Device::open(), "shared/query_params.h", "SurfaceQueryParams",
                {"tile_step_high", "tile_step_low", "patches_per_m", "texels_per_m", "cascade_count",
                 "ring_count", "has_flow", "tolerance_m", "sample_floats", "mode_radius"}),
            (Layout{sizeof(S), offsetof(S, tile_step_high), offsetof(S, tile_step_low),
                    offsetof(S, patches_per_m), offsetof(S, texels_per_m), offsetof(S, cascade_count),
                    offsetof(S, ring_count), offsetof(S, has_flow), offsetof(S, tolerance_m),
                    offsetof(S, sample_floats), offsetof(S, mode_radius)}));
}

TEST(SharedLayoutTest, ShoalMap) {
  using S = ShoalMap;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/shoal_params.h", "ShoalMap",
                                {"tile_x", "origin_x_m", "columns_per_m", "columns", "rows", "deepest_m"}),
            (Layout{sizeof(S), offsetof(S, tile_x), offsetof(S, origin_x_m), offsetof(S, columns_per_m),
                    offsetof(S, columns), offsetof(S, rows), offsetof(S, deepest_m)}));
}

TEST(SharedLayoutTest, SwashParams) {
  using S = SwashParams;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/swash_params.h", "SwashParams",
                                {"kx_radpm", "kz_radpm[7]", "phase_rad", "setup_m", "period_s"}),
            (Layout{sizeof(S), offsetof(S, kx_radpm), offsetof(S, kz_radpm[7]), offsetof(S, phase_rad),
                    offsetof(S, setup_m), offsetof(S, period_s)}));
}

TEST(SharedLayoutTest, Wakes) {
  using H = WakeHullShape;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/wake.h", "WakeHullShape",
                                {"x_m", "cosine", "half_length_m", "draught_m", "shape"}),
            (Layout{sizeof(H), offsetof(H, x_m), offsetof(H, cosine), offsetof(H, half_length_m),
                    offsetof(H, draught_m), offsetof(H, shape)}));
  using G = WakeGrid;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/wake.h", "WakeGrid",
                                {"size", "first_column", "first_row", "cell_m"}),
            (Layout{sizeof(G), offsetof(G, size), offsetof(G, first_column), offsetof(G, first_row),
                    offsetof(G, cell_m)}));
  using L = WakeLayer;
  EXPECT_EQ(test::device_layout(
                ocl::Device::open(), "shared/wake.h", "WakeLayer",
                {"tile_x", "origin_x_m", "cells_per_m", "size", "first_row", "first_texel", "decay_radpm"}),
            (Layout{sizeof(L), offsetof(L, tile_x), offsetof(L, origin_x_m), offsetof(L, cells_per_m),
                    offsetof(L, size), offsetof(L, first_row), offsetof(L, first_texel),
                    offsetof(L, decay_radpm)}));
  using S = WakeSamples;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/wake.h", "WakeSamples",
                                {"column", "row", "column_step", "row_step"}),
            (Layout{sizeof(S), offsetof(S, column), offsetof(S, row), offsetof(S, column_step),
                    offsetof(S, row_step)}));
}

TEST(SharedLayoutTest, GerstnerGrid) {
  using S = GerstnerGrid;
  EXPECT_EQ(test::device_layout(ocl::Device::open(), "shared/gerstner_params.h", "GerstnerGrid",
                                {"spacing_x_m", "spacing_z_m", "rows", "pitch", "wave_count", "wave_pitch",
                                 "ring_count", "padding"}),
            (Layout{sizeof(S), offsetof(S, spacing_x_m), offsetof(S, spacing_z_m), offsetof(S, rows),
                    offsetof(S, pitch), offsetof(S, wave_count), offsetof(S, wave_pitch),
                    offsetof(S, ring_count), offsetof(S, padding)}));
}

}  // namespace
}  // namespace offing

// Structs that host and device both read: each test fails if a compiler pads one, so that parameters would
// arrive shifted. All members are of 4 bytes: the first, some and the last.
#include <gtest/gtest.h>

#include "kernels/shared/sun_blocks.h"
#include "kernels/shared/terrain.h"
#include "kernels/shared/terrain_canopy.h"
#include "kernels/shared/terrain_light_params.h"
#include "kernels/shared/terrain_look.h"
#include "kernels/shared/terrain_materials.h"
#include "kernels/shared/terrain_relief.h"
#include "kernels/shared/terrain_sight.h"
#include "tests/ocl/shared_layout.h"

namespace offing {
namespace {

using Layout = std::vector<std::size_t>;

Layout layout_of(const char* header, const char* type, const std::vector<std::string>& members) {
  return test::device_layout(ocl::Device::open(), header, type, members);
}

TEST(TerrainLayoutTest, TerrainField) {
  using S = TerrainField;
  EXPECT_EQ(
      layout_of("shared/terrain.h", "TerrainField", {"columns", "top_level", "highest_m", "cells_per_m_z"}),
      (Layout{sizeof(S), offsetof(S, columns), offsetof(S, top_level), offsetof(S, highest_m),
              offsetof(S, cells_per_m_z)}));
}

TEST(TerrainLayoutTest, TerrainView) {
  using S = TerrainView;
  EXPECT_EQ(layout_of("shared/terrain.h", "TerrainView", {"cell_x", "height_m", "right_x", "height_px"}),
            (Layout{sizeof(S), offsetof(S, cell_x), offsetof(S, height_m), offsetof(S, right_x),
                    offsetof(S, height_px)}));
}

TEST(TerrainLayoutTest, TerrainRay) {
  using S = TerrainRay;
  EXPECT_EQ(layout_of("shared/terrain.h", "TerrainRay", {"cell_x", "height_m", "along_x_rest", "limit_m"}),
            (Layout{sizeof(S), offsetof(S, cell_x), offsetof(S, height_m), offsetof(S, along_x_rest),
                    offsetof(S, limit_m)}));
}

TEST(TerrainLayoutTest, TerrainHit) {
  using S = TerrainHit;
  EXPECT_EQ(layout_of("shared/terrain.h", "TerrainHit", {"distance_m", "kind", "u", "normal_x", "steps"}),
            (Layout{sizeof(S), offsetof(S, distance_m), offsetof(S, kind), offsetof(S, u),
                    offsetof(S, normal_x), offsetof(S, steps)}));
}

TEST(TerrainLayoutTest, TerrainLight) {
  using S = TerrainLight;
  EXPECT_EQ(
      layout_of(
          "shared/terrain_light_params.h", "TerrainLight",
          {"sun_red_klx", "rayleigh_red_perm", "aerosol_perm", "snow_line_m", "swash", "still_water_m"}),
      (Layout{sizeof(S), offsetof(S, sun_red_klx), offsetof(S, rayleigh_red_perm), offsetof(S, aerosol_perm),
              offsetof(S, snow_line_m), offsetof(S, swash), offsetof(S, still_water_m)}));
}

TEST(TerrainLayoutTest, TerrainMaterial) {
  using S = TerrainMaterial;
  EXPECT_EQ(layout_of("shared/terrain_materials.h", "TerrainMaterial",
                      {"like", "roughness", "edge_m", "of_broad", "patches"}),
            (Layout{sizeof(S), offsetof(S, like), offsetof(S, roughness), offsetof(S, edge_m),
                    offsetof(S, of_broad), offsetof(S, patches)}));
}

TEST(TerrainLayoutTest, TerrainCanopy) {
  using S = TerrainCanopy;
  EXPECT_EQ(layout_of("shared/terrain_canopy.h", "TerrainCanopy",
                      {"height_m", "lowest_m", "patch_log2", "patches", "map_columns", "map_a_cell_z"}),
            (Layout{sizeof(S), offsetof(S, height_m), offsetof(S, lowest_m), offsetof(S, patch_log2),
                    offsetof(S, patches), offsetof(S, map_columns), offsetof(S, map_a_cell_z)}));
}

TEST(TerrainLayoutTest, TerrainSight) {
  using S = TerrainSight;
  EXPECT_EQ(layout_of("shared/terrain_sight.h", "TerrainSight",
                      {"cell_x", "eye_above_m", "bend_x_m", "radius_share_z"}),
            (Layout{sizeof(S), offsetof(S, cell_x), offsetof(S, eye_above_m), offsetof(S, bend_x_m),
                    offsetof(S, radius_share_z)}));
}

TEST(TerrainLayoutTest, BlockSun) {
  using S = BlockSun;
  EXPECT_EQ(
      layout_of("shared/sun_blocks.h", "BlockSun", {"tangent", "share", "z", "beam_0", "hours", "next"}),
      (Layout{sizeof(S), offsetof(S, tangent), offsetof(S, share), offsetof(S, z), offsetof(S, beam_0),
              offsetof(S, hours), offsetof(S, next)}));
}

TEST(TerrainLayoutTest, SunBlock) {
  using S = SunBlock;
  EXPECT_EQ(layout_of("shared/sun_blocks.h", "SunBlock", {"middle_column", "middle_row", "middle_m"}),
            (Layout{sizeof(S), offsetof(S, middle_column), offsetof(S, middle_row), offsetof(S, middle_m)}));
}

TEST(TerrainLayoutTest, TerrainRelief) {
  using S = TerrainRelief;
  EXPECT_EQ(
      layout_of("shared/terrain_relief.h", "TerrainRelief", {"levels", "middle_z", "eye_cell_x", "discs"}),
      (Layout{sizeof(S), offsetof(S, levels), offsetof(S, middle_z), offsetof(S, eye_cell_x),
              offsetof(S, discs)}));
}

TEST(TerrainLayoutTest, TerrainReliefDisc) {
  using S = TerrainReliefDisc;
  EXPECT_EQ(layout_of("shared/terrain_relief.h", "TerrainReliefDisc", {"south_m", "radius_m", "share"}),
            (Layout{sizeof(S), offsetof(S, south_m), offsetof(S, radius_m), offsetof(S, share)}));
}

TEST(TerrainLayoutTest, TerrainLook) {
  using S = TerrainLook;
  EXPECT_EQ(layout_of("shared/terrain_look.h", "TerrainLook",
                      {"colour_columns", "colour_left", "open_sky_stride", "hidden_above_m"}),
            (Layout{sizeof(S), offsetof(S, colour_columns), offsetof(S, colour_left),
                    offsetof(S, open_sky_stride), offsetof(S, hidden_above_m)}));
}

}  // namespace
}  // namespace offing

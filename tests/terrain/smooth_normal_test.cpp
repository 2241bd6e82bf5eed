// Normals that go on smoothly from patch to patch, of rays and of places, against each other and a formula.
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/terrain/field/height_field.h"
#include "host/terrain/field/terrain_posts.h"
#include "tests/terrain/example_maps.h"

namespace offing {
namespace {

using terrain::CastMethod;
using terrain::HitNormals;
using terrain::smooth_normal_at;
using terrain::terrain_at;

HeightMap host_map(const test::HeightMap& map) {
  HeightMap result;
  result.columns = map.grid.columns;
  result.rows = map.grid.rows;
  result.spacing_x_m = map.grid.spacing_x_m;
  result.spacing_z_m = map.grid.spacing_z_m;
  result.heights_m = map.heights_m;
  return result;
}

test::HeightMap hills() {
  return test::valleys({.columns = 130, .rows = 97, .spacing_x_m = 8.0, .spacing_z_m = 10.0});
}

// Rays down on hills by every method and shape of cast: the normal there is that of double precision. Slopes
// of floats of 100 m are right to 1e-5 over a cell, and the place to 1e-3 cells where a slope changes by 0.5
// a cell: gate 1e-3. Fails if the option does nothing: patches' own normals are off by 0.1.
TEST(SmoothNormalTest, RaysFindWhatDoublePrecisionFinds) {
  const test::HeightMap map = hills();
  const HeightMap on_host = host_map(map);
  terrain::HeightField field(ocl::Device::open(), map.grid, map.heights_m);
  std::vector<terrain::Ray> rays;
  for (int i = 0; i < 200; ++i) {
    const double x_m = 8.0 * 129.0 * std::fmod(0.7548776662 * (i + 1), 1.0);
    const double z_m = 10.0 * 96.0 * std::fmod(0.5698402910 * (i + 1), 1.0);
    rays.push_back({.origin_m = {x_m, 500.0, z_m}});
  }
  for (const CastMethod method : {CastMethod::parity, CastMethod::paper}) {
    const std::vector<terrain::RayHit> hits = field.cast(rays, method, HitNormals::smooth);
    const std::vector<terrain::RayHit> of_patches = field.cast(rays, method);
    double largest = 0.0;
    for (std::size_t i = 0; i < rays.size(); ++i) {
      const glm::dvec3 expected = *smooth_normal_at(on_host, rays[i].origin_m.x, rays[i].origin_m.z);
      const glm::dvec3 found(hits[i].normal_x, hits[i].normal_y, hits[i].normal_z);
      EXPECT_LE(glm::length(found - expected), 1e-3) << i;
      EXPECT_EQ(hits[i].distance_m, of_patches[i].distance_m);
      const glm::dvec3 of_patch(of_patches[i].normal_x, of_patches[i].normal_y, of_patches[i].normal_z);
      largest = std::max(largest, glm::length(of_patch - expected));
    }
    EXPECT_GT(largest, 0.05);
  }
}

// Pictures have the same option.
TEST(SmoothNormalTest, PicturesFindWhatDoublePrecisionFinds) {
  const test::HeightMap map = hills();
  const HeightMap on_host = host_map(map);
  const ocl::Device device = ocl::Device::open();
  terrain::HeightField field(device, map.grid, map.heights_m);
  const Camera camera{.eye_m = {500.0, 200.0, 500.0}, .pitch_rad = -1.2, .width_px = 32, .height_px = 20};
  ocl::Buffer<TerrainHit> hits(device, 32 * 20, "hits");
  field.cast(camera, hits, CastMethod::parity, HitNormals::smooth);
  for (const TerrainHit& hit : hits.read()) {
    ASSERT_EQ(hit.kind, TERRAIN_SURFACE);
    const double u = static_cast<double>(hit.u), v = static_cast<double>(hit.v);
    const glm::dvec3 expected = *smooth_normal_at(on_host, 8.0 * (hit.cell_x + u), 10.0 * (hit.cell_z + v));
    EXPECT_LE(glm::length(glm::dvec3(hit.normal_x, hit.normal_y, hit.normal_z) - expected), 1e-3);
  }
}

// Across the border of two patches the smooth normal goes on, where that of the patches jumps. On a plane
// both are the plane's; beyond the map there is none.
TEST(SmoothNormalTest, HasNoCreases) {
  const HeightMap map = host_map(hills());
  double jump = 0.0;
  for (int column = 1; column < 129; ++column) {
    const double x_m = 8.0 * column, z_m = 333.0;
    const glm::dvec3 west = *smooth_normal_at(map, x_m - 1e-6, z_m),
                     east = *smooth_normal_at(map, x_m + 1e-6, z_m);
    EXPECT_LE(glm::length(west - east), 1e-5) << column;
    jump = std::max(jump, glm::length(terrain_at(map, x_m - 1e-6, z_m)->normal -
                                      terrain_at(map, x_m + 1e-6, z_m)->normal));
  }
  EXPECT_GT(jump, 0.05);

  HeightMap plane = map;
  for (int row = 0; row < plane.rows; ++row) {
    for (int column = 0; column < plane.columns; ++column) {
      plane.heights_m[plane.index(column, row)] =
          4.0f * static_cast<float>(column) - 2.5f * static_cast<float>(row);
    }
  }
  const glm::dvec3 normal = glm::normalize(glm::dvec3(-0.5, 1.0, 0.25));
  for (const double x_m : {0.0, 77.7, 8.0 * 129.0}) {
    EXPECT_LE(glm::length(*smooth_normal_at(plane, x_m, 960.0) - normal), 1e-12) << x_m;
  }
  EXPECT_FALSE(smooth_normal_at(map, -0.1, 5.0));
  EXPECT_FALSE(smooth_normal_at(map, 5.0, std::numeric_limits<double>::quiet_NaN()));
}

}  // namespace
}  // namespace offing

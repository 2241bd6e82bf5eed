// A million rays against the double-precision walk, over made and over real maps, and how many steps they
// take.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <gtest/gtest.h>

#include "host/io/height_maps/read_height_map.h"
#include "host/terrain/field/height_field.h"
#include "tests/terrain/ray_comparison.h"

namespace offing {
namespace {

using terrain::CastMethod;

constexpr std::size_t rays_a_made_map = 150'000, rays_a_real_map = 50'000;

void print_steps(const std::string& name, const char* method, const std::vector<terrain::RayHit>& hits) {
  double sum = 0.0;
  std::size_t up_to_16 = 0, over_80 = 0;
  for (const terrain::RayHit& hit : hits) {
    sum += hit.steps;
    up_to_16 += hit.steps <= 16 ? 1 : 0;
    over_80 += hit.steps > 80 ? 1 : 0;
  }
  const auto count = static_cast<double>(hits.size());
  std::printf("%s, %s: %.2f steps in the mean, %.1f %% of rays within 16, %.2f %% over 80\n", name.c_str(),
              method, sum / count, 100.0 * static_cast<double>(up_to_16) / count,
              100.0 * static_cast<double>(over_80) / count);
}

double mean_steps(const std::vector<terrain::RayHit>& hits) {
  double sum = 0.0;
  for (const terrain::RayHit& hit : hits) sum += hit.steps;
  return sum / static_cast<double>(hits.size());
}

struct NamedMethod {
  const char* name;
  CastMethod method;
};
constexpr NamedMethod methods[] = {{"default", CastMethod::parity},
                                   {"paper", CastMethod::paper},
                                   {"pdm", CastMethod::pdm},
                                   {"linear", CastMethod::linear}};

/// All methods on the same rays, so that they agree within twice what each is off the reference. Rays whose
/// answer rounding decides must be rare on ground that is not level.
void check(const ocl::Device& device, const test::HeightMap& map, std::size_t count) {
  terrain::HeightField field(device, map.grid, map.heights_m);
  const std::vector<terrain::Ray> rays = test::example_rays(map, count, 31);
  const std::vector<test::ReferenceHit> references = test::reference_hits(map, rays);
  std::vector<double> steps;
  for (const auto& [name, method] : methods) {
    const std::vector<terrain::RayHit> hits = field.cast(rays, method);
    const test::RayComparison comparison = test::compare(map, rays, references, hits);
    std::printf("%s, %s: %zu rays, %zu hits, worst %.2g cells, %zu decided by rounding\n", map.name.c_str(),
                name, count, comparison.hits, comparison.worst_cells, comparison.touching);
    print_steps(map.name, name, hits);
    EXPECT_EQ(comparison.wrong, 0u) << map.name << ", " << name;
    if (map.name != "flat" && map.name != "ramp") {
      EXPECT_LE(comparison.touching, count / 10'000) << map.name << ", " << name;
    }
    steps.push_back(mean_steps(hits));
  }
  EXPECT_LT(steps[0], steps[1]) << map.name;
}

// Fails if any of 900,000 rays over generated terrain is off by more than 1e-3 cells across the surface, hits
// what it should miss, or misses what it should hit.
TEST(MillionRaysTest, OverMadeTerrain) {
  const ocl::Device device = ocl::Device::open();
  for (const test::HeightMap& map : test::example_maps()) check(device, map, rays_a_made_map);
}

// The same over real ground: 100,000 rays.
TEST(MillionRaysTest, OverRealTerrain) {
  const char* folder = std::getenv("OFFING_TEST_DATA");
  if (folder == nullptr) GTEST_SKIP() << "OFFING_TEST_DATA is not set";
  const ocl::Device device = ocl::Device::open();
  for (const char* name : {"S33W071.tif", "N48W125.hgt.zip"}) {
    const HeightMap map = read_height_map(std::filesystem::path(folder) / "terrain" / name).map;
    check(device, {name, terrain::post_grid(map), map.heights_m}, rays_a_real_map);
  }
}

}  // namespace
}  // namespace offing

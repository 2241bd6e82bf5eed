// SPDX-License-Identifier: GPL-3.0-or-later (as all of offing-bench)
// How many steps the rays of pictures take, on the cameras of the benchmark (T11 of docs/sources.md).
#include "tests/bench/terrain/terrain_steps.h"

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/bench/terrain/terrain_maps.h"

namespace offing::bench {
namespace {

const StepStatistics& steps_of(const CameraSteps& steps, const std::string& method) {
  for (const CameraSteps::Method& of : steps.methods) {
    if (of.name == method) return of.steps;
  }
  throw std::logic_error(method);
}

/// What holds on every map; fly first, then walk.
std::vector<CameraSteps> checked_steps(const NamedMap& named) {
  const ocl::Device device = ocl::Device::open();
  terrain::HeightField field(device, terrain::post_grid(named.map), named.map.heights_m);
  std::vector<CameraSteps> all = camera_steps(field, device, terrain_cameras(named.map));
  for (const CameraSteps& steps : all) {
    for (const auto& [method, of, ms] : steps.methods) {
      std::printf("%s %s %s: %s; %.0f ms\n", named.name.c_str(), steps.way.c_str(), method.c_str(),
                  text_of(of).c_str(), ms);
    }
    std::printf("%s %s: methods differ by %.2g cells and in %zu of %zu rays\n", named.name.c_str(),
                steps.way.c_str(), steps.worst_cells, steps.unlike, steps.rays);
    EXPECT_LT(steps_of(steps, "parity").mean, steps_of(steps, "paper").mean)
        << named.name << " " << steps.way;
    // Measured 1.6e-4; touching rays may hit or miss.
    EXPECT_LT(steps.worst_cells, 1e-3) << named.name << " " << steps.way;
    EXPECT_LE(steps.unlike, steps.rays / 10'000) << named.name << " " << steps.way;
  }
  EXPECT_LT(steps_of(all[1], "parity").over_80, 0.05) << named.name;
  return all;
}

// Fails if the walk takes more steps than the paper's, if more than 5 % of the rays of walkers take over 80,
// or fewer than 90 % of those that fly over smooth ground are done within 16.
TEST(TerrainSteps, OverMadeValleys) {
  const std::vector<CameraSteps> coarse = checked_steps(valleys(256));
  EXPECT_GE(steps_of(coarse[0], "parity").within_16, 0.9);
  checked_steps(valleys(1024));
  checked_steps(valleys(4096));
}

// The same over all real maps.
TEST(TerrainSteps, OverRealTerrain) {
  if (std::getenv("OFFING_TEST_DATA") == nullptr) GTEST_SKIP() << "OFFING_TEST_DATA is not set";
  for (const NamedMap& map : real_maps(RealMaps::all)) {
    const std::vector<CameraSteps> steps = checked_steps(map);
    if (map.name == "cape_flattery") {
      EXPECT_GE(steps_of(steps[0], "parity").within_16, 0.9);
    }
  }
}

}  // namespace
}  // namespace offing::bench

// SPDX-License-Identifier: GPL-3.0-or-later (as all of offing-bench)
// How many steps the rays of pictures take, on the cameras of the benchmark (T11 of docs/sources.md).
#include "tests/bench/terrain_steps.h"

#include <cstdio>
#include <cstdlib>

#include <gtest/gtest.h>

#include "tests/bench/terrain_maps.h"

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
    for (const std::string& line : text_of(named.name, steps)) std::printf("%s\n", line.c_str());
    EXPECT_LT(steps_of(steps, "parity").mean, steps_of(steps, "paper").mean)
        << named.name << " " << steps.way;
    // Distances beyond 2^13 cells are rounded by more than 1e-3 cells, and touching rays may hit or miss.
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
TEST(TerrainSteps, OverRealGround) {
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

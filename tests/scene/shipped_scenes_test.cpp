// The scenes that are shipped: each loads, and its sea does not repeat where one could see it.
#include <algorithm>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "host/ocean/surface/ocean.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/prepare/sea.h"
#include "host/scene/schema/unused_parameters.h"
#include "tests/ocean/surface/tile_correlation.h"

namespace offing::scene {
namespace {

struct ShippedSea {
  explicit ShippedSea(const std::string& name)
      : sea(prepare_sea(load_scene(std::filesystem::path(OFFING_SCENES) / (name + ".toml")))),
        ocean(ocl::Device::open(), sea.spectrum, sea.parameters) {}

  double k_max_radpm() const { return sea.parameters.cascades.back().k_max_radpm; }

  // Of strips: Gerstner waves are drawn in full from 4 samples a wavelength.
  double spacing_m() const {
    const double shortest_m =
        sea.gerstner_choice ? 2.0 * std::numbers::pi / sea.gerstner_choice->split_radpm : 20.0;
    return shortest_m / 4.5;
  }

  Sea sea;
  ocean::Ocean ocean;
};

/// How much more than its spectrum a sea agrees with itself, at the worst of all lags of its patches.
struct Excess {
  double height = -1.0, slope = -1.0;              ///< by the energies of its waves
  double strip_height = -1.0, strip_slope = -1.0;  ///< of the surface at one time
};

Excess excess_of(ShippedSea& shipped) {
  Excess worst;
  for (const ocean::Lag& lag : ocean::tile_lags(shipped.sea.parameters.cascades)) {
    const ocean::Correlation asked =
        correlation_of_spectrum(shipped.sea.spectrum, shipped.k_max_radpm(), lag);
    const ocean::Correlation found = correlation_of_modes(shipped.ocean, lag);
    const ocean::Correlation strip = correlation_of_strips(shipped.ocean, lag, shipped.spacing_m());
    worst.height = std::max(worst.height, found.height - asked.height);
    worst.slope = std::max(worst.slope, found.slope - asked.slope);
    worst.strip_height = std::max(worst.strip_height, strip.height - asked.height);
    worst.strip_slope = std::max(worst.strip_slope, strip.slope - asked.slope);
  }
  testing::Test::RecordProperty("height", std::to_string(worst.height));
  testing::Test::RecordProperty("slope", std::to_string(worst.slope));
  testing::Test::RecordProperty("strip_height", std::to_string(worst.strip_height));
  testing::Test::RecordProperty("strip_slope", std::to_string(worst.strip_slope));
  return worst;
}

// Fails if a hybrid sea shows its patches. A patch repeats in full, so that height agrees with itself a patch
// further on by the patch's share of the energy; the Gerstner waves, 64 waves that never repeat, add what
// their phases happen to have in common there, 0.09 of their share on average (1 / sqrt(2 * 64)), 0.13 to
// 0.33 at the worst of some twenty lags, as the seed has it. Gates are those promised: nobody sees a fifth in
// height, or half in the slopes, of which each cascade has its share. Of the strips some hundred waves are
// independent.
class HybridSceneTest : public testing::TestWithParam<const char*> {};

TEST_P(HybridSceneTest, HidesItsPatches) {
  ShippedSea shipped(GetParam());
  const Excess excess = excess_of(shipped);
  EXPECT_LE(excess.height, 0.2);
  EXPECT_LE(excess.slope, 0.5);
  EXPECT_LE(excess.strip_height, 0.2);
  EXPECT_LE(excess.strip_slope, 0.5);
}

INSTANTIATE_TEST_SUITE_P(Scenes, HybridSceneTest, testing::Values("calm", "rough", "storm", "buoy"),
                         [](const auto& scene) { return std::string(scene.param); });

// Fails if the statistics above cannot see a patch: this scene has one for all its waves.
TEST(SpectralOnlyScene, ShowsItsPatch) {
  ShippedSea shipped("spectral_only");
  ASSERT_EQ(shipped.sea.parameters.cascades.size(), 1u);
  const Excess excess = excess_of(shipped);
  EXPECT_GT(excess.height, 0.8);
  EXPECT_GT(excess.strip_height, 0.8);
  EXPECT_GT(excess.strip_slope, 0.8);
}

// Fails if patches of a scene line up after a few repetitions: lengths in a ratio p / q with q <= 8, to one
// part in a thousand, within which eight repetitions stay together.
TEST(ShippedScenes, HavePatchesWithoutSimpleRatios) {
  int pairs = 0;
  for (const auto& entry : std::filesystem::directory_iterator(OFFING_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    const Scene scene = load_scene(entry.path());
    if (!scene.has_sea()) continue;
    const Sea sea = prepare_sea(scene);
    const auto& cascades = sea.parameters.cascades;
    for (std::size_t i = 0; i < cascades.size(); ++i)
      for (std::size_t j = i + 1; j < cascades.size(); ++j, ++pairs)
        for (int q = 1; q <= 8; ++q) {
          const double p = q * cascades[i].patch_length_m / cascades[j].patch_length_m;
          EXPECT_GT(std::abs(p / std::round(p) - 1.0), 1e-4)
              << entry.path().filename() << ": " << cascades[i].patch_length_m << " m is " << std::round(p)
              << " / " << q << " of " << cascades[j].patch_length_m << " m";
        }
  }
  EXPECT_GE(pairs, 12);
}

// Fails if a scene of meshes that is shipped cannot be shown, names a light that it does not have, or says
// what changes nothing.
TEST(ShippedScenes, HaveMeshesThatCanBeShown) {
  int meshes = 0;
  for (const auto& entry : std::filesystem::directory_iterator(OFFING_SCENES)) {
    if (entry.path().extension() != ".toml") continue;
    const Scene scene = load_scene(entry.path());
    if (scene.meshes.empty()) continue;
    meshes += static_cast<int>(prepare_meshes(scene).size());
    EXPECT_NO_THROW(prepare_images(scene)) << entry.path();
    const std::vector<std::string> unused =
        scene.has_sea() ? unused_parameters(scene, prepare_sea(scene, Warnings::left_out))
                        : unused_parameters(scene);
    EXPECT_EQ(unused, std::vector<std::string>{}) << entry.path();
  }
  EXPECT_GE(meshes, 4);
}

}  // namespace
}  // namespace offing::scene

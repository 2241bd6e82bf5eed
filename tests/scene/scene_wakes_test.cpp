// Wakes of a scene, as a world gets them.
#include "host/scene/prepare/scene_wakes.h"

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"

namespace offing::scene {
namespace {

Scene scene_with(const std::string& more) {
  return parse_scene("version = 1\n[world]\nseed = 7\n[ocean]\nsize = 32\n" + more, "a.toml", "");
}

// Fails if a hull does not move as its scene says: straight ahead, by keyframes; or the window does not
// follow it.
TEST(SceneWakes, HullsMoveAndWindowsFollow) {
  const Scene scene = scene_with(
      "[[ocean.wake]]\nlength_m = 50\nbehind_m = 10\nmethod = \"verlet\"\nspeed_mps = 3\n"
      "[[ocean.wake.hull]]\nx_m = 5\nspeed_mps = 4\nheading_deg = 90\n"
      "[[ocean.wake.hull]]\nx_m = { keys = [{ t = 0, value = 1 }, { t = 2, value = 3 }], interpolation = "
      "\"linear\" }\n"
      "[[ocean.wake]]\ncentre = \"place\"\nx_m = -4\nz_m = 6\n");
  const auto wakes = prepare_wakes(scene, {.depth_m = 12.0});
  ASSERT_EQ(wakes.size(), 2u);
  EXPECT_EQ(wakes[0].parameters.method, ocean::WakeMethod::verlet);
  EXPECT_EQ(wakes[0].parameters.dispersion.depth_m, 12.0);
  EXPECT_EQ(wakes[0].parameters.rain.seed, 7u);
  const ocean::WakeForcing forcing = wakes[0].forcing_at(1.0);
  ASSERT_EQ(forcing.hulls.size(), 2u);
  EXPECT_NEAR(forcing.hulls[0].x_m, 5.0, 1e-9);
  EXPECT_NEAR(forcing.hulls[0].z_m, 4.0, 1e-9);
  EXPECT_NEAR(forcing.hulls[1].x_m, 2.0, 1e-9);
  EXPECT_NEAR(forcing.centre.z_m, -6.0, 1e-9);
  EXPECT_EQ(wakes[1].forcing_at(1.0).centre.x_m, -4.0);
  EXPECT_EQ(wakes[1].forcing_at(1.0).centre.z_m, 6.0);
}

// Fails if windows that cannot share a texture come through, or it is not told which one differs.
TEST(SceneWakes, WindowsHaveTheSameCells) {
  const Scene scene = scene_with("[[ocean.wake]]\n[[ocean.wake]]\ncells = 128\n");
  EXPECT_THAT([&] { prepare_wakes(scene, {}); },
              testing::ThrowsMessage<Error>(
                  testing::AllOf(testing::StartsWith("a.toml:8:"), testing::EndsWith("256, got 128"))));
}

}  // namespace
}  // namespace offing::scene

#include "present/view_options.h"

#include <array>

#include <gtest/gtest.h>

#include "host/scene/file/scene_file.h"

namespace offing::present {
namespace {

// Fails if another scene than the shipped world is shown where none is named.
TEST(ViewOptionsTest, ShowTheWorldWhereNoSceneIsNamed) {
  const std::array<const char*, 1> bare{"offing-view"};
  const auto shown = read_view_options(1, bare.data());
  ASSERT_TRUE(shown.has_value());
  EXPECT_EQ(shown->scene_name, "world");
  const scene::Scene world = scene::load_scene(OFFING_SOURCES "/scenes/world.toml");
  ASSERT_TRUE(world.terrain.fractal.island_radius_m.has_value());
  EXPECT_EQ(shown->scene.terrain.fractal.island_radius_m, world.terrain.fractal.island_radius_m);
  EXPECT_EQ(shown->scene.meshes.size(), world.meshes.size());
  EXPECT_EQ(shown->scene.bodies.size(), world.bodies.size());
  EXPECT_TRUE(shown->scene.has_clouds());
}

}  // namespace
}  // namespace offing::present

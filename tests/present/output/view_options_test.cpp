#include "present/view_options.h"

#include <array>
#include <filesystem>
#include <fstream>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/command_line/installed_scenes.h"
#include "host/scene/file/scene_file.h"
#include "tests/cli/option_faults.h"

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

// Fails if an installed scene is not found by its name, or if saving edits in the window would overwrite it.
TEST(ViewOptionsTest, FindInstalledScenesAndDoNotSaveThere) {
  const std::filesystem::path scenes = installed_scenes();  // beside the folder of this test's program
  ASSERT_FALSE(scenes.empty());
  std::filesystem::create_directories(scenes);
  const std::filesystem::path scene = scenes / "only_installed.toml";
  std::ofstream(scene) << "version = 1\n[wind]\nspeed_mps = 7.25\n";
  const std::array<const char*, 2> arguments{"offing-view", "only_installed.toml"};
  const auto options = read_view_options(2, arguments.data());
  std::filesystem::remove(scene);
  ASSERT_TRUE(options.has_value());
  EXPECT_EQ(options->scene.wind.wind_speed_mps, 7.25);
  EXPECT_EQ(options->scene_name, "only_installed");
  EXPECT_EQ(options->scene_file, "");
}

// Fails if a name of a transfer path is misread, or an unknown one taken for some path.
TEST(ViewOptionsTest, NameTransferPaths) {
  for (const TransferPath path : all_transfer_paths) {
    const std::string name(to_string(path));
    const std::array<const char*, 3> arguments{"offing-view", "--transfer", name.c_str()};
    EXPECT_EQ(read_view_options(3, arguments.data())->transfer, path);
  }
  const std::array<const char*, 3> unknown{"offing-view", "--transfer", "pbo"};
  EXPECT_THROW(read_view_options(3, unknown.data()), Error);
}

// Fails if an option takes a number or makes a choice without a row of a schema.
TEST(ViewOptionsTest, HaveRows) {
  test::OptionReport report;
  visit_command_line([&](const CLI::App& app) {
    report =
        test::report_options(app, {"SCENE", "device", "output", "record", "sources", "terrain", "video"});
  });
  EXPECT_THAT(report.faults, testing::IsEmpty());
  EXPECT_THAT(report.numbers,
              testing::SizeIs(6));  // --keep-fps, --render-scale, --ui-scale, --time, --fps, --samples
}

}  // namespace
}  // namespace offing::present

#include "present/window/scene_list.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_files.h"
#include "present/window/scene_sources.h"
#include "present/window/scene_switch.h"
#include "tests/io/temporary_folder.h"

namespace offing::present {
namespace {

// Fails if a scene that comes with the program is none, or reads a file that need not be where the program
// runs; if the first one is not among them.
TEST(SceneListTest, ShippedScenesNeedNoFiles) {
  const SceneList list;
  ASSERT_GE(list.shipped().size(), 20u);
  for (const ListedScene& each : list.shipped()) {
    const OpenedScene opened = shipped_scene(each.name);
    EXPECT_TRUE(scene::files_of(opened.scene).empty()) << each.name;
    EXPECT_EQ(opened.name + ".toml", each.name);
  }
  EXPECT_EQ(shipped_source(first_scene).name, "world.toml");
  EXPECT_THROW(shipped_source("nowhere.toml"), Error);
}

// Fails if files beside a scene are missing, out of order or no scenes; if a folder that is gone is a fault;
// if a scene without a file takes the list away.
TEST(SceneListTest, FilesBesideTheOpenOne) {
  TemporaryFolder folder;
  for (const char* name : {"b.toml", "a 바다.toml", "c.txt"}) std::ofstream(folder.path() / name) << "";
  std::filesystem::create_directory(folder.path() / "d.toml");
  SceneList list;
  list.follow(folder.path() / "b.toml");
  const std::vector<ListedScene> expected{{"a 바다.toml", folder.path() / "a 바다.toml"},
                                          {"b.toml", folder.path() / "b.toml"}};
  EXPECT_EQ(list.beside(), expected);
  std::ofstream(folder.path() / "c.toml") << "";
  list.follow({});
  EXPECT_EQ(list.beside().size(), 3u);
  list.follow(folder.path() / "gone" / "b.toml");
  EXPECT_TRUE(list.beside().empty());
}

}  // namespace
}  // namespace offing::present

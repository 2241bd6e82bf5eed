// The folders and files that a file dialog lists, and what a typed name means there.
#include "present/files/file_browser.h"

#include <algorithm>
#include <chrono>
#include <ctime>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/scene/schema/parameter_table.h"
#include "present/files/file_actions.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::present {
namespace {

using ::testing::ElementsAre;

class FileBrowserTest : public testing::Test {
 protected:
  void SetUp() override {
    for (const char* name : {"sea.toml", "SHIP.GLB", "coast.tif", "notes.odt", ".hidden.toml", "b.ply"})
      std::ofstream(folder_.path() / name) << "x";
    std::filesystem::create_directory(folder_.path() / "maps ü");
    std::filesystem::create_directory(folder_.path() / ".cache");
    ASSERT_TRUE(browser_.go_to(folder_.path()));
  }
  std::vector<std::string> names(FileFilter filter) {
    browser_.set_filter(filter);
    std::vector<std::string> names;
    for (const FileEntry& entry : browser_.entries()) names.push_back(entry.name);
    return names;
  }

  TemporaryFolder folder_;
  FileBrowser browser_;
};

// Fails if files are in another order than the one that was chosen, or folders are among them.
TEST_F(FileBrowserTest, SortsBySizeAndTime) {
  std::ofstream(folder_.path() / "coast.tif") << std::string(5000, 'x');
  std::ofstream(folder_.path() / "sea.toml") << std::string(70, 'x');
  const auto now = std::filesystem::file_time_type::clock::now();
  for (const auto& [name, hours] :
       {std::pair("sea.toml", 3), {"b.ply", 1}, {"coast.tif", 4}, {"SHIP.GLB", 2}})
    std::filesystem::last_write_time(folder_.path() / name, now - std::chrono::hours(hours));
  browser_.set_order(FileOrder::size);
  EXPECT_THAT(names(FileFilter::known),
              ElementsAre("..", "maps ü", "coast.tif", "sea.toml", "SHIP.GLB", "b.ply"));
  EXPECT_EQ(browser_.entries()[2].bytes, 5000u);
  browser_.set_order(FileOrder::time);
  EXPECT_THAT(names(FileFilter::known),
              ElementsAre("..", "maps ü", "b.ply", "SHIP.GLB", "sea.toml", "coast.tif"));
}

// Fails if a tile store, which is a folder, is shown as a file of 0 B.
TEST_F(FileBrowserTest, TileStoresHaveNoSize) {
  std::filesystem::create_directory(folder_.path() / "alps");
  std::ofstream(folder_.path() / "alps" / "store.toml") << "{}";
  std::ofstream(folder_.path() / "empty.tif");
  browser_.set_filter(FileFilter::height_maps);
  const auto entry = [&](const std::string& name) {
    return *std::ranges::find(browser_.entries(), name, &FileEntry::name);
  };
  ASSERT_THAT(names(FileFilter::height_maps), testing::IsSupersetOf({"alps", "empty.tif"}));
  EXPECT_FALSE(entry("alps").is_folder);
  EXPECT_FALSE(entry("alps").bytes);
  EXPECT_EQ(entry("empty.tif").bytes, 0u);
}

// Fails if a size or a time is shown as another one.
TEST(ShownFileTest, SizesAndTimes) {
  const test::ScopedEnvironment zone("TZ", "UTC");
  tzset();
  EXPECT_EQ(shown_size(0), "0 B");
  EXPECT_EQ(shown_size(999), "999 B");
  EXPECT_EQ(shown_size(1234), "1.2 kB");
  EXPECT_EQ(shown_size(9'990), "10 kB");
  EXPECT_EQ(shown_size(999'700), "1.0 MB");
  EXPECT_EQ(shown_size(12'345'678'901), "12 GB");
  using std::chrono::file_clock;
  const auto time = std::chrono::sys_days(std::chrono::year(2026) / 11 / 28) + std::chrono::seconds(50700);
  EXPECT_EQ(shown_time(file_clock::from_sys(time)), "2026-11-28 14:05");
}

// Fails if a filter hides its own files, shows others or hidden ones, or hides folders.
TEST_F(FileBrowserTest, ListsFoldersThenFilesOfTheKind) {
  EXPECT_THAT(names(FileFilter::scenes), ElementsAre("..", "maps ü", "sea.toml"));
  EXPECT_THAT(names(FileFilter::meshes), ElementsAre("..", "maps ü", "SHIP.GLB", "b.ply"));
  EXPECT_THAT(names(FileFilter::clouds), ElementsAre("..", "maps ü", "b.ply"));
  EXPECT_THAT(names(FileFilter::height_maps), ElementsAre("..", "maps ü", "coast.tif"));
  EXPECT_THAT(names(FileFilter::spectra), ElementsAre("..", "maps ü"));
  EXPECT_THAT(names(FileFilter::known),
              ElementsAre("..", "maps ü", "SHIP.GLB", "b.ply", "coast.tif", "sea.toml"));
  EXPECT_THAT(names(FileFilter::all),
              ElementsAre("..", "maps ü", "SHIP.GLB", "b.ply", "coast.tif", "notes.odt", "sea.toml"));
}

// Fails if the dialog of a value that names a file hides the files that the value takes, or lists all.
TEST(FilterOfRowTest, ListsWhatTheValueTakes) {
  int rows = 0;
  for (const scene::Parameter& row : scene::parameter_table()) {
    if (row.rule != scene::ParameterRule::file_name) continue;
    ++rows;
    const FileFilter filter = filter_of_row(row.key);
    EXPECT_NE(filter, FileFilter::all) << row.key;
    const bool is_folder = row.help.starts_with("folder");
    EXPECT_TRUE(passes(filter, is_folder ? "00.png" : row.example)) << row.key;
  }
  EXPECT_GE(rows, 12);
  EXPECT_TRUE(passes(filter_of_row("body.hydrodynamics"), "barge.1"));
  EXPECT_FALSE(passes(filter_of_row("mesh.file"), "coast.tif"));
}

// Fails if a typed name is looked for in another folder than the one that is shown.
TEST_F(FileBrowserTest, TypedNamesBeginAtTheFolder) {
  const test::ScopedEnvironment home("HOME", "/home/someone");
  EXPECT_EQ(browser_.at("sea.toml"), folder_.path() / "sea.toml");
  EXPECT_EQ(browser_.at("maps ü/../sea.toml"), folder_.path() / "sea.toml");
  EXPECT_EQ(browser_.at("/tmp/sea.toml"), "/tmp/sea.toml");
  EXPECT_EQ(browser_.at("~/sea.toml"), "/home/someone/sea.toml");
  EXPECT_EQ(browser_.at("~other"), folder_.path() / "~other");
}

// Fails if a folder that is not there empties the list, or the way up is lost at the root.
TEST_F(FileBrowserTest, GoesUpAndDown) {
  EXPECT_TRUE(browser_.go_to("maps ü/"));
  EXPECT_EQ(browser_.folder(), folder_.path() / "maps ü");
  EXPECT_TRUE(browser_.go_to(".."));
  EXPECT_EQ(browser_.folder(), folder_.path());
  EXPECT_FALSE(browser_.go_to("gone"));
  EXPECT_EQ(browser_.folder(), folder_.path());
  EXPECT_EQ(browser_.entries().size(), 6u);
  EXPECT_TRUE(browser_.go_to("/"));
  EXPECT_TRUE(browser_.go_to(".."));
  EXPECT_EQ(browser_.folder(), "/");
}

}  // namespace
}  // namespace offing::present

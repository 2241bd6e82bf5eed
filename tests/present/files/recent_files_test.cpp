// Files that were opened or saved of late, and where windows keep their list.
#include "present/files/recent_files.h"

#include <fstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "present/files/state_folder.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/scoped_environment.h"

namespace offing::present {
namespace {

using ::testing::ElementsAre;
using ::testing::IsEmpty;

class RecentFilesTest : public testing::Test {
 protected:
  std::filesystem::path file(const std::string& name) const {
    const std::filesystem::path path = folder_.path() / name;
    std::ofstream(path) << "x";
    return path;
  }

  TemporaryFolder folder_;
};

// Fails if the order is not that of the last use, a file is named twice, or a window finds another list.
TEST_F(RecentFilesTest, AreKeptForTheNextWindow) {
  const std::filesystem::path list = folder_.path() / "state" / "offing" / "recent_files";
  RecentFiles recent(list);
  EXPECT_THAT(recent.all(), IsEmpty());
  const std::filesystem::path a = file("a.toml"), b = file("배 b.toml");
  recent.add(a);
  recent.add(b);
  recent.add(a);
  EXPECT_THAT(recent.all(), ElementsAre(a, b));
  EXPECT_THAT(RecentFiles(list).all(), ElementsAre(a, b));
  std::filesystem::remove(a);
  EXPECT_THAT(recent.all(), ElementsAre(b));
}

// Fails if the list grows for ever, or one that cannot be read or written does any harm.
TEST_F(RecentFilesTest, AreFewAndOnlyAHelp) {
  RecentFiles recent(folder_.path() / "recent_files");
  for (int i = 0; i < 30; ++i) recent.add(file(fmt::format("{}.toml", i)));
  EXPECT_EQ(recent.all().size(), 20u);
  EXPECT_EQ(recent.all().front().filename(), "29.toml");
  RecentFiles nowhere{std::filesystem::path()};
  nowhere.add(file("a.toml"));
  EXPECT_THAT(nowhere.all(), IsEmpty());
  RecentFiles unwritable("/proc/nonexistent/recent_files");
  unwritable.add(file("a.toml"));
  EXPECT_THAT(unwritable.all(), IsEmpty());
}

// Fails if the state is not where the XDG rules have it.
TEST(StateFolderTest, FollowsTheEnvironment) {
  const test::ScopedEnvironment home("HOME", "/home/someone");
  const test::ScopedEnvironment xdg("XDG_STATE_HOME", "/state");
  EXPECT_EQ(state_folder(), "/state/offing");
  setenv("XDG_STATE_HOME", "relative", 1);
  EXPECT_EQ(state_folder(), "/home/someone/.local/state/offing");
  unsetenv("HOME");
  EXPECT_EQ(state_folder(), "");
}

}  // namespace
}  // namespace offing::present

#include "host/io/file_presence.h"

#include <fstream>
#include <string>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

// Fails if what is there is missed, or what is not there is found.
TEST(FilePresence, FindsFilesAndFolders) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / "a.txt") << "a";
  EXPECT_TRUE(is_there(folder.path()));
  EXPECT_TRUE(is_there(folder.path() / "a.txt"));
  EXPECT_FALSE(is_there(folder.path() / "b.txt"));
  EXPECT_FALSE(is_there(folder.path() / "b" / "b.txt"));
}

// Fails if a link that leads nowhere counts as a file to be read, or as a free name.
TEST(FilePresence, KnowsLinksThatLeadNowhere) {
  const TemporaryFolder folder;
  std::filesystem::create_symlink("gone", folder.path() / "link");
  EXPECT_FALSE(is_there(folder.path() / "link"));
  EXPECT_TRUE(is_taken(folder.path() / "link"));
  EXPECT_FALSE(is_taken(folder.path() / "gone"));
}

// Fails if a name that no file can have comes out as another exception than Error, which programs do not
// catch.
TEST(FilePresence, RefusesNamesThatAreTooLong) {
  try {
    is_there(std::string(300, 'x'));
    FAIL() << "not refused";
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::file);
    EXPECT_FALSE(error.hint().empty());
  }
}

}  // namespace
}  // namespace offing

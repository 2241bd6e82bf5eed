#include "host/ocl/disk_cache.h"

#include <fstream>
#include <future>
#include <memory>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "host/ocl/buffer.h"
#include "host/ocl/private_folder.h"
#include "host/ocl/program.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/child_process.h"
#include "tests/ocl/log_capture.h"
#include "tests/ocl/scoped_environment.h"
#include "tests/ocl/test_kernels.h"

namespace offing::ocl {
namespace {

namespace fs = std::filesystem;
using Binary = std::vector<std::uint8_t>;
using std::chrono::milliseconds;
using test::LogCapture;
using ::testing::HasSubstr;
using ::testing::Optional;

std::string content_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void replace(const fs::path& path, const std::string& content) {
  std::ofstream(path, std::ios::binary | std::ios::trunc) << content;
}

class DiskCacheTest : public ::testing::Test {
 protected:
  DiskCacheTest() { cache_.store("identity", binary_); }

  TemporaryFolder folder_;
  DiskCache cache_{folder_.path() / "nested" / "cache"};
  const Binary binary_{1, 2, 3, 0, 255, 7};
  const fs::path entry_ = cache_.entry_path("identity");
  LogCapture log_;
};

TEST_F(DiskCacheTest, ReturnsWhatWasStored) {
  EXPECT_THAT(cache_.load("identity"), Optional(binary_));
  EXPECT_EQ(cache_.load("another identity"), std::nullopt);
  EXPECT_EQ(log_.lines(), 0u) << log_.text();
}

TEST_F(DiskCacheTest, ReplacesAnEntry) {
  cache_.store("identity", {9, 9});
  EXPECT_THAT(cache_.load("identity"), Optional(Binary{9, 9}));
}

// Fails if a temporary file stays behind: the folder would grow with each start.
TEST_F(DiskCacheTest, LeavesNothingButEntries) {
  std::size_t files = 0;
  for (const auto& file : fs::directory_iterator(entry_.parent_path())) files += file.is_regular_file();
  EXPECT_EQ(files, 1u);
}

// Fails if the halves that killed processes leave pile up, or if one that may still be written goes, or a
// stranger's file.
TEST_F(DiskCacheTest, RemovesOldHalves) {
  const auto now = fs::file_time_type::clock::now();
  const auto leave = [&](const fs::path& path, std::chrono::minutes age) {
    replace(path, "half");
    fs::last_write_time(path, now - age);
    return path;
  };
  const std::string entry = cache_.entry_path("killed").string();
  const fs::path old_half = leave(entry + ".12345.0.tmp", std::chrono::minutes(61));
  const fs::path young_half = leave(entry + ".12346.0.tmp", std::chrono::minutes(50));
  const fs::path stranger = leave(entry_.parent_path() / "letter.program.1.0.tmp", std::chrono::minutes(500));
  const fs::path old_entry = leave(entry, std::chrono::minutes(500));
  cache_.store("identity", binary_);
  EXPECT_FALSE(fs::exists(old_half));
  EXPECT_TRUE(fs::exists(young_half));
  EXPECT_TRUE(fs::exists(stranger));
  EXPECT_TRUE(fs::exists(old_entry));
}

// Of a kind with a limit, those entries go that were not used for longest, and no file of another kind. Fails
// if the folder grows beyond the limit, or if the newest entry or one that was just read goes.
TEST_F(DiskCacheTest, KeepsWhatWasUsedLast) {
  const DiskCache maps(entry_.parent_path(), {"sky", "sky map", 2500});
  const Binary thousand(1000, 7);  // with its header 1040 bytes: two fit
  const auto used_before = [&](const char* identity, std::chrono::minutes age) {
    fs::last_write_time(maps.entry_path(identity), fs::file_time_type::clock::now() - age);
  };
  maps.store("a", thousand);
  used_before("a", std::chrono::minutes(30));
  maps.store("b", thousand);
  used_before("b", std::chrono::minutes(20));
  EXPECT_THAT(maps.load("a"), Optional(thousand));
  maps.store("c", thousand);
  EXPECT_THAT(maps.load("a"), Optional(thousand));
  EXPECT_EQ(maps.load("b"), std::nullopt);
  EXPECT_THAT(maps.load("c"), Optional(thousand));
  maps.store("large", Binary(5000, 1));
  EXPECT_THAT(maps.load("large"), Optional(Binary(5000, 1)));
  EXPECT_EQ(maps.load("a"), std::nullopt);
  EXPECT_THAT(cache_.load("identity"), Optional(binary_));
  EXPECT_EQ(cache_.load("a"), std::nullopt);
  EXPECT_EQ(log_.lines(), 0u) << log_.text();
}

TEST_F(DiskCacheTest, DetectsEveryTruncation) {
  const std::string whole = content_of(entry_);
  for (std::size_t bytes = 0; bytes < whole.size(); ++bytes) {
    replace(entry_, whole.substr(0, bytes));
    EXPECT_EQ(cache_.load("identity"), std::nullopt) << bytes;
  }
  EXPECT_EQ(log_.lines(), whole.size());  // one line an entry
  EXPECT_THAT(log_.text(), HasSubstr("is damaged: rebuilding it"));
}

TEST_F(DiskCacheTest, DetectsEveryFlippedBit) {
  const std::string whole = content_of(entry_);
  for (std::size_t bit = 0; bit < 8 * whole.size(); ++bit) {
    std::string damaged = whole;
    damaged[bit / 8] = static_cast<char>(damaged[bit / 8] ^ (1 << bit % 8));
    replace(entry_, damaged);
    EXPECT_EQ(cache_.load("identity"), std::nullopt) << bit;
  }
}

TEST_F(DiskCacheTest, DetectsGarbageAndAppendices) {
  const std::string whole = content_of(entry_);
  for (const std::string& garbage :
       {std::string("text"), std::string(100000, '\xff'), whole + "x", whole + whole}) {
    replace(entry_, garbage);
    EXPECT_EQ(cache_.load("identity"), std::nullopt);
  }
}

// A whole entry under the wrong name, as a careless copy leaves it.
TEST_F(DiskCacheTest, DetectsAForeignEntry) {
  fs::copy_file(entry_, cache_.entry_path("another identity"));
  EXPECT_EQ(cache_.load("another identity"), std::nullopt);
}

TEST_F(DiskCacheTest, SurvivesAFolderInPlaceOfAnEntry) {
  fs::remove(entry_);
  fs::create_directories(entry_ / "x");
  EXPECT_EQ(cache_.load("identity"), std::nullopt);
  EXPECT_NO_THROW(cache_.store("identity", binary_));
}

TEST_F(DiskCacheTest, SurvivesAFolderThatCannotBeMade) {
  const DiskCache unwritable("/dev/null/cache");  // refused to root too
  EXPECT_NO_THROW(unwritable.store("identity", binary_));
  EXPECT_EQ(unwritable.load("identity"), std::nullopt);
}

// Fails if a program that another user can have put there is loaded, or one is left for them to change.
TEST_F(DiskCacheTest, UsesNoFolderOfOtherUsers) {
  const fs::path folder = entry_.parent_path();
  const auto expect_unused = [&](const char* what) {
    EXPECT_EQ(cache_.load("identity"), std::nullopt) << what;
    cache_.store("new", binary_);
    EXPECT_FALSE(fs::exists(cache_.entry_path("new"))) << what;
  };
  for (const fs::perms others : {fs::perms::others_write, fs::perms::group_write}) {
    fs::permissions(folder, others, fs::perm_options::add);
    expect_unused(others == fs::perms::others_write ? "a folder for everybody" : "a folder for a group");
    fs::permissions(folder, others, fs::perm_options::remove);
  }
  EXPECT_THAT(cache_.load("identity"), Optional(binary_));
  if (geteuid() != 0) GTEST_SKIP() << "only root can give a folder away";
  ASSERT_EQ(chown(folder.c_str(), 65534, 65534), 0);
  expect_unused("a folder of another user");
}

// Fails if others may look into a folder that the cache makes, or write in it, whatever the umask.
TEST_F(DiskCacheTest, MakesItsFolderForItsOwnerAlone) {
  const mode_t before = umask(0);
  const fs::path folder = entry_.parent_path() / "deeper" / "cache";
  DiskCache(folder).store("identity", binary_);
  umask(before);
  EXPECT_EQ(fs::status(folder).permissions(), fs::perms::owner_all);
  EXPECT_THAT(DiskCache(folder).load("identity"), Optional(binary_));
}

// Fails if a temporary name that somebody has prepared as a link leads the write to another file.
TEST_F(DiskCacheTest, WritesThroughNoLink) {
  const fs::path victim = folder_.path() / "victim";
  replace(victim, "mine");
  for (int count = 0; count < 1000; ++count) {
    fs::create_symlink(victim,
                       cache_.entry_path("new").string() + fmt::format(".{}.{}.tmp", getpid(), count));
  }
  cache_.store("new", binary_);
  EXPECT_EQ(content_of(victim), "mine");
  EXPECT_THAT(cache_.load("new"), Optional(binary_));
  EXPECT_FALSE(fs::is_symlink(cache_.entry_path("new")));
}

TEST_F(DiskCacheTest, CanBeOff) {
  const DiskCache off((fs::path()));
  off.store("identity", binary_);
  EXPECT_EQ(off.load("identity"), std::nullopt);
}

TEST_F(DiskCacheTest, FindsItsFolder) {
  const test::ScopedEnvironment home("HOME", "/home/sailor");
  const test::ScopedEnvironment xdg("XDG_CACHE_HOME", "");
  const test::ScopedEnvironment own("OFFING_CACHE_DIR", "/own");
  EXPECT_EQ(DiskCache::default_folder(), "/own");
  setenv("OFFING_CACHE_DIR", "", 1);
  EXPECT_TRUE(DiskCache::default_folder().empty());
  unsetenv("OFFING_CACHE_DIR");
  EXPECT_EQ(DiskCache::default_folder(), "/home/sailor/.cache/offing");
  setenv("XDG_CACHE_HOME", "/xdg", 1);
  EXPECT_EQ(DiskCache::default_folder(), "/xdg/offing");
  setenv("XDG_CACHE_HOME", "relative", 1);
  EXPECT_EQ(DiskCache::default_folder(), "/home/sailor/.cache/offing");
}

// The same through Program::build, where the driver compiles again.
class CachedProgramTest : public ::testing::Test {
 protected:
  CachedProgramTest() { kernels_.write("answer.cl", "kernel void answer(global int* v) { v[0] = 42; }"); }

  int answer(const Device& device) const {
    const Buffer<int> values(device, 1, "values");
    Program::build(device, "answer.cl").kernel("answer").launch({{1}}, values);
    return values.read()[0];
  }
  /// By a device that has built nothing yet.
  int answer() const { return answer(Device::open()); }
  std::vector<fs::path> entries() const {
    std::vector<fs::path> paths;
    for (const auto& file : fs::directory_iterator(kernels_.cache().path())) {
      if (file.is_regular_file()) paths.push_back(file.path());
    }
    return paths;
  }

  test::TestKernels kernels_;
  LogCapture log_;
};

TEST_F(CachedProgramTest, KeepsOneEntryAProgram) {
  EXPECT_EQ(answer(), 42);
  EXPECT_EQ(answer(), 42);
  EXPECT_EQ(entries().size(), 1u);
  EXPECT_EQ(log_.lines(), 0u) << log_.text();
}

// Fails if a device asks the driver twice for one program, or takes the old one for a source that was edited.
TEST_F(CachedProgramTest, BuildsOnceADevice) {
  const Device device = Device::open();
  EXPECT_EQ(answer(device), 42);
  replace(entries().front(), "garbage");
  EXPECT_EQ(answer(device), 42);
  EXPECT_EQ(log_.lines(), 0u) << log_.text();
  kernels_.write("answer.cl", "kernel void answer(global int* v) { v[0] = 43; }");
  EXPECT_EQ(answer(device), 43);
}

TEST_F(CachedProgramTest, RebuildsADamagedEntry) {
  EXPECT_EQ(answer(), 42);
  ASSERT_EQ(entries().size(), 1u);
  const fs::path entry = entries().front();
  replace(entry, "garbage");
  EXPECT_EQ(answer(), 42);
  EXPECT_EQ(log_.lines(), 1u) << log_.text();
  EXPECT_EQ(answer(), 42);  // from the entry that replaced the damaged one
  EXPECT_EQ(log_.lines(), 1u) << log_.text();
}

TEST_F(CachedProgramTest, BuildsWithoutAFolder) {
  const test::ScopedEnvironment nowhere("OFFING_CACHE_DIR", "/dev/null/cache");
  EXPECT_EQ(answer(), 42);
  const test::ScopedEnvironment off("OFFING_CACHE_DIR", "");
  EXPECT_EQ(answer(), 42);
}

// Processes that start at once on an empty cache, then on a full one, then on one whose entry is garbage:
// fails if any of them reads a half-written entry or stops.
TEST_F(CachedProgramTest, ServesProcessesThatStartAtOnce) {
  const TemporaryFolder pocl_cache;
  const test::ScopedEnvironment pocl("POCL_CACHE_DIR", pocl_cache.path().string());
  for (int round = 0; round < 3; ++round) {
    std::vector<std::unique_ptr<test::ChildProcess>> children;
    for (int i = 0; i < 3; ++i) {
      children.push_back(
          std::make_unique<test::ChildProcess>(std::vector<std::string>{"build", "answer.cl", "answer"}));
    }
    for (const auto& child : children) {
      EXPECT_EQ(child->exit_status(), 0) << child->output();
      EXPECT_THAT(child->output(), HasSubstr("42\n"));
    }
    EXPECT_EQ(entries().size(), 1u);
    if (round == 1) replace(entries().front(), "garbage");
  }
}

// Fails if two have it at a time, or who waits does so for ever: a test that was stopped while it had PoCL's
// cache let every other program wait until it was killed.
TEST(FolderLockTest, WaitsNoLongerThanAsked) {
  const TemporaryFolder folder;
  const FolderLock first(folder.path().string(), milliseconds(0));
  EXPECT_TRUE(first.is_held());
  const auto begin = std::chrono::steady_clock::now();
  EXPECT_FALSE(FolderLock(folder.path().string(), milliseconds(100)).is_held());
  EXPECT_GE(std::chrono::steady_clock::now() - begin, milliseconds(100));
}

// Fails if a turn never comes.
TEST(FolderLockTest, ComesToItsTurn) {
  const TemporaryFolder folder;
  auto first = std::make_unique<FolderLock>(folder.path().string(), milliseconds(0));
  auto second = std::async(std::launch::async,
                           [&] { return FolderLock(folder.path().string(), milliseconds(60000)).is_held(); });
  first.reset();
  EXPECT_TRUE(second.get());
}

// Fails if a folder that is not there is waited for.
TEST(FolderLockTest, NeedsAFolder) {
  EXPECT_FALSE(FolderLock("/nowhere/at all", milliseconds(60000)).is_held());
}

}  // namespace
}  // namespace offing::ocl

// One process at a time has a folder, and none for ever.
#include "host/ocl/program_cache.h"

#include <future>
#include <memory>

#include <gtest/gtest.h>

#include "tests/io/temporary_folder.h"

namespace offing::ocl {
namespace {

using std::chrono::milliseconds;

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

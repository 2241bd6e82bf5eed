#include "host/io/atomic_file.h"

#include <cerrno>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>
#include <vector>

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <signal.h>
#include <stdio.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

namespace {

/// Whether file systems of this test are as network file systems are: without a rename that replaces nothing.
bool has_plain_rename_alone = false;

}  // namespace

/// Takes the place of the C library's in this program.
extern "C" int renameat2(int from_folder, const char* from, int to_folder, const char* to,
                         unsigned int flags) noexcept {
  if (!has_plain_rename_alone || flags == 0) {
    return static_cast<int>(syscall(SYS_renameat2, from_folder, from, to_folder, to, flags));
  }
  errno = EINVAL;
  return -1;
}

namespace offing {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

std::string content(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::vector<std::string> names_in(const fs::path& folder) {
  std::vector<std::string> names;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    names.push_back(entry.path().filename().string());
  }
  return names;
}

/// The error that `action` throws; fails the test when it throws none.
template <typename Action>
Error error_of(Action action) {
  try {
    action();
  } catch (const Error& error) {
    return error;
  }
  ADD_FAILURE() << "expected an Error";
  return {ErrorKind::device, "none"};
}

/// A child process that holds a half-written `target` until it is killed.
class HalfWriter {
 public:
  explicit HalfWriter(const fs::path& target) {
    int ready[2];
    if (pipe(ready) != 0) throw std::runtime_error("pipe");
    pid_ = fork();
    if (pid_ == 0) {
      AtomicFile file(target);
      file.write("half");
      if (write(ready[1], "x", 1) != 1) _exit(1);
      for (;;) pause();
    }
    char byte;
    if (read(ready[0], &byte, 1) != 1) throw std::runtime_error("the child did not start");
    close(ready[0]);
    close(ready[1]);
  }
  ~HalfWriter() { kill_now(); }
  void kill_now() {
    if (pid_ <= 0) return;
    kill(pid_, SIGKILL);
    waitpid(pid_, nullptr, 0);
    pid_ = -1;
  }

 private:
  pid_t pid_ = -1;
};

// Fails if bytes reach the final name before commit, or a temporary outlives it.
TEST(AtomicFile, PublishesOnlyOnCommit) {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "a.txt";
  write_file_atomically(target, "old");
  AtomicFile file(target);
  file.write("new bytes");
  EXPECT_EQ(content(target), "old");
  EXPECT_EQ(file.temporary().parent_path(), folder.path());
  file.commit();
  EXPECT_EQ(content(target), "new bytes");
  EXPECT_EQ(names_in(folder.path()).size(), 1u);
}

/// That what appears while a file is written stays, and that nothing else keeps the file from its name.
void expect_kept() {
  const TemporaryFolder folder;
  const fs::path target = folder.path() / "a.txt";
  for (const bool is_link : {false, true}) {
    AtomicFile file(target, Existing::keep);
    file.write("new bytes");
    if (is_link) {
      fs::create_symlink("gone", target);
    } else {
      std::ofstream(target) << "theirs";
    }
    const Error error = error_of([&] { file.commit(); });
    EXPECT_EQ(error.kind(), ErrorKind::bad_usage);
    EXPECT_THAT(error.what(), HasSubstr("a.txt: expected a new file, found an existing one"));
    EXPECT_EQ(fs::is_symlink(target), is_link);
    EXPECT_TRUE(is_link || content(target) == "theirs");
    fs::remove(target);
  }
  EXPECT_TRUE(names_in(folder.path()).empty());
  write_file_atomically(target, "new bytes", Existing::keep);
  EXPECT_EQ(content(target), "new bytes");
  EXPECT_EQ(names_in(folder.path()).size(), 1u);
}

// Fails if a file that another program makes meanwhile is replaced, or a link that leads nowhere.
TEST(AtomicFile, KeepsWhatAppearsMeanwhile) {
  expect_kept();
}

// Fails if it is so only where the file system has a rename that replaces nothing.
TEST(AtomicFile, KeepsWhatAppearsMeanwhileOnNetworkFileSystems) {
  has_plain_rename_alone = true;
  expect_kept();
  has_plain_rename_alone = false;
}

// Fails if an exception on the way leaves a temporary or touches the target.
TEST(AtomicFile, VanishesWithoutCommit) {
  const TemporaryFolder folder;
  { AtomicFile(folder.path() / "a.txt").write("lost"); }
  EXPECT_TRUE(names_in(folder.path()).empty());
}

// Fails if seeking back appends or truncates: EXR fills in its offset table last.
TEST(AtomicFile, SeeksBackToFillATable) {
  const TemporaryFolder folder;
  AtomicFile file(folder.path() / "a.bin");
  file.write("____payload");
  EXPECT_EQ(file.position(), 11u);
  file.seek(0);
  file.write("HEAD");
  file.commit();
  EXPECT_EQ(content(file.target()), "HEADpayload");
}

// Fails if the cleaner takes a living writer's file, misses a dead one's, or takes files that merely look
// similar.
TEST(AtomicFile, CleanerTakesOnlyWhatDeadWritersLeft) {
  const TemporaryFolder folder;
  HalfWriter killed(folder.path() / "ocean.0003.exr");
  HalfWriter alive(folder.path() / "ocean.0004.exr");
  killed.kill_now();
  for (const char* name :
       {"ocean.0001.exr", ".ocean.0003.exr.partial", ".ocean.0003.exr.0123456789abcdeX.partial"}) {
    std::ofstream(folder.path() / name) << "kept";
  }
  EXPECT_EQ(remove_stale_partials(folder.path(), "other"), 0u);
  EXPECT_EQ(remove_stale_partials(folder.path(), "ocean."), 1u);
  EXPECT_EQ(names_in(folder.path()).size(), 4u);
  EXPECT_EQ(remove_stale_partials(folder.path()), 0u);
  EXPECT_EQ(remove_stale_partials(folder.path() / "missing"), 0u);
}

// Fails if writers and cleaners at once lose a file or let an error out: 2 writers, 1 cleaner, 300 files
// each.
TEST(AtomicFile, SurvivesACleanerAtWork) {
  const TemporaryFolder folder;
  std::vector<pid_t> children;
  for (int process = 0; process < 3; ++process) {
    children.push_back(fork());
    if (children.back() != 0) continue;
    try {
      for (int i = 0; i < 300; ++i) {
        if (process == 2) {
          remove_stale_partials(folder.path());
        } else {
          write_file_atomically(folder.path() / (std::to_string(process) + "." + std::to_string(i)), "whole");
        }
      }
      _exit(0);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      _exit(1);
    }
  }
  for (const pid_t child : children) {
    int status = 1;
    waitpid(child, &status, 0);
    EXPECT_EQ(status, 0);
  }
  EXPECT_EQ(names_in(folder.path()).size(), 600u);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.path())) {
    EXPECT_EQ(content(entry.path()), "whole") << entry.path();
  }
}

// Fails if a bad place is not named, or the hint does not say what to do.
TEST(AtomicFile, NamesBadPlaces) {
  const TemporaryFolder folder;
  const Error missing = error_of([&] { AtomicFile file(folder.path() / "no" / "a.exr"); });
  EXPECT_EQ(missing.kind(), ErrorKind::file);
  EXPECT_THAT(missing.what(),
              HasSubstr((folder.path() / "no" / "a.exr").string() + ": cannot create: No such file"));
  EXPECT_THAT(missing.hint(), HasSubstr("create the folder"));

  const Error is_folder = error_of([&] { AtomicFile file(folder.path()); });
  EXPECT_EQ(is_folder.kind(), ErrorKind::file);
  EXPECT_THAT(is_folder.what(), HasSubstr("found a folder"));
  EXPECT_EQ(error_of([] { AtomicFile file("/dev/null"); }).kind(), ErrorKind::file);
  EXPECT_EQ(error_of([] { AtomicFile file(""); }).kind(), ErrorKind::file);

  std::ofstream(folder.path() / "file") << "x";
  const Error below_file = error_of([&] { AtomicFile file(folder.path() / "file" / "a.exr"); });
  EXPECT_THAT(below_file.hint(), HasSubstr("file is no folder: write to another folder"));
  EXPECT_THAT(error_of([] { AtomicFile file("/proc/a.exr"); }).hint(), HasSubstr("/proc takes no new files"));
}

// Fails if a place is found out to be bad only after the work, or looking at a good one leaves something.
TEST(AtomicFile, PlacesAreTriedBeforehand) {
  const TemporaryFolder folder;
  EXPECT_THAT(error_of([&] { require_writable(folder.path() / "no" / "a.exr"); }).what(),
              HasSubstr("cannot create: No such file"));
  EXPECT_THAT(error_of([&] { require_writable(folder.path()); }).what(), HasSubstr("found a folder"));
  require_writable(folder.path() / "a.exr");
  EXPECT_TRUE(fs::is_empty(folder.path()));
}

// Fails if running out of room is silent, leaves a partial or hurts finished files. A file size limit stands
// in for a full disk: both make write() come up short, and no right to mount a small file system is needed.
TEST(AtomicFile, ReportsARefusedWriteAndLeavesNothing) {
  const TemporaryFolder folder;
  write_file_atomically(folder.path() / "done", "finished");
  const pid_t child = fork();
  if (child == 0) {
    signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{1 << 16, 1 << 16};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      AtomicFile file(folder.path() / "big");
      try {
        file.write(std::string(1 << 20, 'x'));
      } catch (const Error&) {
        file.commit();  // must not publish what is torn
      }
    } catch (const Error& error) {
      const bool clear = error.kind() == ErrorKind::file &&
                         std::string(error.what()).find("big: cannot write: ") != std::string::npos &&
                         !error.hint().empty();
      _exit(clear ? 0 : 2);
    }
    _exit(1);
  }
  int status = 1;
  waitpid(child, &status, 0);
  EXPECT_EQ(WEXITSTATUS(status), 0);
  EXPECT_THAT(names_in(folder.path()), ::testing::ElementsAre("done"));
}

}  // namespace
}  // namespace offing

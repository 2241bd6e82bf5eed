#include <cstdlib>
#include <fstream>
#include <string>

#include <gtest/gtest.h>
#include <pthread.h>
#include <sys/resource.h>
#include <unistd.h>

#include "host/base/error.h"
#include "host/cli/ocean/bake.h"
#include "tests/io/temporary_folder.h"

namespace offing::cli {
namespace {

// Large stacks in little address space: the seventh or eighth thread cannot be had, whoever runs this.
constexpr std::size_t stack_bytes = std::size_t{256} << 20;
constexpr std::size_t stacks = 8;

std::size_t address_space_bytes() {
  std::size_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE));
}

void make_threads_scarce() {
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  pthread_attr_setstacksize(&attributes, stack_bytes);
  pthread_setattr_default_np(&attributes);
  const rlim_t most = address_space_bytes() + stacks * stack_bytes;
  const rlimit limit{most, most};
  setrlimit(RLIMIT_AS, &limit);
}

/// A bake without frames on more devices than there can be threads; ends the process with 0 if it says so.
[[noreturn]] void bake_on_too_many_devices(const std::filesystem::path& folder) {
  const scene::Sea sea = scene::prepare_sea({});
  BakeSettings settings;
  settings.folder = folder;
  settings.frames = {0, -1};
  const FrameFiles files(settings, static_cast<int>(sea.parameters.cascades.size()), "hash");
  FrameWriter writer(sea, settings, files, "hash", "a sea");
  const std::vector<ocl::DeviceInfo> devices(4 * stacks);
  Progress progress(0, "frames", Verbosity::quiet);
  alarm(60);
  make_threads_scarce();
  try {
    bake(devices, sea, settings, files, writer, progress, {});
  } catch (const Error& error) {
    const bool is_told = std::string(error.what()).find("cannot start a thread") != std::string::npos;
    std::_Exit(is_told && error.kind() == ErrorKind::out_of_memory ? 0 : 2);
  }
  std::_Exit(3);
}

// Fails (by the alarm) if the writer waits for frames for ever when a device's thread cannot be started, or
// if that ends in anything but an Error.
TEST(BakeThreads, ThatCannotStartEndTheBake) {
  GTEST_FLAG_SET(death_test_style, "threadsafe");
  const TemporaryFolder folder;
  EXPECT_EXIT(bake_on_too_many_devices(folder.path()), testing::ExitedWithCode(0), "");
}

}  // namespace
}  // namespace offing::cli

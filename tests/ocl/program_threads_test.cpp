#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/ocl/buffer.h"
#include "host/ocl/disk_cache.h"
#include "host/ocl/program.h"
#include "host/ocl/quirks.h"
#include "tests/ocl/scoped_environment.h"
#include "tests/ocl/test_kernels.h"

// What a bake on several devices does: a thread each, with one cache between them.

namespace offing::ocl {
namespace {

constexpr int thread_count = 4;

// Starts `work` on several threads at once and waits for all. What one throws fails the test with its words.
template <class Work>
void on_threads(Work work) {
  std::atomic<int> ready{0};
  std::vector<std::jthread> threads;
  for (int i = 0; i < thread_count; ++i) {
    threads.emplace_back([&ready, &work, i] {
      ++ready;
      while (ready < thread_count) std::this_thread::yield();
      try {
        work(i);
      } catch (const Error& error) {
        ADD_FAILURE() << "thread " << i << ": " << error.what() << "\n" << error.hint();
      }
    });
  }
}

// Fails if a thread reads an entry that another one is writing, or gets a mixture of two: all of an entry's
// bytes are the number of the thread that stored it.
TEST(ProgramThreads, ReplaceOneCacheEntry) {
  const TemporaryFolder folder;
  const DiskCache cache(folder.path() / "cache");
  std::atomic<int> broken{0};
  on_threads([&](int thread) {
    for (int round = 0; round < 50; ++round) {
      cache.store("identity", std::vector<std::uint8_t>(10000, static_cast<std::uint8_t>(thread)));
      const std::optional<std::vector<std::uint8_t>> read = cache.load("identity");
      if (!read || *read != std::vector<std::uint8_t>(10000, read->front())) ++broken;
    }
  });
  EXPECT_EQ(broken, 0);
}

// Fails if the warning that the cache cannot be written stops a thread, or comes once a thread: they race for
// it. Only one may win, here or in an earlier test of this process.
TEST(ProgramThreads, SurviveAFolderThatCannotBeMade) {
  const DiskCache cache("/dev/null/cache");
  testing::internal::CaptureStdout();
  on_threads([&](int) { cache.store("identity", {1}); });
  const std::string log = testing::internal::GetCapturedStdout();
  EXPECT_LE(std::count(log.begin(), log.end(), '\n'), 1) << log;
}

// Fails if two threads build for PoCL at the same time, as processes must not (the lock cannot tell them
// apart): the second must not get its turn while the first has it.
TEST(ProgramThreads, TakeTurnsOnPocl) {
  const TemporaryFolder folder;
  const test::ScopedEnvironment cache("POCL_CACHE_DIR", folder.path().string());
  DeviceInfo pocl;
  pocl.platform = "Portable Computing Language";
  std::atomic<int> building{0}, overlaps{0};
  on_threads([&](int) {
    for (int round = 0; round < 20; ++round) {
      const quirks::BuildTurn turn(pocl);
      if (++building > 1) ++overlaps;
      std::this_thread::sleep_for(std::chrono::microseconds(100));
      --building;
    }
  });
  EXPECT_EQ(overlaps, 0);
}

// Fails if devices opened at once, each by its own thread, are not there for the other threads, hinder each
// other's first build, or give a thread the results of another. It must be the process' first call of OpenCL.
TEST(ProgramThreads, BuildAndLaunchAtOnce) {
  const test::TestKernels kernels;
  kernels.write("offset.cl", "kernel void offset(global int* v, int by) { v[get_global_id(0)] += by; }");
  std::vector<int> results(thread_count);
  on_threads([&](int thread) {
    const Device device = Device::open();
    Buffer<int> values(device, 64, "values");
    values.fill(100);
    const Program program = Program::build(device, "offset.cl");
    for (int repeat = 0; repeat < 10; ++repeat) program.kernel("offset").launch({{64}}, values, thread);
    results[thread] = values.read()[63];
  });
  for (int thread = 0; thread < thread_count; ++thread) EXPECT_EQ(results[thread], 100 + 10 * thread);
}

}  // namespace
}  // namespace offing::ocl

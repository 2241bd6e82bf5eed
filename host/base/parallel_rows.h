#pragma once

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

namespace offing {

/// Calls work(row) for every row in [0, rows) on `threads` threads, this one among them, 0 for as many as
/// there are processors; rows must not write what others touch. The first exception, if any, is thrown here
/// once all threads have ended.
template <typename Work>
void parallel_rows(int rows, Work work, int threads = 0) {
  std::atomic<int> next{0};
  std::exception_ptr failure;
  std::mutex failure_mutex;
  const auto run = [&] {
    try {
      for (int row = next++; row < rows; row = next++) work(row);
    } catch (...) {
      const std::lock_guard lock(failure_mutex);
      if (!failure) failure = std::current_exception();
      next = rows;
    }
  };
  if (threads == 0) threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  threads = std::min(rows, threads);
  {
    std::vector<std::jthread> others;
    try {
      for (int i = 1; i < threads; ++i) others.emplace_back(run);
    } catch (const std::system_error&) {
      // The system gives no more threads: those that run, and this one, do all rows.
    }
    run();
  }
  if (failure) std::rethrow_exception(failure);
}

}  // namespace offing

#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <exception>
#include <mutex>
#include <system_error>
#include <thread>
#include <vector>

/// Loops on several threads.
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

/// Hands out indices, some at a time, to whoever asks.
class ChunkQueue {
 public:
  ChunkQueue(std::size_t count, std::size_t chunk_size) : count_(count), chunk_size_(chunk_size) {}

  /// Calls work(index) for indices that nobody else gets, until none are left.
  template <typename Work>
  void drain(const Work& work) {
    for (std::size_t begin = next_.fetch_add(chunk_size_); begin < count_;
         begin = next_.fetch_add(chunk_size_)) {
      const std::size_t end = std::min(begin + chunk_size_, count_);
      for (std::size_t i = begin; i < end; ++i) work(i);
    }
  }

 private:
  const std::size_t count_, chunk_size_;
  std::atomic<std::size_t> next_{0};
};

/// Calls work(queue) once on each of `threads` threads (0: as many as there are processors), which takes
/// indices in [0, count) from the queue: what a thread needs for itself is made before it drains the queue.
template <typename Work>
void parallel_chunks(std::size_t count, int threads, const Work& work) {
  // Enough that taking the next costs nothing, few enough that all threads end together.
  constexpr std::size_t chunk_size = 1024;
  ChunkQueue queue(count, chunk_size);
  if (threads == 0) threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  const std::size_t chunks = (count + chunk_size - 1) / chunk_size;
  threads = static_cast<int>(std::min(static_cast<std::size_t>(threads), chunks));
  parallel_rows(
      threads, [&](int) { work(queue); }, threads);
}

/// Calls work(index) for every index in [0, count); which thread does, and when, is left open.
template <typename Work>
void parallel_for(std::size_t count, int threads, const Work& work) {
  parallel_chunks(count, threads, [&](ChunkQueue& queue) { queue.drain(work); });
}

}  // namespace offing

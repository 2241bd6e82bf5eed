#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>

#include "host/base/parallel_rows.h"

namespace offing {

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

#pragma once

#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "host/base/progress.h"
#include "host/cli/ocean/bounded_queue.h"
#include "host/io/tile_store/tile_store.h"

namespace offing::cli {

/// Threads that write tiles, most of whose time is waiting for the disk.
class TileWriters {
 public:
  /// Both must outlive the writers.
  TileWriters(const TileStoreWriter& store, Progress& progress);
  TileWriters(const TileWriters&) = delete;
  TileWriters& operator=(const TileWriters&) = delete;
  ~TileWriters();

  /// Waits for room. Throws what writing threw.
  void add(HeightTile tile);
  /// Waits until all is written. Throws what writing threw.
  void finish();

  long long written() const { return written_; }
  long long kept() const { return kept_; }

 private:
  void work();
  void join();
  void throw_if_failed();

  const TileStoreWriter& store_;
  Progress& progress_;
  BoundedQueue<HeightTile> tiles_;
  std::atomic<long long> written_{0}, kept_{0};
  std::mutex mutex_;
  std::exception_ptr failure_;
  std::vector<std::thread> threads_;
};

}  // namespace offing::cli

#include "host/cli/terrain/tile_writers.h"

#include <utility>

namespace offing::cli {
namespace {

constexpr std::size_t writers = 4;
constexpr std::size_t most_waiting = 64;  // 34 MB

}  // namespace

TileWriters::TileWriters(const TileStoreWriter& store, Progress& progress)
    : store_(store), progress_(progress), tiles_(most_waiting) {
  for (std::size_t i = 0; i < writers; ++i) threads_.emplace_back([this] { work(); });
}

TileWriters::~TileWriters() {
  join();
}

void TileWriters::work() {
  while (auto tile = tiles_.pop()) {
    try {
      if (store_.write(*tile)) {
        ++written_;
        progress_.advance();
      } else {
        ++kept_;
        progress_.skip();
      }
    } catch (...) {
      const std::lock_guard lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
      tiles_.close();
    }
  }
}

void TileWriters::join() {
  tiles_.close();
  for (std::thread& thread : threads_) thread.join();
  threads_.clear();
}

void TileWriters::throw_if_failed() {
  const std::lock_guard lock(mutex_);
  if (failure_) std::rethrow_exception(failure_);
}

void TileWriters::add(HeightTile tile) {
  if (!tiles_.push(std::move(tile))) throw_if_failed();
}

void TileWriters::finish() {
  join();
  throw_if_failed();
}

}  // namespace offing::cli

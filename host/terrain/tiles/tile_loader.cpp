#include "host/terrain/tiles/tile_loader.h"

#include <algorithm>
#include <exception>
#include <utility>

#include "host/base/error.h"

namespace offing::terrain {

TileLoader::TileLoader(std::function<TileImage(const TileKey&)> load)
    : load_(std::move(load)), thread_([this] { work(); }) {}

TileLoader::~TileLoader() {
  {
    const std::lock_guard lock(mutex_);
    is_over_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

bool TileLoader::is_loaded(const TileKey& key) const {
  return at_hand_ == key ||
         std::any_of(loaded_.begin(), loaded_.end(), [&](const Loaded& loaded) { return loaded.key == key; });
}

void TileLoader::want(const std::vector<TileKey>& keys) {
  {
    const std::lock_guard lock(mutex_);
    wanted_.clear();
    for (const TileKey& key : keys) {
      if (!is_loaded(key)) wanted_.push_back(key);
    }
  }
  changed_.notify_all();
}

std::optional<TileLoader::Loaded> TileLoader::take() {
  std::optional<Loaded> next;
  {
    const std::lock_guard lock(mutex_);
    if (loaded_.empty()) return next;
    next = std::move(loaded_.front());
    loaded_.pop_front();
  }
  changed_.notify_all();
  return next;
}

bool TileLoader::wait() {
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return !loaded_.empty() || (wanted_.empty() && !at_hand_); });
  return !loaded_.empty();
}

void TileLoader::work() {
  std::unique_lock lock(mutex_);
  while (true) {
    changed_.wait(lock, [this] { return is_over_ || (!wanted_.empty() && loaded_.size() < most_images); });
    if (is_over_) return;
    at_hand_ = wanted_.front();
    wanted_.pop_front();
    Loaded loaded{*at_hand_, {}, {}, {}};
    lock.unlock();
    try {
      loaded.image = load_(loaded.key);
    } catch (const Error& error) {
      loaded.failure = error.what();
      loaded.hint = error.hint();
    } catch (const std::exception& error) {
      loaded.failure = error.what();
    }
    lock.lock();
    loaded_.push_back(std::move(loaded));
    at_hand_.reset();
    changed_.notify_all();
  }
}

}  // namespace offing::terrain

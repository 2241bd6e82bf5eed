#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "host/terrain/tiles/tile_image.h"

namespace offing::terrain {

/// Gives a tile, or throws; called from a thread of its own.
using TileReader = std::function<HeightTile(const TileKey&)>;

/// What becomes of a tile that cannot be read.
enum class Unreadable {
  refused,      ///< what is asked is not answered: an error names the tile
  stood_in_for  ///< by a coarser one
};

/// A thread that reads tiles and makes images of them, most wanted first.
class TileLoader {
 public:
  /// What became of a tile that was wanted.
  struct Loaded {
    TileKey key;
    std::optional<TileImage> image;  ///< none if it could not be read
    std::string failure, hint;
  };
  /// That wait to be taken, and one more that is being made.
  static constexpr std::size_t most_images = 16;

  explicit TileLoader(std::function<TileImage(const TileKey&)> load);
  TileLoader(const TileLoader&) = delete;
  TileLoader& operator=(const TileLoader&) = delete;
  /// Ends after the tile at hand.
  ~TileLoader();

  /// What to load from now on, in this order, instead of what was wanted before. What has been loaded and not
  /// taken is not loaded again.
  void want(const std::vector<TileKey>& keys);
  /// The next of what has been loaded; nothing if that is all so far.
  std::optional<Loaded> take();
  /// Waits until something can be taken; false if nothing is wanted any more.
  bool wait();

 private:
  void work();
  bool is_loaded(const TileKey& key) const;

  std::function<TileImage(const TileKey&)> load_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<TileKey> wanted_;
  std::deque<Loaded> loaded_;
  std::optional<TileKey> at_hand_;
  bool is_over_ = false;
  std::thread thread_;  ///< last: it uses all others
};

}  // namespace offing::terrain

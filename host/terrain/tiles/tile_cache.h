#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <set>
#include <vector>

#include "host/ocl/buffer.h"
#include "host/terrain/tiles/tile_cut.h"
#include "host/terrain/tiles/tile_loader.h"

namespace offing::terrain {

/// Tiles on a device, in slots of one pool whose number is fixed by a budget; the least recently used make
/// room. The coarsest level is always there.
class TileCache {
 public:
  /// Reads the coarsest level. budget_bytes holds the pool and what the loader keeps in host memory; the pool
  /// is no larger than the device allows. Throws Error(bad_input) if that leaves fewer than 32 slots beside
  /// the coarsest level, and what reading throws.
  TileCache(const ocl::Device& device, const TiledMap& map, const TileReader& read, std::size_t budget_bytes);

  /// Begins a frame: tiles that are used from now on stay until the next.
  void begin_frame() { ++frame_; }
  /// Slot of a tile that is there, which is thereby used.
  std::optional<int> use(const TileKey& key);
  /// What to load, most wanted first; tiles that are there, or cannot be read, are left out. Returns how many
  /// are on the list.
  std::size_t want(const std::vector<TileKey>& keys);
  /// Takes tiles that have been loaded into slots that this frame does not use. Of those that cannot be read
  /// a warning names each; or Error(bad_input), if they are refused.
  void take_in(Unreadable unreadable = Unreadable::stood_in_for);
  /// The same once something has been loaded; false if nothing is wanted any more.
  bool wait_and_take_in(Unreadable unreadable = Unreadable::stood_in_for);

  const ocl::Buffer<float>& pool() const { return pool_; }
  /// Maxima of nodes of whole squares, at the pool's beginning.
  void write_head(std::span<const float> maxima_m) { pool_.write(maxima_m); }
  const std::vector<float>& square_maxima_m(int slot) const {
    return slots_[static_cast<std::size_t>(slot)].square_maxima_m;
  }
  std::size_t slot_count() const { return slots_.size(); }
  /// Of the slots, those that the coarsest level has for ever.
  std::size_t coarsest_count() const { return coarsest_m_.size(); }
  std::size_t bytes() const;
  std::uint64_t loaded() const { return loaded_; }
  std::uint64_t failed() const { return failed_.size(); }
  /// The highest posts of a coarsest tile.
  const std::vector<float>& coarsest_m(int column, int row) const { return coarsest_m_.at({column, row}); }

 private:
  struct Slot {
    std::optional<TileKey> key;
    std::uint64_t last_frame = 0;  ///< that used it
    std::vector<float> square_maxima_m;
  };

  std::size_t head_floats() const;
  std::optional<int> free_slot() const;
  void put(int slot, TileImage image);
  void take(TileLoader::Loaded loaded, Unreadable unreadable);

  TiledMap map_;
  std::vector<Slot> slots_;
  ocl::Buffer<float> pool_;
  std::map<TileKey, int> places_;
  std::map<std::pair<int, int>, std::vector<float>> coarsest_m_;
  std::set<TileKey> failed_;
  std::uint64_t frame_ = 1, loaded_ = 0;
  TileLoader loader_;
};

}  // namespace offing::terrain

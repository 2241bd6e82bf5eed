#include "host/terrain/tiles/tile_cache.h"

#include <algorithm>
#include <limits>
#include <utility>

#include <fmt/format.h>
#include <spdlog/spdlog.h>

#include "host/base/error.h"
#include "host/terrain/tiles/page_table.h"
#include "kernels/shared/terrain_tiles.h"

namespace offing::terrain {
namespace {

constexpr std::size_t slot_bytes = TERRAIN_SLOT_FLOATS * sizeof(float);
constexpr std::size_t least_slots = 32;
// Places in the pool are ints.
constexpr std::size_t most_pool_bytes = (std::size_t{1} << 31) * sizeof(float) - slot_bytes;
constexpr std::uint64_t always = std::numeric_limits<std::uint64_t>::max();

std::size_t head_floats_of(const TileSetShape& shape) {
  const PagesShape pages = PagesShape::of(shape);
  return 2 * static_cast<std::size_t>(pages.columns) * static_cast<std::size_t>(pages.rows);
}

/// Those that the budget has room for, at most twice as many as there are tiles: a view takes a part of them.
std::size_t slots_within(const ocl::Device& device, const TileSetShape& shape, std::size_t budget_bytes) {
  const std::size_t fixed_bytes = head_floats_of(shape) * sizeof(float);
  const std::size_t loader_bytes = (TileLoader::most_images + 1) * slot_bytes;
  const std::size_t of_budget = budget_bytes - std::min(budget_bytes, loader_bytes);
  const std::size_t pool_bytes =
      std::min({of_budget, static_cast<std::size_t>(device.info().max_allocation_bytes), most_pool_bytes});
  const std::size_t slots = (pool_bytes - std::min(pool_bytes, fixed_bytes)) / slot_bytes;
  const auto coarsest = static_cast<std::size_t>(shape.tiles_x(shape.coarsest())) *
                        static_cast<std::size_t>(shape.tiles_z(shape.coarsest()));
  const std::size_t needed = coarsest + least_slots;
  if (slots < needed) {
    constexpr double mebibyte = 1 << 20;
    throw Error(
        ErrorKind::bad_input,
        fmt::format("tile cache: expected room for {} tiles, found {} in {:.0f} MiB", needed, slots,
                    static_cast<double>(budget_bytes) / mebibyte),
        fmt::format("give it {:.0f} MiB or more",
                    static_cast<double>(needed * slot_bytes + fixed_bytes + loader_bytes) / mebibyte + 1.0));
  }
  return std::min(slots, 2 * static_cast<std::size_t>(shape.tile_count()) + needed);
}

}  // namespace

TileCache::TileCache(const ocl::Device& device, const TiledMap& map, const TileReader& read,
                     std::size_t budget_bytes)
    : map_(map),
      slots_(slots_within(device, map.shape, budget_bytes)),
      pool_(device, head_floats() + slots_.size() * TERRAIN_SLOT_FLOATS, "terrain tiles"),
      loader_([read, map](const TileKey& key) {
        return tile_image(read(key), map.spacing_x_m, map.spacing_z_m);
      }) {
  const int level = map.shape.coarsest();
  int slot = 0;
  for (int row = 0; row < map.shape.tiles_z(level); ++row) {
    for (int column = 0; column < map.shape.tiles_x(level); ++column) {
      TileImage image = tile_image(read({level, column, row}), map.spacing_x_m, map.spacing_z_m);
      coarsest_m_[{column, row}] = image.highest_m;
      put(slot, std::move(image));
      slots_[static_cast<std::size_t>(slot++)].last_frame = always;
    }
  }
}

std::size_t TileCache::head_floats() const {
  return head_floats_of(map_.shape);
}

std::size_t TileCache::bytes() const {
  return pool_.size() * sizeof(float) + (TileLoader::most_images + 1) * slot_bytes;
}

std::optional<int> TileCache::use(const TileKey& key) {
  const auto found = places_.find(key);
  if (found == places_.end()) return std::nullopt;
  Slot& slot = slots_[static_cast<std::size_t>(found->second)];
  slot.last_frame = std::max(slot.last_frame, frame_);
  return found->second;
}

std::size_t TileCache::want(const std::vector<TileKey>& keys) {
  std::vector<TileKey> missing;
  std::copy_if(keys.begin(), keys.end(), std::back_inserter(missing),
               [&](const TileKey& key) { return !places_.contains(key) && !failed_.contains(key); });
  loader_.want(missing);
  return missing.size();
}

std::optional<int> TileCache::free_slot() const {
  const auto oldest = std::min_element(
      slots_.begin(), slots_.end(), [](const Slot& a, const Slot& b) { return a.last_frame < b.last_frame; });
  if (oldest->last_frame >= frame_) return std::nullopt;
  return static_cast<int>(oldest - slots_.begin());
}

void TileCache::put(int slot, TileImage image) {
  Slot& place = slots_[static_cast<std::size_t>(slot)];
  if (place.key) places_.erase(*place.key);
  place.key = image.key;
  place.square_maxima_m = std::move(image.square_maxima_m);
  place.last_frame = frame_;
  places_[image.key] = slot;
  pool_.write(image.words, head_floats() + static_cast<std::size_t>(slot) * TERRAIN_SLOT_FLOATS);
  ++loaded_;
}

void TileCache::take(TileLoader::Loaded loaded, Unreadable unreadable) {
  if (!loaded.image) {
    if (unreadable == Unreadable::refused) throw Error(ErrorKind::bad_input, loaded.failure, loaded.hint);
    if (failed_.insert(loaded.key).second) {
      spdlog::warn("{}; coarser terrain is shown instead", loaded.failure);
    }
    return;
  }
  // Without a slot it is left, and wanted again if it still is.
  const auto slot = free_slot();
  if (slot && !places_.contains(loaded.key)) put(*slot, std::move(*loaded.image));
}

void TileCache::take_in(Unreadable unreadable) {
  while (auto loaded = loader_.take()) take(std::move(*loaded), unreadable);
}

bool TileCache::wait_and_take_in(Unreadable unreadable) {
  if (!loader_.wait()) return false;
  take_in(unreadable);
  return true;
}

}  // namespace offing::terrain

#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "host/base/height_map.h"
#include "host/base/height_tile.h"
#include "host/io/atomic_file.h"
#include "host/io/file_trust.h"

namespace offing {

/// Along a side of the map of a store.
inline constexpr int most_stored_posts = 1 << 20;

/// What a store says of its map.
struct TileStoreHeader {
  TileSetShape shape;
  double spacing_x_m = 1.0, spacing_z_m = 1.0;
  float lowest_m = 0.0f, highest_m = 0.0f;
  std::uint64_t void_posts = 0;  ///< filled in
  Georeference georeference;     ///< step 0 where the source had none
  std::optional<double> centre_latitude_deg, centre_longitude_deg;
  std::uint64_t heights_checksum = 0;  ///< XXH3 of the map's heights, row by row
};

/// Throws Error(bad_input) that names the file of a map that is too large for a store.
void require_storable(const std::string& map, const TileSetShape& shape);

/// Whether a path is a folder that a store's header lies in.
bool is_tile_store(const std::filesystem::path& path);

/// A height map as a folder of tiles: store.toml (TOML, a value a line), and LEVEL/ROW/COLUMN.tile for every
/// tile of every level (tile_file.h).
class TileStore {
 public:
  /// Throws Error(bad_input) if the folder holds no finished store of this version. Links of an untrusted
  /// store lead nowhere outside of it.
  explicit TileStore(std::filesystem::path folder, Trust trust = Trust::trusted);

  const TileStoreHeader& header() const { return header_; }
  std::filesystem::path path_of(const TileKey& key) const;
  /// Throws Error(bad_input) that names the file if it is missing or not as it was written. Safe to use from
  /// several threads at once.
  HeightTile read(const TileKey& key) const;

 private:
  std::filesystem::path folder_;
  Trust trust_;
  TileStoreHeader header_;
};

/// Fills a folder with a store. The header is written last: a folder without one is no store. An
/// interrupted run resumes: tiles that are equal to those it would write are kept, damaged ones are written
/// again. A finished store that is replaced stays whole until all tiles of the new one are there; tiles that
/// differ wait in the subfolder `.new`.
class TileStoreWriter {
 public:
  /// Makes the folder. Throws Error(bad_usage) if it holds something else, or a finished store that may not
  /// be replaced; Error(file) if it cannot be made or read.
  TileStoreWriter(std::filesystem::path folder, Existing existing);

  /// Writes a tile unless it is there; returns whether it was written. Throws Error(bad_usage) for a whole
  /// tile of another map that may not be replaced. Safe to use from several threads at once.
  bool write(const HeightTile& tile) const;
  /// Publishes the store, without what is left of a store of another shape.
  void finish(const TileStoreHeader& header) const;
  /// Removes what was written beside a finished store, which stays as it is.
  void discard() const;

 private:
  void remove_partials() const;

  std::filesystem::path folder_;
  Existing existing_;
  bool is_replacement_;  ///< of a finished store
};

}  // namespace offing

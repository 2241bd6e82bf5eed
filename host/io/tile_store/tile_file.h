#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "host/base/height_tile.h"

namespace offing::tile_store {

/// The bytes of a tile's file: magic, version, key, and the two layers of heights with their checksum (XXH3).
/// Heights of the map and highest posts are kept to the last bit, as 16-bit whole metres where they are
/// such; means of level 1 and up as 65536 steps between their lowest and highest; voids, where there are any,
/// as bits. Equal tiles have equal bytes.
std::string encode_tile(const HeightTile& tile);

/// Whether bytes begin as those of a tile do, though they may be damaged behind that; also if there are none.
bool is_begun_as_tile(std::string_view bytes);

/// Writes the checksum of a file's bytes, at least a header, into them: encode_tile() has done so. For tests.
void seal_tile(std::string& bytes);

/// The tile of a file's bytes. Throws Error(bad_input) that names the file if they are of another version or
/// tile, too few or too many, not as they were written, or hold heights that are not finite or too far.
HeightTile decode_tile(const std::filesystem::path& path, std::string_view bytes, const TileKey& key);

}  // namespace offing::tile_store

#include "host/io/tile_store/tile_file.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <vector>

#include <fmt/format.h>

#define XXH_INLINE_ALL
#include <xxhash.h>

#include "host/base/error.h"

namespace offing::tile_store {
namespace {

static_assert(std::endian::native == std::endian::little, "files are written as they lie in memory");

constexpr std::uint64_t magic = 0x656c69742d66666fULL;  // "off-tile"
constexpr std::uint32_t format_version = 2;

enum class Encoding : std::uint32_t {
  floats,  ///< as they are
  steps,   ///< lowest + 16-bit number times step
  middle,  ///< those of the other layer without its ring
};

struct Layer {
  Encoding encoding = Encoding::floats;
  float lowest_m = 0.0f, step_m = 0.0f;
};

struct Header {
  std::uint64_t magic, checksum;  ///< of all bytes behind the checksum
  std::uint32_t version;
  std::int32_t level, column, row;
  Layer means, highest;
  std::uint64_t void_bytes;  ///< of the voids, a bit a post, behind the layers; 0: there are none
};
static_assert(sizeof(Header) == 64, "no padding");

constexpr std::size_t checked_from = 16;
constexpr std::size_t ringed_posts = std::size_t{ringed_tile_posts} * ringed_tile_posts;
constexpr std::size_t plain_posts = std::size_t{tile_posts} * tile_posts;
constexpr std::size_t void_bytes = (plain_posts + 7) / 8;
constexpr float most_steps = 65535.0f;
// Heights are within 1e6 m; means beyond the map's edge go on straight.
constexpr float farthest_height_m = 4e6f;

enum class Rounding { none, allowed };

Layer layer_for(const std::vector<float>& heights_m, Rounding rounding) {
  const auto [lowest, highest] = std::minmax_element(heights_m.begin(), heights_m.end());
  const bool is_whole =
      *highest - *lowest <= most_steps && std::abs(*lowest) < most_steps &&
      std::all_of(heights_m.begin(), heights_m.end(), [](float h) { return h == std::nearbyint(h); });
  if (is_whole) return {Encoding::steps, *lowest, 1.0f};
  if (rounding == Rounding::none) return {};
  return {Encoding::steps, *lowest, (*highest - *lowest) / most_steps};
}

void append(std::string& bytes, const void* data, std::size_t count) {
  bytes.append(static_cast<const char*>(data), count);
}

void append_layer(std::string& bytes, const Layer& layer, const std::vector<float>& heights_m) {
  if (layer.encoding == Encoding::floats) append(bytes, heights_m.data(), heights_m.size() * sizeof(float));
  if (layer.encoding != Encoding::steps) return;
  std::vector<std::uint16_t> steps(heights_m.size());
  const float inverse = layer.step_m > 0.0f ? 1.0f / layer.step_m : 0.0f;
  std::transform(heights_m.begin(), heights_m.end(), steps.begin(), [&](float height_m) {
    return static_cast<std::uint16_t>(
        std::clamp(std::nearbyint((height_m - layer.lowest_m) * inverse), 0.0f, most_steps));
  });
  append(bytes, steps.data(), steps.size() * sizeof(std::uint16_t));
}

std::vector<float> middle_of(const std::vector<float>& ringed_m) {
  std::vector<float> middle;
  middle.reserve(plain_posts);
  for (int row = 1; row <= tile_posts; ++row) {
    const auto first = ringed_m.begin() + row * ringed_tile_posts + 1;
    middle.insert(middle.end(), first, first + tile_posts);
  }
  return middle;
}

std::size_t layer_bytes(const Layer& layer, std::size_t posts) {
  switch (layer.encoding) {
    case Encoding::floats:
      return posts * sizeof(float);
    case Encoding::steps:
      return posts * sizeof(std::uint16_t);
    case Encoding::middle:
      break;
  }
  return 0;
}

std::vector<float> read_layer(const Layer& layer, const char* bytes, std::size_t posts) {
  std::vector<float> heights_m(posts);
  if (layer.encoding == Encoding::floats) {
    std::memcpy(heights_m.data(), bytes, posts * sizeof(float));
    return heights_m;
  }
  std::vector<std::uint16_t> steps(posts);
  std::memcpy(steps.data(), bytes, posts * sizeof(std::uint16_t));
  std::transform(steps.begin(), steps.end(), heights_m.begin(), [&](std::uint16_t step) {
    return layer.lowest_m + static_cast<float>(step) * layer.step_m;
  });
  return heights_m;
}

/// Empty if there are none.
std::vector<std::uint8_t> packed_voids(const std::vector<std::uint8_t>& is_void) {
  if (is_void.empty()) return {};
  std::vector<std::uint8_t> packed(void_bytes);
  for (std::size_t i = 0; i < plain_posts; ++i) {
    if (is_void[i] != 0) packed[i / 8] = static_cast<std::uint8_t>(packed[i / 8] | 1u << i % 8);
  }
  return packed;
}

std::vector<std::uint8_t> unpacked_voids(std::string_view packed) {
  std::vector<std::uint8_t> is_void(plain_posts);
  for (std::size_t i = 0; i < plain_posts; ++i) {
    is_void[i] = static_cast<std::uint8_t>(static_cast<unsigned char>(packed[i / 8]) >> i % 8 & 1u);
  }
  return is_void;
}

bool are_heights(const std::vector<float>& heights_m) {
  std::size_t wrong = 0;  // counted, not sought: twice as quick, and NaN is wrong too
  for (const float height_m : heights_m) wrong += std::abs(height_m) <= farthest_height_m ? 0 : 1;
  return wrong == 0;
}

std::uint64_t checksum_of(std::string_view bytes) {
  return XXH3_64bits(bytes.data() + checked_from, bytes.size() - checked_from);
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& what) {
  throw Error(ErrorKind::bad_input, fmt::format("{}: {}", path.string(), what),
              "make the store again with `offing terrain tile`: tiles that are whole are kept");
}

}  // namespace

std::string encode_tile(const HeightTile& tile) {
  const TileKey& key = tile.key;
  Header header{magic, 0, format_version, key.level, key.column, key.row, {}, {}, 0};
  header.means = layer_for(tile.means_m, key.level == 0 ? Rounding::none : Rounding::allowed);
  header.highest = key.level == 0 && middle_of(tile.means_m) == tile.highest_m
                       ? Layer{Encoding::middle, 0.0f, 0.0f}
                       : layer_for(tile.highest_m, Rounding::none);
  const std::vector<std::uint8_t> voids = packed_voids(tile.is_void);
  header.void_bytes = voids.size();
  std::string bytes;
  bytes.reserve(sizeof(Header) + layer_bytes(header.means, ringed_posts) +
                layer_bytes(header.highest, plain_posts) + voids.size());
  append(bytes, &header, sizeof(Header));
  append_layer(bytes, header.means, tile.means_m);
  append_layer(bytes, header.highest, tile.highest_m);
  append(bytes, voids.data(), voids.size());
  seal_tile(bytes);
  return bytes;
}

void seal_tile(std::string& bytes) {
  const std::uint64_t checksum = checksum_of(bytes);
  std::memcpy(bytes.data() + sizeof(magic), &checksum, sizeof(checksum));
}

bool is_begun_as_tile(std::string_view bytes) {
  return bytes.empty() ||
         (bytes.size() >= sizeof magic && std::memcmp(bytes.data(), &magic, sizeof magic) == 0);
}

HeightTile decode_tile(const std::filesystem::path& path, std::string_view bytes, const TileKey& key) {
  Header header{};
  if (bytes.size() >= sizeof(Header)) std::memcpy(&header, bytes.data(), sizeof(Header));
  if (header.magic != magic)
    refuse(path, fmt::format("expected a tile, found {} bytes of something else", bytes.size()));
  if (header.version != format_version) {
    refuse(path,
           fmt::format("expected a tile of version {}, found version {}", format_version, header.version));
  }
  if (header.checksum != checksum_of(bytes)) {
    refuse(path, fmt::format("expected checksum {:016x}, found {:016x}: the tile is damaged or cut short",
                             header.checksum, checksum_of(bytes)));
  }
  const TileKey found{header.level, header.column, header.row};
  if (found != key) {
    refuse(path,
           fmt::format(
               "expected the tile of level {}, column {}, row {}, found that of level {}, column {}, row {}",
               key.level, key.column, key.row, found.level, found.column, found.row));
  }
  // The checksum finds damage; it says nothing about who wrote the file.
  if (header.means.encoding > Encoding::steps || header.highest.encoding > Encoding::middle) {
    refuse(path, fmt::format("expected encodings 0 or 1 and 0, 1 or 2, found {} and {}",
                             static_cast<std::uint32_t>(header.means.encoding),
                             static_cast<std::uint32_t>(header.highest.encoding)));
  }
  const std::size_t means_bytes = layer_bytes(header.means, ringed_posts);
  const std::size_t highest_bytes = layer_bytes(header.highest, plain_posts);
  const bool are_voids_right = header.void_bytes == 0 || header.void_bytes == void_bytes;
  if (!are_voids_right || bytes.size() != sizeof(Header) + means_bytes + highest_bytes + header.void_bytes) {
    refuse(path, fmt::format("expected as many heights as a tile has, found {} bytes", bytes.size()));
  }
  HeightTile tile{key, {}, read_layer(header.means, bytes.data() + sizeof(Header), ringed_posts)};
  tile.highest_m = header.highest.encoding == Encoding::middle
                       ? middle_of(tile.means_m)
                       : read_layer(header.highest, bytes.data() + sizeof(Header) + means_bytes, plain_posts);
  if (!are_heights(tile.means_m) || !are_heights(tile.highest_m)) {
    refuse(path, fmt::format("expected heights within {:g} m, found others", farthest_height_m));
  }
  if (header.void_bytes > 0) {
    tile.is_void = unpacked_voids(bytes.substr(sizeof(Header) + means_bytes + highest_bytes));
  }
  return tile;
}

}  // namespace offing::tile_store

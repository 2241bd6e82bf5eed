// A file of a tile is long: the input is its header and what follows, which is repeated to the length that
// the header asks for unless the first byte is odd. The checksum is made right, or nothing else would be
// tried.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <string>

#include "host/io/tile_store/tile_file.h"
#include "tests/fuzz/expect.h"

namespace {

using offing::HeightTile;
using offing::fuzz::expect;

constexpr std::size_t header_bytes = 64;
constexpr std::size_t ringed_posts = std::size_t{offing::ringed_tile_posts} * offing::ringed_tile_posts;
constexpr std::size_t posts = std::size_t{offing::tile_posts} * offing::tile_posts;

/// The number of bytes that encode a layer: floats or 16-bit steps.
std::size_t layer_bytes(const std::string& file, std::size_t place, std::size_t heights) {
  std::uint32_t encoding = 0;
  std::memcpy(&encoding, file.data() + place, sizeof(encoding));
  return encoding == 0 ? 4 * heights : encoding == 1 ? 2 * heights : 0;
}

void expect_contract(const HeightTile& tile) {
  expect(tile.means_m.size() == ringed_posts && tile.highest_m.size() == posts);
  expect(tile.is_void.empty() || tile.is_void.size() == posts);
  for (const float height_m : tile.means_m) expect(std::isfinite(height_m));
  for (const float height_m : tile.highest_m) expect(std::isfinite(height_m));
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  if (size < 1 + header_bytes) return -1;  // do not keep it
  std::string file(reinterpret_cast<const char*>(data) + 1, size - 1);
  if (data[0] % 2 == 0 && file.size() > header_bytes) {
    std::uint64_t voids = 0;
    std::memcpy(&voids, file.data() + 56, sizeof(voids));
    const std::string pattern = file.substr(header_bytes);
    const std::size_t bytes = header_bytes + layer_bytes(file, 32, ringed_posts) +
                              layer_bytes(file, 44, posts) + (voids == 0 ? 0 : (posts + 7) / 8);
    file.resize(header_bytes);
    while (file.size() < bytes) file += pattern;
    file.resize(bytes);
  }
  offing::tile_store::seal_tile(file);
  return offing::fuzz::check_reading([&] {
    expect_contract(offing::tile_store::decode_tile("0000.tile", file, {0, 0, 0}));
  });
}

// Stores as they are written, read, stopped and damaged.
#include "host/io/tile_store/tile_store.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "host/io/tile_store/tile_file.h"
#include "tests/io/temporary_folder.h"
#include "tests/ocl/expect_error.h"

namespace offing {
namespace {

namespace fs = std::filesystem;

using Height = std::function<double(int, int)>;

/// A tile whose ring, and at level 0 whose middle, have these heights.
HeightTile made(const TileKey& key, const Height& height_m) {
  HeightTile tile{key, {}, {}};
  for (int row = -1; row <= tile_posts; ++row) {
    for (int column = -1; column <= tile_posts; ++column) {
      tile.means_m.push_back(static_cast<float>(height_m(column, row)));
      const bool is_inside = row >= 0 && row < tile_posts && column >= 0 && column < tile_posts;
      if (is_inside) tile.highest_m.push_back(static_cast<float>(height_m(column, row) + 10.0 * key.level));
    }
  }
  return tile;
}

double hills(int column, int row) {
  return 300.0 * std::sin(0.05 * column) * std::cos(0.031 * row) + 0.125 * column;
}

std::string bytes_of(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// Content by name of all files below a folder.
std::map<std::string, std::string> content_of(const fs::path& folder) {
  std::map<std::string, std::string> content;
  for (const auto& entry : fs::recursive_directory_iterator(folder)) {
    if (entry.is_regular_file()) content[fs::relative(entry.path(), folder)] = bytes_of(entry.path());
  }
  return content;
}

class TileStoreTest : public ::testing::Test {
 protected:
  /// Writes tiles of a map of 600 x 300 posts until so many are written; finishes it if all are.
  int write(const fs::path& folder, int most, Existing existing = Existing::keep,
            double raised_m = 0.0) const {
    const TileSetShape shape = TileSetShape::of(600, 300);
    const TileStoreWriter writer(folder, existing);
    int written = 0;
    for (int level = 0; level < shape.levels; ++level) {
      for (int row = 0; row < shape.tiles_z(level); ++row) {
        for (int column = 0; column < shape.tiles_x(level); ++column) {
          if (written == most) return written;
          written += writer.write(made(
                         {level, column, row},
                         [&](int x, int z) { return raised_m + hills(x + 256 * column, z + 256 * row); }))
                         ? 1
                         : 0;
        }
      }
    }
    writer.finish(header());
    return written;
  }
  static TileStoreHeader header() {
    return {.shape = TileSetShape::of(600, 300),
            .spacing_x_m = 1.0 / 3.0,
            .spacing_z_m = 30.0,
            .lowest_m = -300.25f,
            .highest_m = 375.1f,
            .void_posts = 7,
            .georeference = {"PROJCS[\"a \"\"system\"\"\"]", 1e6, -2.5, 0.1, -0.1},
            .centre_latitude_deg = 46.123456789,
            .centre_longitude_deg = -7.0,
            .heights_checksum = 0xfedcba9876543210u};
  }
  fs::path folder() const { return temporary_.path() / "store"; }

  TemporaryFolder temporary_;
};

// Fails if a number loses digits on its way through the header.
TEST_F(TileStoreTest, KeepsTheHeader) {
  write(folder(), 1000);
  ASSERT_TRUE(is_tile_store(folder()));
  const TileStoreHeader found = TileStore(folder()).header(), expected = header();
  EXPECT_EQ(found.shape.columns, 600);
  EXPECT_EQ(found.shape.rows, 300);
  EXPECT_EQ(found.shape.levels, 3);
  EXPECT_EQ(found.spacing_x_m, expected.spacing_x_m);
  EXPECT_EQ(found.spacing_z_m, expected.spacing_z_m);
  EXPECT_EQ(found.lowest_m, expected.lowest_m);
  EXPECT_EQ(found.highest_m, expected.highest_m);
  EXPECT_EQ(found.void_posts, 7u);
  EXPECT_EQ(found.georeference.coordinate_system, expected.georeference.coordinate_system);
  EXPECT_EQ(found.georeference.origin_x, expected.georeference.origin_x);
  EXPECT_EQ(found.georeference.step_y, expected.georeference.step_y);
  EXPECT_EQ(found.centre_latitude_deg, expected.centre_latitude_deg);
  EXPECT_EQ(found.centre_longitude_deg, expected.centre_longitude_deg);
  EXPECT_EQ(found.heights_checksum, expected.heights_checksum);
}

// Heights of the map and highest posts come back to the last bit; means of coarse levels within half a step,
// a 65536th of their range. Whole metres take half the room.
TEST_F(TileStoreTest, KeepsTiles) {
  const auto through = [](const HeightTile& tile) {
    return tile_store::decode_tile("a.tile", tile_store::encode_tile(tile), tile.key);
  };
  for (const TileKey key : {TileKey{0, 3, 4}, TileKey{2, 0, 1}}) {
    const HeightTile tile = made(key, hills), read = through(tile);
    EXPECT_EQ(read.highest_m, tile.highest_m);
    ASSERT_EQ(read.means_m.size(), tile.means_m.size());
    const auto [low, high] = std::minmax_element(tile.means_m.begin(), tile.means_m.end());
    const float gate_m = key.level == 0 ? 0.0f : 0.51f * (*high - *low) / 65535.0f + 1e-4f;
    for (std::size_t i = 0; i < tile.means_m.size(); ++i) {
      ASSERT_NEAR(read.means_m[i], tile.means_m[i], gate_m);
    }
  }
  const HeightTile whole = made({0, 0, 0}, [](int x, int z) { return x - 3 * z - 500; });
  EXPECT_EQ(through(whole).highest_m, whole.highest_m);
  EXPECT_EQ(through(whole).means_m, whole.means_m);
  EXPECT_LT(20 * tile_store::encode_tile(whole).size(),
            11 * tile_store::encode_tile(made({0, 0, 0}, hills)).size());
  // Beyond 16 bits they are floats again.
  const HeightTile deep = made({0, 0, 0}, [](int x, int) { return 300.0 * x; });
  EXPECT_EQ(through(deep).highest_m, deep.highest_m);
  // A level plain has no range.
  const HeightTile plain = made({1, 0, 0}, [](int, int) { return 2.7; });
  EXPECT_EQ(through(plain).means_m, plain.means_m);
}

// Fails if what was filled in counts as measured once it has been through a file, or the other way round.
TEST_F(TileStoreTest, KeepsVoids) {
  HeightTile tile = made({0, 1, 2}, hills);
  const std::string whole = tile_store::encode_tile(tile);
  tile.is_void.resize(tile.highest_m.size());
  for (const std::size_t i : {0u, 1u, 9u, 300u, 66047u, 66048u}) tile.is_void[i] = 1;
  const std::string bytes = tile_store::encode_tile(tile);
  EXPECT_EQ(tile_store::decode_tile("a.tile", bytes, tile.key).is_void, tile.is_void);
  EXPECT_EQ(bytes.size() - whole.size(), (257u * 257u + 7u) / 8u);
  EXPECT_TRUE(tile_store::decode_tile("a.tile", whole, tile.key).is_void.empty());
}

// A run that is stopped between any two tiles, and goes on, ends with the bytes of one that was not; what it
// had written is kept, what was cut short or changed meanwhile is written again.
TEST_F(TileStoreTest, GoesOnAfterAnyTile) {
  const fs::path once = temporary_.path() / "once";
  const int all = write(once, 1000);
  EXPECT_EQ(all, 9);
  const auto expected = content_of(once);
  for (int stop = 0; stop < all; ++stop) {
    const fs::path stopped = temporary_.path() / ("stopped" + std::to_string(stop));
    EXPECT_EQ(write(stopped, stop), stop);
    EXPECT_FALSE(is_tile_store(stopped)) << stop;
    if (stop > 0) {
      const fs::path first = stopped / "0" / "0000" / "0000.tile";
      fs::resize_file(first, fs::file_size(first) / 2);
      std::ofstream(first.parent_path() / ".0001.tile.0123456789abcdef.partial") << "left by a kill";
    }
    EXPECT_EQ(write(stopped, 1000), all - stop + (stop > 0 ? 1 : 0)) << stop;
    EXPECT_EQ(content_of(stopped), expected) << stop;
  }
}

// Fails if a run without permission to replace writes over a whole tile of another map, or a file that is
// none.
TEST_F(TileStoreTest, GoesOnWithItsOwnTilesOnly) {
  write(folder(), 5);
  const auto before = content_of(folder());
  test::expect_error(ErrorKind::bad_usage, "expected a tile of this map, found another file",
                     [&] { write(folder(), 1000, Existing::keep, 10.0); });
  EXPECT_EQ(content_of(folder()), before);
  const fs::path tile = folder() / "0" / "0000" / "0000.tile";
  std::ofstream(tile) << "mine";
  test::expect_error(ErrorKind::bad_usage, tile.string(), [&] { write(folder(), 1000); });
  EXPECT_EQ(bytes_of(tile), "mine");
  EXPECT_EQ(write(folder(), 1000, Existing::replace, 10.0), 9);
}

// Fails if a finished store loses anything before the one that replaces it is complete, or if that one is not
// the same as a new one, also where an earlier run for another map was stopped.
TEST_F(TileStoreTest, KeepsAFinishedStoreUntilItIsReplaced) {
  using enum Existing;
  const fs::path once = temporary_.path() / "once";
  write(once, 1000, keep, 10.0);
  write(folder(), 1000);
  const auto before = content_of(folder());
  for (const int stop : {0, 1, 8}) {
    EXPECT_EQ(write(folder(), stop, replace, stop == 8 ? 20.0 : 10.0), stop == 8 ? 8 : stop);
    const auto found = content_of(folder());
    for (const auto& [name, bytes] : before) EXPECT_EQ(found.at(name), bytes) << name;
    EXPECT_EQ(TileStore(folder()).read({0, 0, 0}).key, (TileKey{0, 0, 0}));
  }
  EXPECT_EQ(write(folder(), 1000, replace, 10.0), 9);
  EXPECT_EQ(content_of(folder()), content_of(once));
  EXPECT_FALSE(fs::exists(folder() / ".new"));
  // Equal tiles are kept.
  EXPECT_EQ(write(folder(), 1000, replace, 10.0), 0);
}

// Fails if folders are made before there are tiles for them.
TEST_F(TileStoreTest, MakesFoldersAsTilesCome) {
  const TileStoreWriter writer(folder(), Existing::keep);
  EXPECT_TRUE(fs::is_empty(folder()));
}

// A store that replaces a larger one has its own tiles only, and leaves a stranger's file alone.
TEST_F(TileStoreTest, KeepsNoTilesOfAnotherShape) {
  const fs::path once = temporary_.path() / "once";
  write(once, 1000);
  const auto expected = content_of(once);
  write(folder(), 1000);
  for (const char* other : {"0/0000/0003.tile", "0/0002/0000.tile", "3/0000/0000.tile"}) {
    const fs::path tile = folder() / other;
    fs::create_directories(tile.parent_path());
    std::ofstream(tile) << "of a larger map";
  }
  std::ofstream(folder() / "0" / "0002" / "notes.txt") << "keep";
  fs::remove(folder() / "store.toml");
  EXPECT_EQ(write(folder(), 1000), 0);
  auto found = content_of(folder());
  EXPECT_EQ(found["0/0002/notes.txt"], "keep");
  found.erase("0/0002/notes.txt");
  EXPECT_EQ(found, expected);
  EXPECT_FALSE(fs::exists(folder() / "3"));
}

// Every kind of damage names the file: a bit, a cut, another tile's content, none at all.
TEST_F(TileStoreTest, NamesDamagedTiles) {
  write(folder(), 1000);
  const TileStore store(folder());
  EXPECT_EQ(store.read({0, 1, 1}).key, (TileKey{0, 1, 1}));
  const auto damage = [&](const TileKey& key, const std::function<void(const fs::path&)>& change,
                          const std::string& part) {
    const fs::path path = store.path_of(key);
    change(path);
    test::expect_error(ErrorKind::bad_input, part, [&] { store.read(key); });
    test::expect_error(ErrorKind::bad_input, path.string(), [&] { store.read(key); });
  };
  damage(
      {0, 0, 0},
      [](const fs::path& path) {
        std::fstream file(path, std::ios::in | std::ios::out | std::ios::binary);
        file.seekp(5000);
        file.put('x');
      },
      "checksum");
  damage(
      {0, 1, 0}, [](const fs::path& path) { fs::resize_file(path, 10'000); }, "checksum");
  damage(
      {0, 2, 0}, [](const fs::path& path) { fs::resize_file(path, 12); }, "12 bytes");
  damage(
      {0, 0, 1}, [](const fs::path& path) { fs::remove(path); }, "found none");
  damage(
      {1, 0, 0},
      [&](const fs::path& path) {
        fs::copy_file(store.path_of({1, 1, 0}), path, fs::copy_options::overwrite_existing);
      },
      "column 0");
}

// A checksum that is right says nothing about who wrote the file. Fails if an encoding that no layer has is
// believed (what lay behind the bytes was read), or a height that rays cannot meet.
TEST_F(TileStoreTest, RefusesTilesThatLie) {
  const TileKey key{1, 0, 0};
  const std::string whole = tile_store::encode_tile(made(key, hills));
  const auto with = [&](std::size_t place, auto value, std::size_t bytes, const std::string& part) {
    std::string changed = whole.substr(0, bytes);
    std::memcpy(changed.data() + place, &value, sizeof(value));
    tile_store::seal_tile(changed);
    test::expect_error(ErrorKind::bad_input, part,
                       [&] { tile_store::decode_tile("0000.tile", changed, key); });
  };
  constexpr std::size_t header_bytes = 64, means_bytes = 2 * ringed_tile_posts * ringed_tile_posts;
  ASSERT_EQ(whole.size(), header_bytes + means_bytes + sizeof(float) * tile_posts * tile_posts);
  with(32, std::uint32_t{2}, whole.size() - means_bytes, "found 2 and 0");
  with(44, std::uint32_t{7}, header_bytes + means_bytes, "found 1 and 7");
  for (const float wrong : {std::nanf(""), INFINITY, -5e6f}) {
    with(36, wrong, whole.size(), "expected heights within");
    with(whole.size() - sizeof(float), wrong, whole.size(), "expected heights within");
  }
}

TEST_F(TileStoreTest, RefusesWhatIsNoStore) {
  test::expect_error(ErrorKind::bad_input, "store.toml", [&] { TileStore(temporary_.path()); });
  write(folder(), 1000);
  test::expect_error(ErrorKind::bad_usage, "found a finished tile store", [&] { write(folder(), 1000); });
  std::string text = bytes_of(folder() / "store.toml");
  const auto with = [&](const std::string& line, const std::string& part) {
    std::ofstream(folder() / "store.toml") << line << "\n" << text.substr(text.find("tile_cells"));
    test::expect_error(ErrorKind::bad_input, part, [&] { TileStore store(folder()); });
  };
  with("version = 1\ncolumns = 600\nrows = 300", "version");
  with("version = 2\ncolumns = 1\nrows = 300", "columns");
  with("version = 2\ncolumns = 6000\nrows = 300", "levels");
  with("version = 2\nrows = 300", "columns");
  with("version = 2\ncolumns = 2e56\nrows = 300", "columns");  // converting it is undefined: UBSan stops here
  with("version = = 1", "TOML");
  std::string deep = "a";
  for (int i = 0; i < 40'000; ++i) deep += ".a";
  with("[" + deep + "]", "nested names or brackets");
  with("version = f\n.i00rst = 0.0", "TOML");  // in one line, although the fault is a line break
  const auto with_values = [&](const std::map<std::string, std::string>& values, const std::string& part) {
    std::string changed = text;
    for (const auto& [key, value] : values) {
      const std::size_t begin = changed.find(key);
      changed.replace(begin, changed.find('\n', begin) - begin, key + " = " + value);
    }
    std::ofstream(folder() / "store.toml") << changed;
    test::expect_error(ErrorKind::bad_input, part, [&] { TileStore store(folder()); });
  };
  with_values({{"lowest_m", "nan"}}, "lowest_m");
  with_values({{"highest_m", "inf"}}, "highest_m");
  with_values({{"lowest_m", "5.0"}, {"highest_m", "1.0"}}, "highest_m: expected 5 or more");
  with_values({{"first_post_x", "inf"}}, "first_post_x: expected a finite number");
  const fs::path other = temporary_.path() / "other";
  fs::create_directory(other);
  std::ofstream(other / "letter.txt") << "mine";
  test::expect_error(ErrorKind::bad_usage, "letter.txt", [&] { write(other, 1000); });
  EXPECT_EQ(content_of(other).size(), 1u);
}

}  // namespace
}  // namespace offing

// Volumes as OpenVDB files: what is written is read again, by us and by vdb_print, and what is wrong is
// refused.

#include "host/io/vdb/vdb_volume.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <optional>
#include <random>
#include <string>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "tests/io/temporary_folder.h"

namespace offing {
namespace {

using ::testing::HasSubstr;

constexpr std::size_t cells = CloudVolume::cells_of_brick;

/// 3 x 2 x 4 bricks, of which those are kept whose place is not a multiple of 3; values from 0 to 4.
CloudVolume example_volume() {
  CloudVolume volume{.origin_m = {1000.25, 800.0, -40.5},
                     .cell_m = 12.5,
                     .bricks = {3, 2, 4},
                     .extinction_per_m = 0.03,
                     .brick_of = {},
                     .density = {}};
  std::mt19937 random(7);
  for (int place = 0; place < 24; ++place) {
    const bool is_kept = place % 3 != 0;
    volume.brick_of.push_back(is_kept ? static_cast<std::int32_t>(volume.density.size() / cells)
                                      : CloudVolume::no_brick);
    for (std::size_t i = 0; is_kept && i < cells; ++i) {
      const auto value = static_cast<float>(random() % 4096) / 1024.0f;
      volume.density.push_back(random() % 3 == 0 ? 0.0f : value);
    }
  }
  return volume;
}

double sum_of(const CloudVolume& volume) {
  double sum = 0.0;
  for (const float value : volume.density) sum += value;
  return sum;
}

/// By indices of cells.
float value_at(const CloudVolume& volume, int x, int y, int z) {
  const int place = (z / 8 * volume.bricks[1] + y / 8) * volume.bricks[0] + x / 8;
  const std::int32_t slot = volume.brick_of[static_cast<std::size_t>(place)];
  if (slot == CloudVolume::no_brick) return 0.0f;
  return volume.density[static_cast<std::size_t>(slot) * cells +
                        static_cast<std::size_t>((z % 8 * 8 + y % 8) * 8 + x % 8)];
}

/// Largest difference of two volumes with the same cells.
double difference(const CloudVolume& a, const CloudVolume& b) {
  double most = 0.0;
  for (int z = 0; z < 8 * a.bricks[2]; ++z) {
    for (int y = 0; y < 8 * a.bricks[1]; ++y) {
      for (int x = 0; x < 8 * a.bricks[0]; ++x) {
        most = std::max(most, std::abs(double{value_at(a, x, y, z)} - value_at(b, x, y, z)));
      }
    }
  }
  return most;
}

std::string bytes_of(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void write_bytes(const std::filesystem::path& path, const std::string& bytes) {
  std::ofstream(path, std::ios::binary) << bytes;
}

std::optional<Error> error_of(const std::filesystem::path& path) {
  try {
    read_vdb(path);
    return std::nullopt;
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
    EXPECT_EQ(std::string(error.what()).find('\n'), std::string::npos) << error.what();
    EXPECT_THAT(error.what(), HasSubstr(path.filename().string()));
    EXPECT_FALSE(error.hint().empty()) << error.what();
    return error;
  }
}

class VdbVolume : public ::testing::Test {
 protected:
  std::filesystem::path in_folder(const char* name) const { return folder_.path() / name; }

  TemporaryFolder folder_;
};

// Fails if cells move, bricks are lost or swapped, or place and extinction do not come back.
TEST_F(VdbVolume, GivesTheSameVolumeAgain) {
  const CloudVolume volume = example_volume();
  write_vdb(in_folder("a.vdb"), {volume});
  const VdbCloud back = read_vdb(in_folder("a.vdb"));
  EXPECT_EQ(back.volume.origin_m, volume.origin_m);
  EXPECT_EQ(back.volume.cell_m, volume.cell_m);
  EXPECT_EQ(back.volume.bricks, volume.bricks);
  EXPECT_EQ(back.volume.extinction_per_m, volume.extinction_per_m);
  EXPECT_EQ(difference(volume, back.volume), 0.0);
  EXPECT_TRUE(back.albedo.empty());
  EXPECT_TRUE(back.tells_extinction);
}

// A half has 11 bits: values below 4 are off by at most 2^-10, half the last bit's worth. The values are
// multiples of 2^-10 below 4, of which those below 2 are exact. Fails if halves lose the sum of density.
TEST_F(VdbVolume, HalvesKeepTheSum) {
  const CloudVolume volume = example_volume();
  write_vdb(in_folder("a.vdb"), {volume}, VdbPrecision::half);
  const VdbCloud back = read_vdb(in_folder("a.vdb"));
  EXPECT_LE(difference(volume, back.volume), std::ldexp(1.0, -10));
  EXPECT_NEAR(sum_of(back.volume) / sum_of(volume), 1.0, 1e-3);
  write_vdb(in_folder("b.vdb"), {volume});
  EXPECT_LT(std::filesystem::file_size(in_folder("a.vdb")), std::filesystem::file_size(in_folder("b.vdb")));
}

// Fails if colours come back in other cells.
TEST_F(VdbVolume, KeepsColours) {
  const CloudVolume volume = example_volume();
  VdbCloud cloud{volume};
  std::mt19937 random(8);
  for (std::size_t i = 0; i < volume.density.size(); ++i) {
    const auto share = [&] { return static_cast<float>(random() % 256) / 255.0f; };
    cloud.albedo.push_back({share(), share(), share()});
  }
  write_vdb(in_folder("a.vdb"), cloud);
  const VdbCloud back = read_vdb(in_folder("a.vdb"));
  ASSERT_EQ(back.albedo.size(), back.volume.density.size());
  for (std::size_t place = 0; place < volume.brick_of.size(); ++place) {
    if (volume.brick_of[place] == CloudVolume::no_brick) continue;
    for (std::size_t i = 0; i < cells; ++i) {
      const std::size_t here = static_cast<std::size_t>(volume.brick_of[place]) * cells + i;
      const std::size_t there = static_cast<std::size_t>(back.volume.brick_of[place]) * cells + i;
      if (volume.density[here] > 0.0f) {
        EXPECT_EQ(back.albedo[there], cloud.albedo[here]);
      }
    }
  }
}

// Fails if a file depends on the clock or on chance.
TEST_F(VdbVolume, TheSameCloudGivesTheSameBytes) {
  const CloudVolume volume = example_volume();
  write_vdb(in_folder("a.vdb"), {volume});
  write_vdb(in_folder("b.vdb"), {volume});
  EXPECT_EQ(bytes_of(in_folder("a.vdb")), bytes_of(in_folder("b.vdb")));
}

// Sums of floats end a little below 0 where terms cancel.
TEST_F(VdbVolume, ClampsTracesBelowZero) {
  CloudVolume volume = example_volume();
  volume.density[3] = -1e-6f;
  write_vdb(in_folder("a.vdb"), {volume});
  const CloudVolume back = read_vdb(in_folder("a.vdb")).volume;
  for (const float value : back.density) EXPECT_GE(value, 0.0f);
}

TEST_F(VdbVolume, RefusesToWriteWhatIsNoDensity) {
  for (const float wrong :
       {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), -1.0f}) {
    CloudVolume volume = example_volume();
    volume.density[600] = wrong;
    try {
      write_vdb(in_folder("a.vdb"), {volume});
      FAIL() << "wrote " << wrong;
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
      EXPECT_THAT(error.what(), HasSubstr("value 88 of brick 1"));
    }
    EXPECT_FALSE(std::filesystem::exists(in_folder("a.vdb")));
  }
  CloudVolume volume = example_volume();
  volume.density[0] = 70'000.0f;
  EXPECT_THROW(write_vdb(in_folder("a.vdb"), {volume}, VdbPrecision::half), Error);
  volume.brick_of[1] = 1000;
  EXPECT_THROW(write_vdb(in_folder("a.vdb"), {volume}), Error);
  EXPECT_THROW(write_vdb(in_folder("missing/a.vdb"), {example_volume()}), Error);
}

TEST_F(VdbVolume, RefusesWhatIsNoVdb) {
  EXPECT_THAT(error_of(in_folder("a.vdb"))->what(), HasSubstr("none"));
  EXPECT_THAT(error_of(folder_.path())->what(), HasSubstr("a folder"));
  write_bytes(in_folder("a.vdb"), "");
  EXPECT_TRUE(error_of(in_folder("a.vdb")));
  write_bytes(in_folder("a.vdb"), std::string(5000, 'x'));
  EXPECT_THAT(error_of(in_folder("a.vdb"))->what(), HasSubstr("something else"));
}

TEST_F(VdbVolume, SaysWhichGridsThereAre) {
  write_vdb(in_folder("a.vdb"), {example_volume()});
  try {
    read_vdb(in_folder("a.vdb"), "smoke");
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("expected a grid smoke, got density"));
  }
}

// Fails if a file that ends early is taken for a whole one, crashes the reader or makes it allocate without
// end.
TEST_F(VdbVolume, RefusesTruncatedFiles) {
  write_vdb(in_folder("whole.vdb"), {example_volume()});
  const std::string whole = bytes_of(in_folder("whole.vdb"));
  for (std::size_t size = 0; size < whole.size(); size += size < 100 ? 3 : 211) {
    write_bytes(in_folder("cut.vdb"), whole.substr(0, size));
    EXPECT_TRUE(error_of(in_folder("cut.vdb"))) << "cut at " << size << " of " << whole.size();
  }
}

// Bits of a header are turned over: an error or a volume, and no crash.
TEST_F(VdbVolume, SurvivesDamage) {
  write_vdb(in_folder("whole.vdb"), {example_volume()});
  const std::string whole = bytes_of(in_folder("whole.vdb"));
  std::mt19937 random(9);
  int refused = 0;
  constexpr int files = 100;
  for (int i = 0; i < files; ++i) {
    std::string damaged = whole;
    const std::size_t place = random() % (i % 2 == 0 ? 1500 : whole.size());
    damaged[place] = static_cast<char>(damaged[place] ^ (1 << random() % 8));
    write_bytes(in_folder("damaged.vdb"), damaged);
    if (error_of(in_folder("damaged.vdb"))) ++refused;
  }
  RecordProperty("refused", refused);
  EXPECT_GT(refused, files / 10);
}

// A list of two thousand million grids whose first ends where it begins. Fails if it is read for hours.
TEST_F(VdbVolume, RefusesListsThatGoBack) {
  write_vdb(in_folder("whole.vdb"), {example_volume()});
  std::string bytes = bytes_of(in_folder("whole.vdb"));
  // count, name, type and parent, the last three with their lengths before them, and the offsets of the
  // grid, its blocks and its end.
  const std::string name("density"), type("Tree_float_5_4_3");
  const std::size_t type_at = bytes.find(type);
  ASSERT_NE(type_at, std::string::npos);
  const std::size_t descriptor_at = type_at - 8 - name.size(), end_at = type_at + type.size() + 4 + 16;
  ASSERT_EQ(bytes.substr(descriptor_at + 4, name.size()), name);
  const std::int32_t most = std::numeric_limits<std::int32_t>::max();
  std::memcpy(bytes.data() + descriptor_at - 4, &most, sizeof most);
  const auto back = static_cast<std::int64_t>(descriptor_at);
  std::memcpy(bytes.data() + end_at, &back, sizeof back);
  write_bytes(in_folder("loop.vdb"), bytes);
  ASSERT_TRUE(error_of(in_folder("loop.vdb")));
  EXPECT_THAT(error_of(in_folder("loop.vdb"))->what(), HasSubstr("an end after its start"));
}

// Lengths of names and metadata of 4 GB in a file of 30 kB. Fails if OpenVDB sees them: it allocates so much.
TEST_F(VdbVolume, AllocatesNoMoreThanTheFileHas) {
  write_vdb(in_folder("whole.vdb"), {example_volume()});
  const std::string whole = bytes_of(in_folder("whole.vdb"));
  constexpr std::uint32_t huge = 0xffff'fff0;
  const std::string length_of_name("\7\0\0\0density", 11), type("Tree_float_5_4_3"),
      map("UniformScaleTranslateMap");
  for (std::size_t at : {whole.find(length_of_name), whole.find(type) - 4, whole.find(type) + type.size(),
                         whole.find("class") - 4, whole.find("class") + 5, whole.find("fog volume") - 4,
                         whole.find(map) - 4}) {
    ASSERT_LT(at, whole.size());
    std::string bytes = whole;
    std::memcpy(bytes.data() + at, &huge, sizeof huge);
    write_bytes(in_folder("huge.vdb"), bytes);
    const std::optional<Error> error = error_of(in_folder("huge.vdb"));
    ASSERT_TRUE(error) << at;
    EXPECT_THAT(error->what(), HasSubstr("4294967280 bytes where")) << at;
  }
}

// Fails if cells that are too small to have an inverse end the reading by an error of OpenVDB, which also
// ends the process where it is thrown.
TEST_F(VdbVolume, RefusesCellsWithoutAnInverse) {
  write_vdb(in_folder("a.vdb"), {example_volume()});
  std::string bytes = bytes_of(in_folder("a.vdb"));
  const std::string map("UniformScaleTranslateMap");
  const std::size_t scale = bytes.find(map) + map.size() + 3 * sizeof(double);  // behind the translation
  ASSERT_LT(scale, bytes.size());
  const std::array<double, 3> tiny{1e-120, 1e-120, 1e-110};
  std::memcpy(bytes.data() + scale, tiny.data(), sizeof tiny);
  write_bytes(in_folder("tiny.vdb"), bytes);
  const std::optional<Error> error = error_of(in_folder("tiny.vdb"));
  ASSERT_TRUE(error);
  EXPECT_THAT(error->what(), HasSubstr("cubes along the axes"));
}

// Fails if a byte that is neither 0 nor 1 becomes a bool of OpenVDB, which is undefined: a tile of the root
// that is active by 124.
TEST_F(VdbVolume, RefusesTruthValuesBeyondOne) {
  const std::filesystem::path file = in_folder("cloud.vdb");
  write_vdb(file, {example_volume()});
  std::string bytes = bytes_of(file);
  // The root: one buffer, background 0, no tiles, some children, the origin of the first.
  const std::string root{"\1\0\0\0\0\0\0\0\0\0\0\0", 12};
  std::size_t at = bytes.find(root);
  const auto word = [&](std::size_t place) {
    std::int32_t value = 0;
    std::memcpy(&value, bytes.data() + place, sizeof value);
    return value;
  };
  while (at != std::string::npos &&
         !(word(at + 12) >= 1 && word(at + 12) <= 8 && word(at + 16) % 4096 == 0)) {
    at = bytes.find(root, at + 1);
  }
  ASSERT_NE(at, std::string::npos);
  bytes[at + 8] = 1;
  const std::string tile{"\0\x10\0\0\0\0\0\0\0\0\0\0\0\0\0\x3f\x7c", 17};  // at 4096, 0.5, active by 124
  bytes.insert(at + 16, tile);
  write_bytes(file, bytes);
  const std::optional<Error> error = error_of(file);
  ASSERT_TRUE(error);
  EXPECT_THAT(error->what(), HasSubstr("a truth value of 124"));
}

// 16 bricks in a box of 24. Fails if a small file can take more memory than the limits say.
TEST_F(VdbVolume, RefusesLargeVolumes) {
  write_vdb(in_folder("a.vdb"), {example_volume()});
  EXPECT_NO_THROW(read_vdb(in_folder("a.vdb"), "density", {.bricks = 16, .places = 24}));
  for (const VdbLimits& limits : {VdbLimits{.bricks = 15}, VdbLimits{.places = 23}})
    EXPECT_THROW(read_vdb(in_folder("a.vdb"), "density", limits), Error);
}

class CompressedVdb : public VdbVolume {
 protected:
  /// The example as an independent program writes it: OpenVDB's own. False where it is missing.
  bool make(const char* name, const std::string& options) {
    if (std::system("command -v vdb_tool >/dev/null 2>&1") != 0) return false;
    write_vdb(in_folder("plain.vdb"), {example_volume()});
    const std::string command =
        fmt::format("vdb_tool -quiet -read '{}' -write {} '{}' >'{}' 2>&1", in_folder("plain.vdb").string(),
                    options, in_folder(name).string(), in_folder("out.txt").string());
    EXPECT_EQ(std::system(command.c_str()), 0) << command << bytes_of(in_folder("out.txt"));
    return true;
  }
};

// Fails if the check of lengths takes what compression writes for damage.
TEST_F(CompressedVdb, GivesTheSameVolume) {
  for (const char* options : {"codec=none", "codec=blosc", "codec=active", "codec=blosc bits=16"}) {
    SCOPED_TRACE(options);
    if (!make("packed.vdb", options)) GTEST_SKIP() << "no vdb_tool (libopenvdb-tools)";
    EXPECT_LE(difference(example_volume(), read_vdb(in_folder("packed.vdb")).volume), std::ldexp(1.0, -10));
  }
}

// A block that is not packed and says that it is larger than its values. OpenVDB 10 writes it past the end of
// their buffer. Fails if OpenVDB sees it.
TEST_F(CompressedVdb, RefusesBlocksOfAnotherSize) {
  if (!make("packed.vdb", "codec=blosc")) GTEST_SKIP() << "no vdb_tool (libopenvdb-tools)";
  const std::string whole = bytes_of(in_folder("packed.vdb"));
  // Blosc's version 2 and its format 1, where what comes before says how long the block is, as does its
  // header.
  std::size_t at = 0;
  std::int64_t length = 0;
  for (std::uint32_t packed = 1; length != packed;) {
    at = whole.find(std::string("\2\1", 2), at + 1);
    ASSERT_LT(at, whole.size() - 16);
    std::memcpy(&length, whole.data() + at - sizeof length, sizeof length);
    std::memcpy(&packed, whole.data() + at + 12, sizeof packed);
  }
  for (const std::int64_t size : {std::int64_t{-4000}, std::int64_t{1} << 40, std::int64_t{3}}) {
    std::string bytes = whole;
    std::memcpy(bytes.data() + at - 8, &size, sizeof size);
    write_bytes(in_folder("larger.vdb"), bytes);
    const std::optional<Error> error = error_of(in_folder("larger.vdb"));
    ASSERT_TRUE(error) << size;
    EXPECT_THAT(error->what(), HasSubstr("a block of")) << size;
  }
}

// An independent program reads the file: OpenVDB's own. It counts active cells and tells where they are.
TEST_F(VdbVolume, VdbPrintReadsIt) {
  if (std::system("command -v vdb_print >/dev/null 2>&1") != 0)
    GTEST_SKIP() << "no vdb_print (libopenvdb-tools)";
  const CloudVolume volume = example_volume();
  write_vdb(in_folder("a.vdb"), {volume});
  std::size_t active = 0;
  for (const float value : volume.density) active += value > 0.0f ? 1 : 0;
  const std::string out = in_folder("out.txt").string();
  const std::string command = fmt::format("vdb_print -l '{}' > '{}' 2>&1", in_folder("a.vdb").string(), out);
  ASSERT_EQ(std::system(command.c_str()), 0) << bytes_of(out);
  std::string text = bytes_of(out);
  std::erase(text, ',');  // of thousands
  EXPECT_THAT(text, HasSubstr("density"));
  EXPECT_THAT(text, HasSubstr("float"));
  EXPECT_THAT(text, HasSubstr(fmt::format("Number of active voxels:       {}", active)));
  EXPECT_THAT(text, HasSubstr("12.5"));
}

}  // namespace
}  // namespace offing

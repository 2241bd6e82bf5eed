// Rays over tiles that are loaded as rays ask for them, against rays over the whole map.
#include "host/terrain/cast/fine_cast.h"

#include <atomic>
#include <set>
#include <vector>

#include <gtest/gtest.h>

#include "host/terrain/field/height_field.h"
#include "host/terrain/tiles/tiled_field.h"
#include "tests/ocl/expect_error.h"
#include "tests/terrain/example_tiles.h"
#include "tests/terrain/ray_comparison.h"

namespace offing {
namespace {

using terrain::EarthCurve;
using terrain::Ray;
using terrain::TiledField;

constexpr std::size_t mebibyte = 1 << 20;

/// 64 tiles of level 0, for which the smallest cache of 36 slots is too small.
test::ExampleTiles wide_tiles() {
  return test::ExampleTiles(
      test::valleys({.columns = 2049, .rows = 2049, .spacing_x_m = 10.0, .spacing_z_m = 12.5}));
}

class FineCastTest : public ::testing::Test {
 protected:
  terrain::TileReader counting_reader() {
    return [this](const TileKey& key) {
      ++reads_;
      return example_.reader()(key);
    };
  }
  ocl::Device device_ = ocl::Device::open();
  test::ExampleTiles example_ = wide_tiles();
  std::atomic<int> reads_ = 0;
};

// Fails if an answer is one of coarse ground, or if a tile goes that a ray still needs: every robust ray must
// have the hit of the reference to 1e-3 cells, as those of a HeightField (ray_comparison.h), though the cache
// holds half of the tiles that they cross.
TEST_F(FineCastTest, AnswersAreTheMaps) {
  TiledField field(device_, example_.tiled_map(), counting_reader(), 36 * mebibyte);
  field.look(Camera{});
  ASSERT_LT(field.statistics().slots, 45u);
  const std::vector<Ray> rays = test::example_rays(example_.map(), 4000, 5);
  const test::RayComparison found = test::compare(example_.map(), rays, field.cast_fully(rays));
  EXPECT_EQ(found.wrong, 0u);
  EXPECT_GT(found.hits, 1000u);
  EXPECT_LE(found.touching, 4u);
  EXPECT_LT(found.worst_cells, 1e-3);
  EXPECT_GT(reads_.load(), 64) << "all tiles found room at once: the test is of no use";
}

// Fails if the ground of tiles falls away otherwise than that of the map. Rays that touch a ridge to rounding
// may differ: 1 in 1000 at most, as in height_field_test.
TEST_F(FineCastTest, AnswersOverCurvedGroundAreTheMaps) {
  TiledField field(device_, example_.tiled_map(), counting_reader(), 36 * mebibyte);
  terrain::HeightField whole(device_, example_.map().grid, example_.map().heights_m);
  // So small an Earth that the far side of the map lies 200 m lower.
  const EarthCurve curve{.radius_m = 1e6, .refraction = 0.13};
  const std::vector<Ray> rays = test::example_rays(example_.map(), 4000, 6);
  const std::vector<terrain::RayHit> expected = whole.cast(rays, curve),
                                     found = field.cast_fully(rays, curve), flat = whole.cast(rays);
  std::size_t hits = 0, differ = 0, curved = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    hits += expected[i].kind == TERRAIN_MISS ? 0 : 1;
    curved += expected[i].distance_m == flat[i].distance_m ? 0 : 1;
    const bool is_same =
        expected[i].kind == found[i].kind &&
        (expected[i].kind == TERRAIN_MISS || std::abs(expected[i].distance_m - found[i].distance_m) <= 0.01);
    differ += is_same ? 0 : 1;
  }
  EXPECT_GT(hits, 1000u);
  EXPECT_GT(curved, 500u);
  EXPECT_LE(differ, 4u);
}

// Fails if rays that pass above coarse ground load fine tiles all the same.
TEST_F(FineCastTest, LoadsNothingForRaysThatPassAbove) {
  TiledField field(device_, example_.tiled_map(), counting_reader(), 64 * mebibyte);
  reads_ = 0;
  const double highest_m = field.map().highest_m;
  const Ray above{.origin_m = {10.0, highest_m + 1.0, 10.0}, .direction = {0.6, 0.0, 0.8}};
  EXPECT_EQ(field.cast_fully(std::vector{above}).front().kind, TERRAIN_MISS);
  EXPECT_EQ(reads_.load(), 0);
  // One that hits needs a tile of level 0, or two where it comes down at their border.
  const Ray down{.origin_m = {6000.0, highest_m + 1.0, 6000.0}};
  EXPECT_EQ(field.cast_fully(std::vector{down}).front().kind, TERRAIN_SURFACE);
  EXPECT_EQ(reads_.load(), 1);
}

// Fails if an answer is given of coarse ground where the fine cannot be read, or the error does not name it.
TEST_F(FineCastTest, TellsWhichTileCannotBeRead) {
  const terrain::TileReader broken = [this](const TileKey& key) {
    if (key == TileKey{0, 2, 1})
      throw Error(ErrorKind::bad_input, "0/0001/0002.tile: damaged", "make it again");
    return example_.reader()(key);
  };
  TiledField field(device_, example_.tiled_map(), broken, 64 * mebibyte);
  const auto down_at = [](double x_m, double z_m) {
    return std::vector{Ray{.origin_m = {x_m, 5000.0, z_m}}};
  };
  test::expect_error(ErrorKind::bad_input, "0/0001/0002.tile",
                     [&] { field.cast_fully(down_at(2.5 * 2560.0, 1.5 * 3200.0)); });
  EXPECT_EQ(field.cast_fully(down_at(3.5 * 2560.0, 1.5 * 3200.0)).front().kind, TERRAIN_SURFACE);
}

TEST_F(FineCastTest, RefusesMapsWithoutEnd) {
  TiledField field(device_, example_.tiled_map(terrain::MapEdge::mirrors), example_.reader(), 64 * mebibyte);
  test::expect_error(ErrorKind::bad_usage, "a map that ends", [&] { field.cast_fully(std::vector<Ray>(1)); });
}

/// Ground of which ray number i wants tiles 0 ... i one by one.
class Staircase {
 public:
  explicit Staircase(std::size_t most_tiles) : most_tiles_(most_tiles) {}
  terrain::CoarseTerrain terrain() {
    return {.most_tiles = most_tiles_,
            .lay =
                [this](const std::vector<TileKey>& keys) {
                  EXPECT_LE(keys.size(), most_tiles_);
                  laid_ = {keys.begin(), keys.end()};
                },
            .finer_tile = [](const terrain::RayHit& hit) -> std::optional<TileKey> {
              if (hit.kind == TERRAIN_SURFACE) return std::nullopt;
              return TileKey{0, hit.cell_x, 0};
            },
            .cast = [this](std::span<const Ray> rays) { return cast(rays); }};
  }

 private:
  std::vector<terrain::RayHit> cast(std::span<const Ray> rays) const {
    std::vector<terrain::RayHit> hits;
    for (const Ray& ray : rays) {
      const int last = static_cast<int>(ray.origin_m.x);
      int next = 0;
      while (next <= last && laid_.contains({0, next, 0})) ++next;
      terrain::RayHit hit;
      hit.kind = next > last ? TERRAIN_SURFACE : TERRAIN_INSIDE;
      hit.cell_x = next;
      hits.push_back(hit);
    }
    return hits;
  }
  std::size_t most_tiles_;
  std::set<TileKey> laid_;
};

// Fails if rays get another one's hit, if too much is laid at once, or if a ray for which there is no room is
// not refused.
TEST(FineGroupsTest, TakeRaysInGroupsForWhichThereIsRoom) {
  std::vector<Ray> rays;
  for (const double last : {3.0, 0.0, 7.0, 5.0, 7.0, 2.0}) rays.push_back({.origin_m = {last, 0.0, 0.0}});
  const std::vector<terrain::RayHit> hits = cast_until_fine(rays, Staircase(8).terrain());
  ASSERT_EQ(hits.size(), rays.size());
  for (std::size_t i = 0; i < rays.size(); ++i) EXPECT_EQ(hits[i].cell_x, rays[i].origin_m.x + 1.0) << i;
  test::expect_error(ErrorKind::bad_input, "at most 7 tiles",
                     [&] { cast_until_fine(rays, Staircase(7).terrain()); });
  EXPECT_TRUE(cast_until_fine({}, Staircase(8).terrain()).empty());
}

}  // namespace
}  // namespace offing

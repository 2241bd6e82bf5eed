#include "host/terrain/analysis/viewshed.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "host/terrain/analysis/many_viewsheds.h"
#include "tests/ocl/expect_error.h"
#include "tests/ocl/scoped_environment.h"
#include "tests/terrain/analysis/sight_reference.h"

namespace offing {
namespace {

using terrain::Viewshed;
using terrain::ViewshedParameters;

constexpr std::uint8_t visible = 255, hidden = 0;

std::vector<std::uint8_t> seen_from(const test::HeightMap& map, const ViewshedParameters& parameters) {
  const ocl::Device device = ocl::Device::open();
  const terrain::HeightField field(device, map.grid, map.heights_m);
  ocl::Buffer<std::uint8_t> seen(device, map.heights_m.size(), "seen");
  Viewshed(device).at(field, parameters, seen);
  return seen.read();
}

/// Observers all over a map, on posts, borders and between them, with and without heights and curvature.
std::vector<ViewshedParameters> example_observers(const terrain::PostGrid& grid) {
  std::vector<ViewshedParameters> observers;
  for (int i = 0; i < 12; ++i) {
    const double x = std::fmod(0.137 * i, 1.0) * (grid.columns - 1),
                 z = std::fmod(0.71 * i, 1.0) * (grid.rows - 1);
    ViewshedParameters parameters{
        .observer_x_m = grid.origin_x_m + grid.spacing_x_m * (i % 4 == 2 ? std::round(x) : x),
        .observer_z_m = grid.origin_z_m + grid.spacing_z_m * (i % 5 == 3 ? std::round(z) : z),
        .observer_height_m = i % 3 == 0 ? 0.0 : 1.7 * i,
        .target_height_m = i % 2 == 0 ? 0.0 : 2.5};
    // A small planet, so that its curve tells on a small map.
    if (i % 4 == 1) parameters.curve = {.radius_m = 20'000.0, .refraction = 0.13};
    observers.push_back(parameters);
  }
  return observers;
}

// Fails if a post is seen that is hidden or hidden that is seen, unless its line touches the surface to less
// than 1e-4 m: rounding to floats of heights within 160 m of the eye, 2^-24 * 160 m, ten times over. Such are
// 1e-5 of all at most on ground that is not a plane; on planes lines between points of the ground lie in it.
// Measured: none.
TEST(ViewshedTest, AgreesWithDoublePrecision) {
  for (const test::HeightMap& map : test::example_maps()) {
    int wrong = 0, touching = 0, posts = 0;
    for (const ViewshedParameters& parameters : example_observers(map.grid)) {
      const std::vector<std::uint8_t> seen = seen_from(map, parameters);
      for (int row = 0; row < map.grid.rows; ++row) {
        for (int column = row % 3; column < map.grid.columns; column += 3, ++posts) {
          const double clearance_m = test::reference_clearance_m(map, parameters, column, row);
          const auto found = seen[static_cast<std::size_t>(row * map.grid.columns + column)];
          ASSERT_TRUE(found == visible || found == hidden);
          if ((found == visible) == (clearance_m >= -1e-6)) continue;
          ++(std::abs(clearance_m) <= 1e-4 ? touching : wrong);
        }
      }
    }
    std::printf("%s: %d posts, %d wrong, %d decided by rounding\n", map.name.c_str(), posts, wrong, touching);
    EXPECT_EQ(wrong, 0) << map.name;
    if (map.name != "flat" && map.name != "ramp") {
      EXPECT_LE(touching, posts / 100'000) << map.name;
    }
  }
}

// Most posts are decided by bounds of the horizon, and only the others by walks along their lines. Without
// bounds, as devices of narrow lanes go, each walks: fails if that gives another answer for any post.
TEST(ViewshedTest, BoundsDecideAsWalksDo) {
  for (const test::HeightMap& map : test::example_maps()) {
    for (const ViewshedParameters& parameters : example_observers(map.grid)) {
      // On a plane, eyes and targets on it: rounding decides.
      if (map.name == "ramp" && parameters.observer_height_m == 0.0) continue;
      const std::vector<std::uint8_t> by_bounds = seen_from(map, parameters);
      const test::ScopedEnvironment shape("OFFING_SHAPE", "workgroup");
      EXPECT_EQ(by_bounds, seen_from(map, parameters)) << map.name << ' ' << parameters.observer_x_m;
    }
  }
}

/// Level ground with a wall along column 40, 10 m high, and posts 10 m apart.
test::HeightMap wall() {
  test::HeightMap map{"wall", {.columns = 101, .rows = 81, .spacing_x_m = 10.0, .spacing_z_m = 10.0}, {}};
  for (int i = 0; i < 101 * 81; ++i) map.heights_m.push_back(i % 101 == 40 ? 10.0f : 0.0f);
  return map;
}

// An eye 2 m up at column 30 looks over the wall, 8 m above and 100 m away, to what is 2 + 0.08 d high at a
// distance d: targets of 20 m within 225 m beyond the wall's shadow of 300 m... that is up to column 52.
TEST(ViewshedTest, WallsCastShadows) {
  ViewshedParameters parameters{
      .observer_x_m = 300.0, .observer_z_m = 400.0, .observer_height_m = 2.0, .target_height_m = 20.0};
  const std::vector<std::uint8_t> seen = seen_from(wall(), parameters);
  const auto at = [&](int column) { return seen[static_cast<std::size_t>(40 * 101 + column)]; };
  EXPECT_EQ(at(0), visible);
  EXPECT_EQ(at(40), visible);
  EXPECT_EQ(at(52), visible);  // 2 + 0.08 * 220 = 19.6 m
  EXPECT_EQ(at(53), hidden);   // 20.4 m
  parameters.target_height_m = 0.0;
  const std::vector<std::uint8_t> terrain = seen_from(wall(), parameters);
  EXPECT_EQ(terrain[40 * 101 + 40], visible);
  EXPECT_EQ(terrain[40 * 101 + 41], hidden);
}

/// 301 x 301 posts of low hills, with walls of 50 m around the middle at a distance in posts, or none for 0.
test::HeightMap walled(int distance) {
  test::HeightMap map{"walled", {.columns = 301, .rows = 301, .spacing_x_m = 2.0, .spacing_z_m = 2.0}, {}};
  for (int row = 0; row < 301; ++row) {
    for (int column = 0; column < 301; ++column) {
      const int from_middle = std::max(std::abs(column - 150), std::abs(row - 150));
      map.heights_m.push_back(static_cast<float>(
          distance > 0 && from_middle == distance ? 50.0 : std::sin(0.3 * column) + std::cos(0.2 * row)));
    }
  }
  return map;
}

/// A pit of 40 m around the middle of low hills.
test::HeightMap pit() {
  test::HeightMap map = walled(0);
  for (int row = 145; row <= 155; ++row) {
    for (int column = 145; column <= 155; ++column)
      map.heights_m[static_cast<std::size_t>(row * 301 + column)] -= 40.0f;
  }
  return map;
}

// Sweeps stop where the horizon is above all targets: in all octants in a pit and 2 m from a wall, for an eye
// above the ground where nothing hides it never. Fails if a post is not as a walk in double precision has it.
TEST(ViewshedTest, StopsOnlyWhereAllIsHidden) {
  struct Case {
    test::HeightMap map;
    double eye_m, target_m, radius_m;
    bool is_closed;  // almost all is hidden
  };
  constexpr double no_radius = std::numeric_limits<double>::infinity();
  for (const Case& at :
       {Case{pit(), 1.7, 0.0, no_radius, true}, Case{pit(), 1.7, 5.0, 250.0, true},
        Case{walled(1), 1.7, 0.0, no_radius, true}, Case{walled(1), 1.7, 0.0, 150.0, true},
        Case{walled(1), 60.0, 0.0, no_radius, false}, Case{walled(12), 30.0, 3.0, no_radius, true},
        Case{walled(0), 100.0, 0.0, no_radius, false}, Case{walled(0), 100.0, 0.0, 200.0, false}}) {
    for (const double off : {0.0, 0.37}) {
      const ViewshedParameters parameters{.observer_x_m = 300.0 + off,
                                          .observer_z_m = 300.0 - off,
                                          .observer_height_m = at.eye_m,
                                          .target_height_m = at.target_m,
                                          .radius_m = at.radius_m};
      const std::vector<std::uint8_t> seen = seen_from(at.map, parameters);
      int wrong = 0, open = 0;
      for (int row = 0; row < 301; ++row) {
        for (int column = row % 3; column < 301; column += 3) {
          const bool is_seen = seen[static_cast<std::size_t>(row * 301 + column)] == visible;
          open += is_seen ? 1 : 0;
          const double plan_m =
              std::hypot(2.0 * column - parameters.observer_x_m, 2.0 * row - parameters.observer_z_m);
          const double clearance_m = test::reference_clearance_m(at.map, parameters, column, row);
          const bool expected = plan_m <= at.radius_m && clearance_m >= -1e-6;
          if (is_seen != expected && std::abs(clearance_m) > 1e-4) ++wrong;
        }
      }
      EXPECT_EQ(wrong, 0) << at.eye_m << ' ' << at.radius_m << ' ' << off;
      EXPECT_EQ(open < 700, at.is_closed) << open << " at " << at.eye_m << ' ' << at.radius_m;
    }
  }
}

/// Seas and lakes with islands, terraces and a plateau, all level, among hills: 301 x 257 posts.
test::HeightMap waters() {
  test::HeightMap map{"waters", {.columns = 301, .rows = 257, .spacing_x_m = 10.0, .spacing_z_m = 13.0}, {}};
  for (int row = 0; row < 257; ++row) {
    for (int column = 0; column < 301; ++column) {
      double height_m = 0.0;
      if (column > 180) height_m = 20.0 + 15.0 * std::sin(0.11 * column) * std::cos(0.07 * row);
      if (std::hypot(column - 240, row - 90) < 28.0) height_m = 17.0;
      if (std::hypot(column - 60, row - 200) < 5.0) height_m = 9.0;
      if (column < 30 && row < 60) height_m = 25.0;
      if (row > 240) height_m = 3.0 * (column / 25);
      map.heights_m.push_back(static_cast<float>(height_m));
    }
  }
  return map;
}

// Level ground below the eye, and nodes below the horizon, are passed over many lines at a time. Fails if a
// post is not as a walk in double precision has it, or not as walks alone have it: from corners, edges, posts
// and between them, with the Earth's curve on and off, with targets and radii.
TEST(ViewshedTest, PassesOverLevelAndHiddenGround) {
  const test::HeightMap map = waters();
  constexpr double no_radius = std::numeric_limits<double>::infinity();
  struct Eye {
    double x, z, height_m, target_m, radius_m, planet_m;
  };
  for (const Eye& eye :
       {Eye{0, 0, 1.7, 0, no_radius, no_radius}, Eye{300, 256, 30, 0, no_radius, no_radius},
        Eye{300, 0, 1.7, 2, no_radius, 20'000}, Eye{0, 256, 60, 0, no_radius, 200'000},
        Eye{100, 100, 1.7, 0, no_radius, no_radius}, Eye{100.3, 100.8, 1.7, 0, no_radius, 20'000},
        Eye{240, 90, 5, 0, no_radius, no_radius}, Eye{150.5, 80.5, 100, 4, 900, no_radius},
        Eye{29, 59, 1.7, 0, 1500, 200'000}, Eye{60, 256, 10, 0, no_radius, no_radius},
        Eye{60, 200, 1e-3, 0, no_radius, no_radius}, Eye{0, 120.25, 1000, 0, no_radius, 20'000}}) {
    const ViewshedParameters parameters{.observer_x_m = 10.0 * eye.x,
                                        .observer_z_m = 13.0 * eye.z,
                                        .observer_height_m = eye.height_m,
                                        .target_height_m = eye.target_m,
                                        .radius_m = eye.radius_m,
                                        .curve = {.radius_m = eye.planet_m, .refraction = 0.13}};
    const std::vector<std::uint8_t> seen = seen_from(map, parameters);
    int wrong = 0;
    for (int row = 0; row < map.grid.rows; ++row) {
      for (int column = row % 5; column < map.grid.columns; column += 5) {
        const double plan_m =
            std::hypot(10.0 * column - parameters.observer_x_m, 13.0 * row - parameters.observer_z_m);
        const double clearance_m = test::reference_clearance_m(map, parameters, column, row);
        const bool expected = plan_m <= eye.radius_m && clearance_m >= -1e-6;
        const bool is_seen = seen[static_cast<std::size_t>(row * map.grid.columns + column)] == visible;
        if (is_seen != expected && std::abs(clearance_m) > 1e-4) ++wrong;
      }
    }
    EXPECT_EQ(wrong, 0) << eye.x << ' ' << eye.z;
    const test::ScopedEnvironment shape("OFFING_SHAPE", "workgroup");
    EXPECT_EQ(seen, seen_from(map, parameters)) << eye.x << ' ' << eye.z;
  }
}

// While the host takes what one observer sees, the device looks from the next: fails if any of many differs
// from a run of its own, if their order does, or if stopping half way ends in anything but the error.
TEST(ViewshedTest, OfManyAreThoseOfEachAlone) {
  const test::HeightMap map = waters();
  const ocl::Device device = ocl::Device::open();
  const terrain::HeightField field(device, map.grid, map.heights_m);
  std::vector<terrain::Observer> observers;
  for (const ViewshedParameters& parameters : example_observers(map.grid))
    observers.push_back({parameters, {}});
  observers[3].parameters.radius_m = 700.0;
  observers[4].limits.azimuth_to_rad = 1.0;
  std::size_t next = 0;
  terrain::look_from_each(device, field, map.heights_m, observers, terrain::sight_outside,
                          [&](std::size_t index, std::span<const std::uint8_t> seen) {
                            ASSERT_EQ(index, next++);
                            std::vector<std::uint8_t> alone = seen_from(map, observers[index].parameters);
                            terrain::mark_outside(map.grid, map.heights_m, observers[index].parameters,
                                                  observers[index].limits, terrain::sight_outside, alone);
                            EXPECT_TRUE(std::ranges::equal(seen, alone)) << index;
                          });
  EXPECT_EQ(next, observers.size());
  EXPECT_THROW(terrain::look_from_each(device, field, map.heights_m, observers, 0,
                                       [](std::size_t index, std::span<const std::uint8_t>) {
                                         if (index == 2) throw Error(ErrorKind::cancelled, "stopped", "");
                                       }),
               Error);
  observers.back().parameters.observer_x_m = -1.0;
  test::expect_error(ErrorKind::bad_input, "observer_x_m", [&] {
    terrain::look_from_each(device, field, map.heights_m, observers, 0,
                            [](std::size_t, std::span<const std::uint8_t>) { FAIL() << "looked"; });
  });
}

// Beyond the wall only what is within the radius counts: a post at exactly that distance does.
TEST(ViewshedTest, EndsAtTheRadius) {
  const std::vector<std::uint8_t> seen = seen_from(wall(), {.observer_x_m = 300.0,
                                                            .observer_z_m = 400.0,
                                                            .observer_height_m = 50.0,
                                                            .target_height_m = 0.0,
                                                            .radius_m = 50.0});
  for (int row = 0; row < 81; ++row) {
    for (int column = 0; column < 101; ++column) {
      const bool is_near = std::hypot(column - 30, row - 40) <= 5.0;
      EXPECT_EQ(seen[static_cast<std::size_t>(row * 101 + column)], is_near ? visible : hidden)
          << column << ' ' << row;
    }
  }
}

// On a level sea of radius R an eye of height h sees the water up to sqrt(2 R h): 10 km of R and 2 m are 200
// m, 20 posts. Refraction of 0.19 makes it 1 / 0.9 times that: 222 m.
TEST(ViewshedTest, TheSeaHasAHorizon) {
  test::HeightMap sea{"sea", {.columns = 101, .rows = 11, .spacing_x_m = 10.0, .spacing_z_m = 10.0}, {}};
  sea.heights_m.assign(101 * 11, 0.0f);
  for (const auto& [refraction, last] : {std::pair{0.0, 19}, std::pair{0.19, 22}}) {
    const std::vector<std::uint8_t> seen =
        seen_from(sea, {.observer_x_m = 500.0,
                        .observer_z_m = 50.0,
                        .observer_height_m = 1.99,
                        .curve = {.radius_m = 10'000.0, .refraction = refraction}});
    EXPECT_EQ(seen[static_cast<std::size_t>(5 * 101 + 50 + last)], visible) << last;
    EXPECT_EQ(seen[static_cast<std::size_t>(5 * 101 + 50 - last)], visible) << last;
    EXPECT_EQ(seen[static_cast<std::size_t>(5 * 101 + 51 + last)], hidden) << last;
    EXPECT_EQ(seen[static_cast<std::size_t>(5 * 101 + 49 - last)], hidden) << last;
  }
}

TEST(ViewshedTest, RefusesWhatIsOutOfRange) {
  const auto refuses = [](const char* name, const ViewshedParameters& parameters) {
    test::expect_error(ErrorKind::bad_input, name, [&] { terrain::require_valid(parameters, wall().grid); });
  };
  refuses("observer_x_m", {.observer_x_m = -1.0});
  refuses("observer_z_m", {.observer_z_m = 801.0});
  refuses("observer_height_m", {.observer_height_m = -0.1});
  refuses("target_height_m", {.target_height_m = std::numeric_limits<double>::quiet_NaN()});
  refuses("radius_m: expected above 0", {.radius_m = 0.0});
  refuses("earth curve: radius_m", {.curve = {.radius_m = 0.0}});
  refuses("refraction", {.curve = {.radius_m = 1e6, .refraction = 1.5}});
}

}  // namespace
}  // namespace offing

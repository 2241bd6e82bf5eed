// Where water ends on a beach: how it thins out.
#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/present/passes/still_sea.h"

namespace offing::present {
namespace {

class ShoreTest : public test::StillSea {
 protected:
  /// A beach that rises by 1 : 10 toward the south; its waterline is at z = 0 where the sea is at `level_m`.
  static world::TerrainParameters beach(double level_m = 0.0) {
    return ground([&](double z_m) { return level_m + 0.1 * z_m; });
  }

  /// Ground of this height at each z.
  static world::TerrainParameters ground(const std::function<double(double z_m)>& height_m) {
    HeightMap map;
    map.columns = map.rows = 65;
    map.spacing_x_m = map.spacing_z_m = 5.0;
    for (int row = 0; row < map.rows; ++row)
      map.heights_m.insert(map.heights_m.end(), 65, static_cast<float>(height_m(5.0 * row - 160.0)));
    world::TerrainParameters terrain;
    terrain.map = std::make_shared<const HeightMap>(std::move(map));
    terrain.origin_x_m = terrain.origin_z_m = -160.0;
    terrain.lines.sea_level_m = -1e6;
    terrain.lines.beach_line_m = 1e6;
    return terrain;
  }

  /// Stands 9 m above the waterline, 1.7 m high, and looks at it.
  static Camera on_the_beach(double x_m = 0.0) {
    Camera camera = square_camera({x_m, 2.6, 9.0});
    camera.pitch_rad = -std::atan2(2.6, 9.0);
    camera.vertical_field_of_view_rad = 0.1;
    return camera;
  }
};

// From dry sand over wet sand and a film of water to water, over some 6 cm of height, rows of 0.3 cm differ
// by little, so that no line is seen: logarithms of blue light, of sand that is wet everywhere. Means over
// six places, as dents of dry sand are as wide as half a picture. Limit 0.2.
// Before, the first row of water differed by 0.39.
TEST_F(ShoreTest, WaterThinsOutWithoutAStair) {
  constexpr int places = 6;
  std::vector<double> change(side_px);  // of blue, over that of the sand, from the land on
  for (int place = 0; place < places; ++place) {
    const Camera camera = on_the_beach(7.0 * place);
    const std::vector<float> wet = light_on(beach(), still_sea, camera, side_px);
    const std::vector<float> dry = light_on(beach(), "[ocean]\nsize = 32\n", camera, side_px, Sea::none);
    for (int row = 0; row < side_px; ++row) {
      double sum = 0.0;
      for (int column = 0; column < side_px; ++column)
        sum += std::log(pixel(wet, column, row)[2] / pixel(dry, column, row)[2]);
      change[static_cast<std::size_t>(row)] += sum / (side_px * places);
    }
  }
  double largest = 0.0;
  for (std::size_t row = 1; row < change.size(); ++row)
    largest = std::max(largest, std::abs(change[row] - change[row - 1]));
  RecordProperty("largest_step", std::to_string(largest));
  EXPECT_NEAR(change[0], std::log(1.0 / 0.6), 0.05) << "no dry sand in sight";
  EXPECT_LT(change[side_px - 1], change[0] - 0.1) << "no water in sight";
  EXPECT_LT(largest, 0.25);
}

// Where the bed falls away more steeply than the eye looks, rays past the waterline miss it and meet the bed
// far out. Water of 0 to 1 m is clear all the same: pixels one above the other differ by less than 0.1, as
// logarithms of red light. Found 0.026; before, 0.39, in teeth as wide as pixels of what is beneath the
// water.
TEST_F(ShoreTest, WaterIsClearWhereTheBeachHidesItsBed) {
  const world::TerrainParameters steep =
      ground([](double z_m) { return z_m > 0.0 ? 0.05 * z_m : std::max(0.3 * z_m, -3.0); });
  Camera camera = square_camera({0.0, 2.15, 9.0});
  camera.pitch_rad = -std::atan2(2.15, 9.0) + 0.045;
  camera.vertical_field_of_view_rad = 0.1;
  constexpr int coarse_px = 12, sand_rows = 8;
  const std::vector<float> seen = light_on(steep, still_sea, camera, coarse_px);
  double largest = 0.0;
  for (int row = sand_rows + 1; row < side_px; ++row) {
    for (int column = 0; column < side_px; ++column)
      largest = std::max(largest, static_cast<double>(std::abs(std::log(pixel(seen, column, row)[0] /
                                                                        pixel(seen, column, row - 1)[0]))));
  }
  RecordProperty("largest_step", std::to_string(largest));
  EXPECT_LT(pixel(seen, 0, side_px - 1)[0], 0.9f * pixel(seen, 0, 0)[0]) << "no water in sight";
  EXPECT_LT(largest, 0.1);
}

// A fresh breeze onto the beach, 1.2 m high; its whitecaps are left out.
constexpr const char* breeze =
    "[wind]\nspeed_mps = 9\ndirection_deg = 90\n[ocean]\nsize = 64\nfetch_m = 50e3\n"
    "[ocean.foam]\nonset_jacobian = -10\n";

// Fails if waves that break on the beach have no foam, or those that do not have some: the coverage from
// above, over 0.3 to 1.3 m of water, where the largest waves could be 0.2 to 1 m high, at four moments; over
// 13 m, and on a sea without waves.
TEST_F(ShoreTest, WavesThatBreakHaveFoam) {
  shown_ = WaterShow::foam;
  const auto greatest_and_mean = [&](const std::string& sea, double z_m, double time_s) {
    Camera camera = square_camera({0.0, 30.0, z_m});
    camera.pitch_rad = -0.5 * std::numbers::pi;
    camera.vertical_field_of_view_rad = 2.0 * std::atan(5.0 / 30.0);
    const std::vector<float> seen = light_on(beach(), sea, camera, side_px, Sea::as_given, time_s);
    double greatest = 0.0, mean = 0.0;
    for (std::size_t i = 0; i < seen.size(); i += 4) {
      const double coverage = static_cast<double>(seen[i]) / 6.0;  // white is 10 kcd/m2, shown at 0.6 of it
      greatest = std::max(greatest, coverage);
      mean += 4.0 * coverage / static_cast<double>(seen.size());
    }
    return std::pair{greatest, mean};
  };
  double greatest = 0.0, mean = 0.0;
  for (const double time_s : {0.0, 1.3, 2.6, 3.9}) {
    const auto then = greatest_and_mean(breeze, -8.0, time_s);
    greatest = std::max(greatest, then.first);
    mean += 0.25 * then.second;
  }
  RecordProperty("greatest_and_mean", std::to_string(greatest) + " " + std::to_string(mean));
  EXPECT_GT(greatest, 0.5);
  EXPECT_GT(mean, 0.015);  // found 0.026
  EXPECT_LT(greatest_and_mean(breeze, -130.0, 0.0).first, 1e-3);
  EXPECT_LT(greatest_and_mean(still_sea, -8.0, 0.0).first, 1e-3);
}

// Fails if any pixel of a washed beach has no light or more than white foam in the sun. Before, foam of the
// swash grew without bound just above its edge: black pixels.
TEST_F(ShoreTest, LightOfTheSwashIsFinite) {
  // From the sea, where the water's grid is coarse.
  Camera camera = square_camera({0.0, 4.0, -150.0});
  camera.yaw_rad = std::numbers::pi;
  camera.pitch_rad = -4.0 / 150.0;
  camera.vertical_field_of_view_rad = 0.3;
  for (int moment = 0; moment < 12; ++moment) {
    const std::vector<float> seen = light_on(beach(), breeze, camera, side_px, Sea::as_given, 0.7 * moment);
    const auto is_wrong = [](float light) { return !(light > 0.0f && light < 100.0f); };
    EXPECT_EQ(std::ranges::count_if(seen, is_wrong), 0) << "at moment " << moment;
  }
}

// Against the same ground all wet, as it is without a swash: sand is as dark within the reach of the swash,
// and two and a half times the reach up, beyond the weed, it has its whole albedo, 1 / 0.6 times as much.
// Gates 10 %: a film mirrors some of the sky.
TEST_F(ShoreTest, SandIsWetAsFarAsTheSwashReaches) {
  const scene::Scene scene = scene::parse_scene("version = 1\n" + std::string(breeze), "a.toml", "");
  world::WorldParameters parameters = scene::prepare_world(scene, scene::Warnings::left_out);
  parameters.terrain = beach();
  const world::World world(ocl::Device::open(), parameters);
  ASSERT_TRUE(world.swash());
  const double reach_m = world.swash()->reach_m();
  constexpr double eye_m = 60.0, middle_m = 14.0;
  Camera camera = square_camera({0.0, eye_m, middle_m});
  camera.pitch_rad = -0.5 * std::numbers::pi;
  camera.vertical_field_of_view_rad = 2.0 * std::atan(14.0 / eye_m);
  const std::vector<float> washed = light_on(beach(), breeze, camera, side_px);
  std::string no_swash = breeze;
  no_swash.insert(no_swash.find("size"), "shoals = \"off\"\n");
  const std::vector<float> wet = light_on(beach(), no_swash, camera, side_px);
  const auto brighter = [&](double height_m) {
    // The beach rises toward the bottom of the picture, nearer to the eye.
    const double across = (10.0 * height_m - middle_m) / (eye_m - height_m) * eye_m / 14.0;
    const int row = static_cast<int>((1.0 - across) * side_px / 2);
    double sum = 0.0;
    for (int column = 0; column < side_px; ++column)
      sum += static_cast<double>(pixel(washed, column, row)[1] / pixel(wet, column, row)[1]) / side_px;
    return sum;
  };
  ASSERT_GT(reach_m, 0.5);
  ASSERT_LT(2.5 * reach_m, 2.6);
  EXPECT_NEAR(brighter(0.6 * reach_m), 1.0, 0.1);
  EXPECT_NEAR(brighter(2.5 * reach_m), 1.0 / 0.6, 0.1 / 0.6);
}

// Fails if sand is wetted about height 0 wherever the sea is. Rows of the beach at 0 m and 1500 m higher have
// the same mean light within 25 %: their patterns differ, found 11 % for the ground alone. Dry sand is 67 %
// brighter than wet sand.
TEST_F(ShoreTest, SandIsWetWhereverTheSeaIs) {
  constexpr double level_m = 1500.0;
  Camera camera = square_camera({0.0, 40.0, 9.0});
  camera.pitch_rad = -0.5 * std::numbers::pi;
  camera.vertical_field_of_view_rad = 0.4;
  const std::vector<float> low = light_on(beach(), breeze, camera, side_px);
  camera.eye_m.y += level_m;
  const std::string raised = "[world]\nsea_level_m = 1500\n" + std::string(breeze);
  const std::vector<float> high = light_on(beach(level_m), raised, camera, side_px);
  double largest = 0.0;
  for (int row = 0; row < side_px; ++row) {
    double of_low = 0.0, of_high = 0.0;
    for (int column = 0; column < side_px; ++column) {
      of_low += static_cast<double>(pixel(low, column, row)[1]);
      of_high += static_cast<double>(pixel(high, column, row)[1]);
    }
    largest = std::max(largest, std::abs(of_high / of_low - 1.0));
  }
  RecordProperty("largest_difference", std::to_string(largest));
  EXPECT_LT(largest, 0.25);
}

// Fails if land against a low sun is exposed for water that mirrors the sky there, which made it 2.2 stops
// too dark, or water for land; or if the exposure jumps where the camera leaves the coast: half a metre turns
// half a row of rays to the water.
TEST_F(ShoreTest, ExposesForWhatTheCameraSees) {
  const std::string low_sun =
      std::string("[sun]\nelevation_deg = 8\nazimuth_deg = 0\n") + still_sea;  // north: the camera's view
  const world::TerrainParameters plateau = ground([](double z_m) { return z_m > 0.0 ? 40.0 : -20.0; });
  const auto camera_at = [](double z_m) {
    Camera camera = square_camera({0.0, 50.0, z_m});
    camera.pitch_rad = -0.6;
    camera.vertical_field_of_view_rad = 0.6;
    return camera;
  };
  const Camera over_land = camera_at(80.0), over_sea = camera_at(-40.0);
  const double land = metered_stops(plateau, low_sun, over_land),
               water = metered_stops(plateau, low_sun, over_sea);
  RecordProperty("land_over_water_stops", std::to_string(land - water));
  EXPECT_NEAR(land, metered_stops(plateau, low_sun, over_land, Sea::none), 1e-6);
  EXPECT_NEAR(water, metered_stops({}, low_sun, over_sea), 1e-6);
  EXPECT_GT(land, water + 1.0);
  double before = metered_stops(plateau, low_sun, camera_at(30.5)), largest = 0.0;
  for (double z_m = 30.0; z_m > 4.0; z_m -= 0.5) {
    const double stops = metered_stops(plateau, low_sun, camera_at(z_m));
    largest = std::max(largest, std::abs(stops - before));
    before = stops;
  }
  RecordProperty("largest_step", std::to_string(largest));
  EXPECT_LT(largest, 0.2);
}

}  // namespace
}  // namespace offing::present

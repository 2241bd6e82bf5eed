// A ship under way on the sea of a buoy's spectrum, with its wake, and the water beside it: queried and
// drawn, over 1,000 frames.
#include <filesystem>
#include <memory>
#include <numbers>
#include <string>

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/world_scene.h"
#include "present/gl/transfer.h"
#include "present/passes/water/water_maps.h"
#include "present/passes/water/water_surface.h"
#include "tests/present/gl_test.h"
#include "tests/present/passes/drawn_water.h"

namespace offing::test {
namespace {

constexpr int frames = 1000;
constexpr double frame_s = 1.0 / 24.0;

class ShipOnDrawnWaterTest : public GlTest {
 protected:
  /// The shipped measured sea with a ship that follows its screw.
  static scene::Scene ship_at_sea() {
    const std::filesystem::path scenes(OFFING_SCENES);
    scene::Scene sea = scene::load_scene(scenes / "buoy.toml");
    const scene::Scene afloat = scene::load_scene(scenes / "afloat.toml");
    sea.ocean.wakes = afloat.ocean.wakes;
    sea.meshes = {afloat.meshes.front()};
    sea.meshes.front().highlights.clear();
    sea.bodies = {afloat.bodies.front()};
    return sea;
  }
};

// Fails if water is drawn elsewhere than queries say beside a ship on a sea of all bands: from 20 m above, a
// patch of 4 m at its side, cells of at most 5 cm. What is left is as in
// DrawnWaterTest.OfSmallCellsIsWhereQueriesSay and the wake's own maps, 0.75 m a cell, which both look up
// alike. Promised 1 cm.
TEST_F(ShipOnDrawnWaterTest, IsWhereQueriesSay) {
  const ocl::Device device = ocl::Device::open();
  const scene::Scene scene = ship_at_sea();
  world::World world(device, scene::prepare_world(scene, scene::Warnings::left_out));
  ASSERT_NE(world.bodies(), nullptr);
  ASSERT_NE(world.wakes(), nullptr);
  present::Transfer transfer(*context_, device, std::nullopt);
  present::WaterMaps maps;
  present::WaterSurface surface(context_->capabilities(), {.columns = 256, .rows = 512});
  DrawnWater drawn;
  double farthest_m = 0.0;
  for (int frame = 0; frame < frames; ++frame) {
    const double time_s = frame * frame_s;
    world.at(time_s, 20.0);
    const glm::dvec3 ship_m = world.bodies()->pose(0, time_s).mass_centre_m;
    // Beside it: its beam is 6 m.
    Camera camera{.eye_m = {ship_m.x, 20.0, ship_m.z + 6.0},
                  .pitch_rad = -0.5 * std::numbers::pi,
                  .vertical_field_of_view_rad = 0.2,
                  .width_px = 32,
                  .height_px = 32};
    world.set_eye({camera.eye_m.x, camera.eye_m.z});
    maps.prepare(world, transfer);
    ASSERT_TRUE(surface.draw(world, maps, camera, present::Fill::solid));
    const DrawnWater now = drawn_beside_queried(world, surface, camera);
    if (now.count > 0) farthest_m = std::max(farthest_m, now.off_m());
    drawn += now;
  }
  fmt::print("RMS of query and drawn {:.2f} mm over {} frames, worst frame {:.2f} mm; of heights {:.2f} m\n",
             1e3 * drawn.off_m(), frames, 1e3 * farthest_m, drawn.height_m());
  EXPECT_LT(drawn.off_m(), 0.01);
  EXPECT_GT(drawn.height_m(), 0.3) << "there is nothing to compare";
  EXPECT_GT(drawn.count, static_cast<std::size_t>(frames) * 512) << "the ship is in the way";
}

}  // namespace
}  // namespace offing::test

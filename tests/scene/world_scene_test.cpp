// A running world that follows an edited scene.
#include "host/scene/prepare/world_scene.h"

#include <string>
#include <tuple>
#include <utility>

#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/moving_view.h"

namespace offing::scene {
namespace {

Scene scene_of(const std::string& text) {
  return parse_scene("version = 1\n" + text, "a.toml", "");
}

// Everything that a picture is made from, at one time.
auto everything(world::World& world) {
  world.at(3.0, 10.0);
  std::vector<double> gerstner_waves;
  for (const ocean::GerstnerWave& wave : world.parameters().ocean.gerstner_waves.waves) {
    gerstner_waves.insert(gerstner_waves.end(), {wave.amplitude_m, wave.wavenumber_radpm, wave.phase_rad});
  }
  for (const ocean::Raindrop& drop : world.parameters().ocean.gerstner_waves.raindrops)
    gerstner_waves.push_back(drop.x_m);
  return std::tuple(world.ocean().displacement_map().read(), world.ocean().gradient_map().read(),
                    world.ocean().foam_map().read(), world.sky().view_table().read(),
                    world.illuminance().sky_klx, world.reach().vertical_m, world.hidden_slopes().ripples.xx,
                    gerstner_waves);
}

// Fails if a live edit differs from a fresh start with the edited scene, whichever value is edited and
// although the edits add up.
TEST(WorldScene, EditEqualsAFreshStart) {
  const std::string sea = "[ocean]\nsize = 32\ncascade_count = 1\n";
  const std::string rain = "[[ocean.raindrop]]\nx_m = 3\n", swell = "[[ocean.swell]]\nperiod_s = 9\n";
  const std::string gerstner = "[ocean.gerstner]\ncount = 3\n", seed = "[world]\nseed = 5\n";
  const std::string dusk = "[sun]\ntime_utc = 2024-03-20T17:50:00Z\n", haze = "[sky]\nozone_du = 500\n";
  const std::string texts[] = {
      sea,
      sea + swell + rain,
      sea + swell + swell + gerstner,
      sea + swell + gerstner + seed,
      sea + rain + gerstner + seed + dusk,
      sea + gerstner + seed + dusk + haze,
      sea + "choppiness = 0.5\n" + gerstner + seed + haze + "[wind]\nspeed_mps = 6\n",
      sea + "[world]\nsea_level_m = -300\n",
      sea + "fetch_m = 9e3\n[sky]\npressure_pa.keys = [{ t = 0, value = 9e4 }]\n",
  };
  const ocl::Device device = ocl::Device::open();
  Scene scene = scene_of(texts[0]);
  world::World world(device, prepare_world(scene));
  auto before = everything(world);
  for (const std::string& text : texts) {
    const Scene edited = scene_of(text);
    edit_world(world, scene, edited);
    scene = edited;
    world::World fresh(device, prepare_world(scene));
    const auto now = everything(world);
    EXPECT_EQ(now, everything(fresh)) << text;
    if (&text != &texts[0]) {
      EXPECT_NE(now, before) << text;
    }
    before = now;
  }
}

// Fails if sun and air do not move with the view, or if they move the sea.
TEST(WorldScene, FollowsTheView) {
  const Scene scene = scene_of(
      "[ocean]\nsize = 32\ncascade_count = 1\n[sun]\nelevation_deg.keys = [{ t = 0, value = 60 }, { t = 9, "
      "value = "
      "1 }]\n[sky]\naerosol_optical_depth.keys = [{ t = 0, value = 0 }, { t = 9, value = 1 }]\n");
  const ocl::Device device = ocl::Device::open();
  world::World world(device, prepare_world(scene));
  const auto noon = everything(world);
  set_view(world, view_at(scene, 9.0));
  const auto evening = everything(world);
  EXPECT_EQ(std::get<0>(evening), std::get<0>(noon));
  EXPECT_NE(std::get<3>(evening), std::get<3>(noon));
  EXPECT_LT(sky::luminance(std::get<4>(evening)), 0.5 * sky::luminance(std::get<4>(noon)));
  EXPECT_EQ(world.parameters().atmosphere.aerosol_optical_depth, 1.0);
  set_view(world, view_at(scene, 0.0));
  EXPECT_EQ(everything(world), noon);
}

// Fails if a mesh that goes, and stands before those of a boat, sends the boat back to its start, or leaves
// its meshes behind.
TEST(WorldScene, OtherMeshesLeaveBoatsAlone) {
  const std::string sea = "[ocean]\nsize = 32\ncascade_count = 1\n", loose = "[[mesh]]\nshape = \"sphere\"\n";
  const std::string boat =
      "[[mesh]]\nname = \"hull\"\nshape = \"ship\"\nsize_m = 24\n[[mesh]]\nshape = \"box\"\naboard = "
      "\"boat\"\n"
      "[[body]]\nname = \"boat\"\nmesh = \"hull\"\nspeed_mps = 3\ndraught_m = 1.5\n";
  const Scene before = scene_of(sea + loose + boat), after = scene_of(sea + boat);
  world::World world(ocl::Device::open(), prepare_world(before));
  world.at(2.0, 10.0);
  const glm::dvec3 there_m = world.bodies()->pose(0, 2.0).mass_centre_m;
  const auto places_m = [&](std::size_t first) {
    world.at(2.0, 10.0);
    return std::pair(world.meshes()[first].motion().translation_m,
                     world.meshes()[first + 1].motion().translation_m);
  };
  const auto expected = places_m(1);
  edit_world(world, before, after);
  EXPECT_EQ(world.bodies()->start_s(), 0.0);
  EXPECT_EQ(world.bodies()->pose(0, 2.0).mass_centre_m, there_m);
  EXPECT_EQ(places_m(0), expected);
  edit_world(world, after, before);
  EXPECT_EQ(world.bodies()->start_s(), 0.0);
  EXPECT_EQ(places_m(1), expected);
  // One more aboard goes with it.
  edit_world(world, before, scene_of(sea + loose + boat + "[[mesh]]\nshape = \"box\"\naboard = \"boat\"\n"));
  EXPECT_EQ(world.bodies()->start_s(), 0.0);
  EXPECT_EQ(world.bodies()->settings()[0].aboard, (std::vector<std::size_t>{2, 3}));
}

// Fails if an edit sends a boat back to its start that only changes another boat or its own drive, or if a
// boat with another start, hull or load stays where it was.
TEST(WorldScene, BoatsBeginAnewOnlyWhereTheyMust) {
  const auto boat = [](const std::string& name, const std::string& more, const std::string& size_m = "24") {
    return "[[mesh]]\nname = \"" + name + "\"\nshape = \"ship\"\nsize_m = " + size_m +
           "\n[[body]]\nname = \"" + name + " boat\"\nmesh = \"" + name + "\"\nspeed_mps = 3\n" + more;
  };
  const std::string sea = "[ocean]\nsize = 32\ncascade_count = 1\n", first = "draught_m = 1.5\n",
                    second = "draught_m = 1.5\nz_m = 90\n";
  const Scene before = scene_of(sea + boat("a", first) + boat("b", second));
  const ocl::Device device = ocl::Device::open();
  // How far east both are, after an edit and before it.
  const auto far_after = [&](const std::string& text, std::size_t number) {
    world::World world(device, prepare_world(before));
    world.at(4.0, 10.0);
    const double there_m = world.bodies()->pose(1, 4.0).mass_centre_m.x;
    edit_world(world, before, scene_of(sea + text));
    world.at(4.0, 10.0);
    return std::pair(world.bodies()->pose(number, 4.0).mass_centre_m.x, there_m);
  };
  for (const std::string& text :
       {boat("a", "draught_m = 1.2\n") + boat("b", second), boat("a", first, "30") + boat("b", second),
        boat("c", first) + boat("b", second + "thrust_n = 3e3\nrudder_deg = 5\nwindage = 0\n"),
        boat("a", first) + boat("b", second + "[[body.mooring]]\nanchor_m = [0, -9, 0]\n"),
        boat("a", first) + boat("b", second) +
            "[[ocean.wake]]\ncentre = \"body\"\nbody = \"a boat\"\ncells = "
            "32\nhistory_s = 12\n"}) {
    const auto [now_m, there_m] = far_after(text, 1);
    EXPECT_NEAR(now_m, there_m, 1e-3) << text;
    EXPECT_GT(there_m, 9.0);
  }
  const auto [alone_m, there_m] = far_after(boat("b", second), 0);
  EXPECT_NEAR(alone_m, there_m, 1e-3);
  for (const std::string& text :
       {boat("a", first) + boat("b", first + "z_m = 95\n"), boat("a", first) + boat("b", second, "30"),
        boat("a", first) + boat("b", "draught_m = 1.2\nz_m = 90\n"),
        boat("a", first) + boat("b", second + "heading_deg = 5\n")}) {
    EXPECT_NEAR(far_after(text, 1).first, 0.0, 0.5) << text;
  }
}

// Fails if a scene that cannot be made leaves half of it behind.
TEST(WorldScene, RefusedEditChangesNothing) {
  const Scene scene = scene_of("[ocean]\nsize = 32\ncascade_count = 1\n");
  world::World world(ocl::Device::open(), prepare_world(scene));
  const auto before = everything(world);
  for (const char* more : {"spectrum_file = \"/nonexistent\"\n",
                           "[wind]\nspeed_mps = 20\n[sun]\ntime_utc = 2100-12-31T23:59:59Z\ntime_scale = "
                           "1\n[time]\nstart_s = 100\n",
                           "gravity_mps2 = 0.1\n[[ocean.swell]]\nperiod_s = 0.3\n"}) {
    EXPECT_THROW(edit_world(world, scene, scene_of(std::string("[ocean]\nsize = 32\n") + more)), Error);
    EXPECT_EQ(everything(world), before) << more;
  }
}

}  // namespace
}  // namespace offing::scene

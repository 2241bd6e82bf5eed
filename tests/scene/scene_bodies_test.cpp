// Bodies of a scene, as a world gets them.
#include "host/scene/prepare/scene_bodies.h"

#include <fstream>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "host/bodies/hull.h"
#include "host/bodies/hydrostatics.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/file/scene_hash.h"
#include "host/scene/prepare/scene_meshes.h"
#include "host/scene/prepare/scene_wakes.h"
#include "host/scene/prepare/sea.h"
#include "tests/io/temporary_folder.h"
#include "tests/scene/section_text.h"

namespace offing::scene {
namespace {

const std::string sea = "[ocean]\nsize = 32\n";
const std::string hull = "[[mesh]]\nname = \"hull\"\nshape = \"ship\"\nsize_m = 24\n";

std::vector<world::BodySettings> bodies_of(const std::string& text) {
  const Scene scene = test::scene_of(text);
  return prepare_bodies(scene, prepare_meshes(scene));
}

/// What asking for the bodies of a scene throws; empty if it does not.
std::optional<Error> error_of(const std::string& text) {
  try {
    bodies_of(text);
  } catch (const Error& error) {
    EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    EXPECT_FALSE(error.hint().empty());
    return error;
  }
  return std::nullopt;
}

std::string fault_of(const std::string& text) {
  const std::optional<Error> error = error_of(text);
  return error ? error->what() : "";
}

std::string hint_of(const std::string& text) {
  const std::optional<Error> error = error_of(text);
  return error ? error->hint() : "";
}

double draught_m(const world::BodySettings& settings) {
  const bodies::FloatingBody& body = settings.body;
  return bodies::level_that_displaces(body.hull, body.mass_kg / 1025.0, "ship") -
         bodies::extent_of(body.hull).low_m.y;
}

// Fails if a line without a length is not taut where its body floats at time 0, far from its start in the
// run-up, or if a length that is given does not count.
TEST(SceneBodies, LinesAreTautAtTheStart) {
  const std::string moored =
      sea + hull +
      "[[body]]\nmesh = \"hull\"\ndraught_m = 1.5\nspeed_mps = 3\nx_m = 100\nwindage = 2\n"
      "[[body.mooring]]\nhull_m = [12, 0, 0]\nanchor_m = [142, -40, 0]\n"
      "[[body.mooring]]\nlength_m = 7\n";
  const bodies::FloatingBody body = bodies_of(moored)[0].body;
  ASSERT_EQ(body.moorings.size(), 2u);
  EXPECT_NEAR(body.moorings[0].length_m, 50.0, 1.5);
  EXPECT_EQ(body.moorings[1].length_m, 7.0);
  EXPECT_EQ(body.drag.windage, 2.0);
}

// Fails if draught, mass or density do not load a body as they say: each gives the others. The ship's coarse
// hull encloses what the fine one does.
TEST(SceneBodies, AreLoadedByDraughtMassOrDensity) {
  const world::BodySettings by_draught =
      bodies_of(sea + hull + "[[body]]\nmesh = \"hull\"\ndraught_m = 1.5\n")[0];
  EXPECT_NEAR(draught_m(by_draught), 1.5, 1e-6);
  EXPECT_LE(by_draught.body.hull.faces.size(), 1000u);
  const std::string mass = std::to_string(by_draught.body.mass_kg);
  const world::BodySettings by_mass =
      bodies_of(sea + hull + "[[body]]\nmesh = \"hull\"\nmass_kg = " + mass + "\n")[0];
  EXPECT_NEAR(draught_m(by_mass), 1.5, 1e-6);
  const world::BodySettings cork =
      bodies_of(sea +
                "[[mesh]]\nshape = \"box\"\nsize_m = 0.5\n[[body]]\ndensity_kgpm3 = 256.25\nmass_centre_m = "
                "[0, -0.4, 0]\n")[0];
  EXPECT_NEAR(cork.body.mass_kg, 256.25, 1e-6);
  EXPECT_NEAR(draught_m(cork), 0.25, 1e-6);
  EXPECT_EQ(cork.body.mass_centre_m, glm::dvec3(0.0, -0.4, 0.0));
}

// A data base is that of the hull as it floats: moments about a point from the still water, here 0.4 m below
// it, in the axes of the mesh. Fails if it is not read, stays at the file's level, or a fault does not name
// the place.
TEST(SceneBodies, HaveHydrodynamicData) {
  const std::string body = sea + hull + "[[body]]\nmesh = \"hull\"\ndraught_m = 1.5\nhydrodynamics = \"";
  const world::BodySettings settings = bodies_of(body + OFFING_BOX + ".nc\"\n")[0];
  ASSERT_TRUE(settings.body.hydrodynamics);
  const HydrodynamicData& data = *settings.body.hydrodynamics;
  EXPECT_NEAR(data.water_level_m, bodies::extent_of(settings.body.hull).low_m.y + 1.5, 1e-6);
  EXPECT_NEAR(data.about_m.y, data.water_level_m - 0.4, 1e-9);
  EXPECT_EQ(data.density_kgpm3, 1025.0);
  // WAMIT's numbers are of hulls of another size: masses grow as lengths cubed.
  const auto wamit =
      bodies_of(body + OFFING_BOX + ".1\"\nhydrodynamics_length_m = 2\n")[0].body.hydrodynamics;
  EXPECT_NEAR(wamit->added_mass[0][7] / data.added_mass[0][7], 8.0, 1e-3);
  EXPECT_NE(fault_of(body + "none.nc\"\n").find("hydrodynamic"), std::string::npos)
      << fault_of(body + "none.nc\"\n");
  EXPECT_EQ(bodies_of(sea + hull + "[[body]]\nmesh = \"hull\"\n")[0].body.hydrodynamics, nullptr);
}

// Fails if a body is driven otherwise than its scene says: by forces from time 0 on, led there before; or
// along its path at any time.
TEST(SceneBodies, AreDriven) {
  const auto bodies =
      bodies_of(sea + hull + "[[mesh]]\nname = \"other\"\nshape = \"box\"\n" +
                "[[body]]\nmesh = \"hull\"\nx_m = 100\nheading_deg = 90\nspeed_mps = 3\nrudder_deg = 10\n"
                "thrust_n = { keys = [{ t = 0, value = 1000 }, { t = 10, value = 3000 }], interpolation = "
                "\"linear\" }\n"
                "[[body]]\nmesh = \"other\"\nmotion = \"path\"\nspeed_mps = 2\ndensity_kgpm3 = 300\n");
  ASSERT_EQ(bodies.size(), 2u);
  EXPECT_EQ(bodies[1].mesh, 1u);
  EXPECT_NEAR(bodies[0].body.start.mass_centre_m.x, 100.0, 1e-9);
  EXPECT_NEAR(bodies[0].body.start.mass_centre_m.z, -3.0 * 10.0, 1e-9);
  const BodyDrive before = bodies[0].drive(-1.0, 0.0);
  EXPECT_EQ(before.follows_path, 1);
  EXPECT_NEAR(before.velocity_z_mps, 3.0, 1e-4);
  const BodyDrive later = bodies[0].drive(5.0, 0.0);
  EXPECT_EQ(later.follows_path, 0);
  EXPECT_NEAR(later.thrust_n, 2000.0, 1e-3);
  EXPECT_NEAR(later.rudder_rad, 0.17453, 1e-5);
  const BodyDrive led = bodies[1].drive(7.0, 0.0);
  EXPECT_EQ(led.follows_path, 1);
  EXPECT_NEAR(led.tile_x * 64.0 + static_cast<double>(led.x_m), 2.0 * (7.0 + 1.0 / 120.0), 1e-4);
}

// Fails if a mesh's own place and turn are not within its body: here its bow is along -z.
TEST(SceneBodies, MeshesLieWithinThem) {
  const auto turned =
      bodies_of(sea + hull + "yaw_deg = 90\ny_m = 1\n[[body]]\nmesh = \"hull\"\ndraught_m = 1.5\n");
  const bodies::Extent extent = bodies::extent_of(turned[0].body.hull);
  EXPECT_GT(extent.high_m.z - extent.low_m.z, 20.0);
  EXPECT_NEAR(turned[0].mesh_in_hull.translation_m.y, 1.0, 1e-12);
}

// Fails if meshes aboard are not carried by the body that they name, or a body carries itself.
TEST(SceneBodies, CarryMeshes) {
  const std::string body = "[[body]]\nname = \"ship\"\nmesh = \"hull\"\n";
  const auto bodies =
      bodies_of(sea + hull + "[[mesh]]\nshape = \"box\"\naboard = \"ship\"\ny_m = 3\n" + body);
  EXPECT_EQ(bodies[0].aboard, std::vector<std::size_t>{1});
  EXPECT_NE(fault_of(sea + hull + "[[mesh]]\naboard = \"shop\"\n" + body)
                .find("a.toml:9:10: mesh.aboard: expected the name"),
            std::string::npos);
  EXPECT_NE(fault_of(sea + hull + "aboard = \"ship\"\n" + body).find("mesh.aboard"), std::string::npos);
}

// Fails if what cannot float is taken, or is not told where it is written.
TEST(SceneBodies, ToldWhereTheyAreWrong) {
  const std::string body = "[[body]]\nmesh = \"hull\"\n";
  EXPECT_EQ(fault_of(sea + hull + "[[body]]\nmesh = \"hul\"\n"),
            "a.toml:9:8: body.mesh: expected the name of a [[mesh]], got \"hul\"");
  EXPECT_EQ(hint_of(sea + hull + "[[body]]\nmesh = \"hul\"\n"), "did you mean hull? known here: hull");
  EXPECT_EQ(hint_of(sea + "[[mesh]]\nshape = \"ship\"\n[[body]]\nmesh = \"hull\"\n"),
            "no [[mesh]] has a name: give one this name");
  EXPECT_EQ(fault_of(hull + body), "a.toml:7:8: body.mesh: expected a sea for the body, found none");
  EXPECT_NE(fault_of(sea + hull + body + body)
                .find("a.toml:11:8: body.mesh: expected a mesh that no other body moves"),
            std::string::npos);
  EXPECT_NE(fault_of(sea + hull + body + "mass_kg = 1e9\n").find("expected a mass that displaces less"),
            std::string::npos);
  EXPECT_NE(fault_of(sea + hull + body + "draught_m = 100\n").find("expected a water level between"),
            std::string::npos);
  EXPECT_NE(fault_of(sea + "[[mesh]]\nshape = \"saddle\"\n[[body]]\n").find("expected a closed mesh"),
            std::string::npos);
  EXPECT_NE(test::refusal(sea + "[[body]]\nmass_kg = 1\ndraught_m = 1\n").find("a.toml:"), std::string::npos);
}

// Fails if a wake does not follow the body that its scene names, or an unknown name is taken.
TEST(SceneBodies, WakesFollowThem) {
  const std::string two = sea + hull +
                          "[[mesh]]\nname = \"b\"\nshape = \"box\"\n[[body]]\nmesh = \"hull\"\n" +
                          "[[body]]\nname = \"buoy\"\nmesh = \"b\"\n";
  const auto wakes_of = [](const std::string& text) { return prepare_wakes(test::scene_of(text), {}); };
  EXPECT_EQ(wakes_of(two + "[[ocean.wake]]\ncentre = \"body\"\n")[0].body, 0u);
  EXPECT_EQ(wakes_of(two + "[[ocean.wake]]\ncentre = \"body\"\nbody = \"buoy\"\nbehind_m = 7\n")[0].body, 1u);
  EXPECT_FALSE(wakes_of(two + "[[ocean.wake]]\n")[0].body);
  EXPECT_THROW(wakes_of(two + "[[ocean.wake]]\ncentre = \"body\"\nbody = \"boy\"\n"), Error);
  EXPECT_THROW(wakes_of(sea + "[[ocean.wake]]\ncentre = \"body\"\n"), Error);
}

// Fails if wakes that were baked with one hull are taken for those of another in a file of the same name.
TEST(SceneBodies, HullsAreInTheHash) {
  const TemporaryFolder folder;
  const auto hash = [&](const char* deck, Affects what) {
    std::ofstream(folder.path() / "hull.off")
        << "OFF\n4 4 0\n0 -1 0\n4 1 0\n-4 1 2\n-4 " << deck << " -2\n3 0 1 2\n3 0 2 3\n3 0 3 1\n3 1 3 2\n";
    const Scene scene = parse_scene(
        "version = 1\n[ocean]\nsize = 32\n[[mesh]]\nname = \"hull\"\nfile = \"hull.off\"\n"
        "[[body]]\nmesh = \"hull\"\ndraught_m = 0.5\n",
        "a.toml", folder.path());
    return scene_hash(scene, prepare_sea(scene), "", what);
  };
  EXPECT_NE(hash("1", shapes_sea_and_wakes), hash("1.5", shapes_sea_and_wakes));
  EXPECT_EQ(hash("1", shapes_sea), hash("1.5", shapes_sea));
}

// Fails if a file beside the one that the scene names, which is read with it, is left out; if a mesh that
// does not float counts; or if a missing file is told without its place in the scene.
TEST(SceneBodies, AllFilesOfBodiesAreInTheHash) {
  const TemporaryFolder folder;
  const auto write = [&](const char* name, const char* text) { std::ofstream(folder.path() / name) << text; };
  const auto hash = [&] {
    const Scene scene =
        parse_scene("version = 1\n" + sea + hull +
                        "[[mesh]]\nname = \"mast\"\nfile = \"mast.off\"\naboard = \"ship\"\n"
                        "[[body]]\nname = \"ship\"\nmesh = \"hull\"\nhydrodynamics = \"a.1\"\n",
                    "a.toml", folder.path());
    return scene_hash(scene, prepare_sea(scene), "", shapes_sea_and_wakes);
  };
  for (const char* name : {"a.1", "a.3", "mast.off"}) write(name, "1");
  const std::string first = hash();
  write("mast.off", "2");
  EXPECT_EQ(hash(), first);
  write("a.3", "2");
  const std::string second = hash();
  EXPECT_NE(second, first);
  write("a.hst", "2");
  EXPECT_NE(hash(), second);
  std::filesystem::remove(folder.path() / "a.1");
  try {
    hash();
    ADD_FAILURE() << "a missing file";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("body.hydrodynamics"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace offing::scene

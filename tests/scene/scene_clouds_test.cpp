// From the sections of a scene to the clouds of a world.

#include "host/scene/prepare/scene_clouds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <optional>
#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/particles/sampled_particles.h"
#include "host/clouds/shape/cloud_density.h"
#include "host/clouds/shape/genera.h"
#include "host/io/clouds/cloud_particles.h"
#include "host/io/vdb/vdb_volume.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/cloud_shapes.h"
#include "host/scene/schema/unused_parameters.h"
#include "tests/io/temporary_folder.h"

namespace offing::scene {
namespace {

using ::testing::HasSubstr;

class SceneClouds : public ::testing::Test {
 protected:
  Scene scene_of(const std::string& text) const {
    return parse_scene("version = 1\n" + text, "a.toml", folder_.path());
  }
  world::CloudSkyParameters sky_of(const std::string& text) const {
    return prepare_clouds(scene_of(text)).value();
  }

  std::string refusal(const std::string& text) const {
    try {
      prepare_clouds(scene_of(text));
    } catch (const Error& error) {
      EXPECT_EQ(error.kind(), ErrorKind::bad_input) << error.what();
      EXPECT_FALSE(error.hint().empty()) << error.what();
      return error.what();
    }
    return "";
  }

  TemporaryFolder folder_;
};

TEST_F(SceneClouds, NoneWithoutSections) {
  EXPECT_FALSE(prepare_clouds(scene_of("[clouds]\nseed = 3\n")));
}

// Fails if a clear sky is refused because a layer that covers nothing makes it.
TEST_F(SceneClouds, NoneOfEmptyLayers) {
  EXPECT_FALSE(prepare_clouds(scene_of("[[cloud_layer]]\ncoverage = 0\n")));
}

// Fails if a hidden cloud is shown, takes the place of another one in its list, or hides others.
TEST_F(SceneClouds, HiddenCloudsHaveNoParticles) {
  const std::string two = "[[cloud]]\nname = \"a\"\n[[cloud]]\nname = \"b\"\n";
  const auto sky = sky_of(two + "visible = \"off\"\n");
  ASSERT_EQ(sky.clouds.size(), 2u);
  EXPECT_EQ(sky.particles[0], nullptr);
  ASSERT_NE(sky.particles[1], nullptr);
  EXPECT_TRUE(sky.particles[1]->empty());
  EXPECT_EQ(sky, sky_of(two + "visible = \"off\"\n"));
  EXPECT_FALSE(prepare_clouds(scene_of("[[cloud]]\nvisible = \"off\"\n")));
  const std::string layer = "[[cloud_layer]]\ncoverage = 0.5\n";
  EXPECT_FALSE(prepare_clouds(scene_of(layer + "visible = \"off\"\n")));
  EXPECT_EQ(sky_of(layer + "[[cloud_layer]]\nvisible = \"off\"\n"), sky_of(layer));
}

// Fails if the shape of a hidden cloud is made, or one that is hidden and shown again is made anew.
TEST_F(SceneClouds, ShapesOfHiddenCloudsAreNotMade) {
  const Scene shown = scene_of("[[cloud]]\n[[cloud]]\nshape = \"head\"\ntarget_particles = 60\n");
  Scene hidden = shown;
  hidden.clouds[1].visible = CloudVisibility::off;
  CloudShapes shapes;
  EXPECT_FALSE(prepare_clouds(hidden, shapes)->clouds[1].shape);
  const auto shape = prepare_clouds(shown, shapes)->clouds[1].shape;
  ASSERT_TRUE(shape);
  EXPECT_FALSE(prepare_clouds(hidden, shapes)->clouds[1].shape);
  EXPECT_EQ(prepare_clouds(shown, shapes)->clouds[1].shape, shape);
}

// Fails if what a scene does not say is not the genus', or what it says is lost.
TEST_F(SceneClouds, GenusFillsInWhatIsNotSaid) {
  const clouds::CloudParameters usual = clouds::preset(clouds::Genus::stratus);
  const world::CloudSkyParameters sky = sky_of(
      "[[cloud]]\ngenus = \"stratus\"\nx_m = 50\nnoise_gain = 0.7\ng = 0.5\n[[cloud]]\ngenus = \"stratus\"\n"
      "seed = 2\nphase = \"mie_droplet\"\ny_m = 77\n");
  ASSERT_EQ(sky.clouds.size(), 2u);
  const clouds::CloudParameters& first = sky.clouds[0];
  EXPECT_EQ(first.balls, usual.balls);
  EXPECT_EQ(first.position_m, glm::dvec3(50.0, usual.position_m.y, 0.0));
  EXPECT_EQ(first.turbulence.gain, 0.7);
  EXPECT_EQ(first.turbulence.wavelength_m, usual.turbulence.wavelength_m);
  EXPECT_EQ(first.look.g, 0.5);
  EXPECT_EQ(first.look.phase, usual.look.phase);
  EXPECT_NE(sky.clouds[1].balls, usual.balls);
  EXPECT_EQ(sky.clouds[1].position_m.y, 77.0);
  EXPECT_EQ(sky.clouds[1].look.phase, clouds::PhaseKind::mie_droplet);
}

// Fails if lengths are scaled in part, or twice.
TEST_F(SceneClouds, ScaleIsOfAllLengths) {
  const auto cloud = [&](const std::string& scale) {
    return sky_of("[[cloud]]\n" + scale +
                  "base_m = -40\n[[cloud.ball]]\nx_m = 10\nradius_m = 100\n[[cloud.level]]\n"
                  "deviation_m = 8\n[[cloud.particle_edit]]\neye_m = [1, 2, 3]\npush_m = [4, 5, 6]\n")
        .clouds[0];
  };
  const clouds::CloudParameters one = cloud(""), three = cloud("scale = 3\n");
  EXPECT_EQ(three.balls[0].radius_m, 3.0 * one.balls[0].radius_m);
  EXPECT_EQ(three.balls[0].centre_m, 3.0 * one.balls[0].centre_m);
  EXPECT_EQ(three.levels[0].deviation_m, 3.0 * one.levels[0].deviation_m);
  EXPECT_EQ(three.base_m, 3.0 * *one.base_m);
  EXPECT_EQ(three.edits[0].selection.eye_m, glm::dvec3(3.0, 6.0, 9.0));
  EXPECT_EQ(three.edits[0].push_m, glm::dvec3(12.0, 15.0, 18.0));
  EXPECT_EQ(three.turbulence.wavelength_m, 3.0 * one.turbulence.wavelength_m);
}

TEST_F(SceneClouds, KeyframesAreAPath) {
  const clouds::CloudParameters cloud =
      sky_of("[[cloud]]\nx_m = { keys = [{ t = 0, value = 1 }, { t = 9, value = 5 }] }\nz_m = 4\n").clouds[0];
  ASSERT_TRUE(cloud.motion.path);
  EXPECT_EQ((*cloud.motion.path)[0].keys[1].value, 5.0);
  EXPECT_EQ((*cloud.motion.path)[2].keys[0].value, 4.0);
}

// More coverage or another seed is another sky; quality is of all clouds.
TEST_F(SceneClouds, LayersAreManyClouds) {
  const std::string layer = "[[cloud_layer]]\ngenus = \"stratocumulus\"\nextent_m = 20000\ncoverage = ";
  const world::CloudSkyParameters few = sky_of(layer + "0.2\n"), many = sky_of(layer + "0.5\n");
  EXPECT_GT(many.clouds.size(), few.clouds.size());
  EXPECT_NE(sky_of("[clouds]\nseed = 2\n" + layer + "0.2\n").clouds, few.clouds);
  const world::CloudSkyParameters coarse = sky_of("[clouds]\nquality = 0.5\n" + layer + "0.2\n");
  EXPECT_NEAR(coarse.clouds[0].target_particles, 0.5 * few.clouds[0].target_particles, 1.0);
}

// Fails if quality leaves grown clouds as they are. As many children have room as their radius over the
// parent's, squared, says, about: 13 to 20 % of those of the cumulus are of its first level, which stays.
TEST_F(SceneClouds, QualityIsOfGrownCloudsToo) {
  const ocl::Device device = ocl::Device::open();
  const auto count = [&](const std::string& quality) {
    const auto cloud = sky_of("[clouds]\nquality = " + quality + "\n[[cloud]]\n").clouds[0];
    return static_cast<double>(clouds::particles_at_rest(device, cloud).size());
  };
  const double usual = count("1");
  EXPECT_NEAR(count("0.5") / usual, 0.5, 0.15);
  EXPECT_NEAR(count("2") / usual, 2.0, 0.5);
}

// A volume that was written and is read back gives the same particles (C5 on the same cells). Fails if
// reading moves, drops or thins cells.
TEST_F(SceneClouds, AVolumeBecomesTheSameParticles) {
  const ocl::Device device = ocl::Device::open();
  clouds::CloudParameters cloud = clouds::preset(clouds::Genus::stratocumulus);
  cloud.position_m = {0.0, 900.0, 0.0};
  const CloudVolume volume = clouds::field_volume(device, cloud, 40.0, 0.0);
  write_vdb(folder_.path() / "a.vdb", {volume});
  const clouds::SamplingOptions options{.target_particles = 500, .seed = 1};
  const std::vector<CloudParticle> due = clouds::sampled_particles(volume, options, cloud.look);
  const world::CloudSkyParameters sky =
      sky_of("[[cloud]]\ngenus = \"stratocumulus\"\nfile = \"a.vdb\"\ntarget_particles = 500\n");
  const std::vector<CloudParticle> found = clouds::particles_at_rest(device, sky.clouds.at(0));
  ASSERT_EQ(found.size(), due.size());
  for (std::size_t i = 0; i < due.size(); ++i) {
    EXPECT_EQ(found[i].radius, due[i].radius);
    EXPECT_EQ(found[i].optical_mass, due[i].optical_mass);
    // Places are relative to the cloud's, 0 here: a float's half unit at 2 km.
    EXPECT_NEAR(found[i].x, due[i].x + volume.origin_m.x, 1e-3);
    EXPECT_NEAR(found[i].y, due[i].y + volume.origin_m.y, 1e-3);
  }
  EXPECT_EQ(sky.clouds[0].look.extinction_per_m, cloud.look.extinction_per_m);
}

TEST_F(SceneClouds, ParticlesOfAFileAreTaken) {
  const ParticleCloud file{.origin_m = {0.0, 1024.0, 0.0},
                           .particles = {{.x = 3.0f,
                                          .y = 4.0f,
                                          .z = 5.0f,
                                          .radius = 60.0f,
                                          .optical_mass = 99.0f,
                                          .red = 1.0f,
                                          .green = 1.0f,
                                          .blue = 1.0f,
                                          .texture = 1,
                                          .cloud = 0,
                                          .id = 5,
                                          .turn = 0.0f}}};
  write_cloud_particles(folder_.path() / "a.ply", file);
  const world::CloudSkyParameters sky = sky_of("[[cloud]]\nfile = \"a.ply\"\nx_m = 10\n");
  ASSERT_EQ(sky.particles.at(0)->size(), 1u);
  EXPECT_EQ(sky.particles[0]->front().y, 1028.0f);
  EXPECT_EQ(sky.clouds[0].position_m, glm::dvec3(10.0, 0.0, 0.0));
}

// Fails if a letter is empty or solid where it is open.
TEST_F(SceneClouds, TextIsAShape) {
  const clouds::CloudParameters cloud = sky_of("[[cloud]]\ntext = \"O\"\nsize_m = 400\n").clouds[0];
  ASSERT_TRUE(cloud.shape);
  const CloudVolume& shape = *cloud.shape;
  float most = 0.0f;
  for (const float density : shape.density) most = std::max(most, density);
  EXPECT_GT(most, 0.9f);
  const glm::dvec3 middle = -shape.origin_m / (CloudVolume::brick_cells * shape.cell_m);
  const auto place = [&](double x, double y, double z) {
    return static_cast<std::size_t>((static_cast<int>(z) * shape.bricks[1] + static_cast<int>(y)) *
                                        shape.bricks[0] +
                                    static_cast<int>(x));
  };
  const std::int32_t slot = shape.brick_of[place(middle.x, middle.y, middle.z)];
  double at_middle = 0.0;
  if (slot != CloudVolume::no_brick) {
    const glm::dvec3 cell = 8.0 * (middle - glm::floor(middle));
    const auto inside = static_cast<std::size_t>(
        (static_cast<int>(cell.z) * 8 + static_cast<int>(cell.y)) * 8 + static_cast<int>(cell.x));
    at_middle = shape.density[static_cast<std::size_t>(slot) * CloudVolume::cells_of_brick + inside];
  }
  EXPECT_EQ(at_middle, 0.0) << "the hole of the O is filled";
}

// Fails if a shape that a scene can name is not closed, so that nothing is inside, or is no other than the
// first.
TEST_F(SceneClouds, EachShapeCanBeFilled) {
  std::vector<std::size_t> cells;
  for (const char* shape : {"knot", "sphere", "ellipsoid", "torus", "head", "ship", "bird"}) {
    const auto cloud =
        sky_of(std::string("[[cloud]]\nshape = \"") + shape + "\"\nthickness_m = 10\n").clouds[0];
    ASSERT_TRUE(cloud.shape) << shape;
    EXPECT_GT(cloud.shape->density.size(), 0u) << shape;
    EXPECT_EQ(std::find(cells.begin(), cells.end(), cloud.shape->density.size()), cells.end()) << shape;
    cells.push_back(cloud.shape->density.size());
  }
}

// Fails if a shape stands another way than the scene says: a bird's wings lie along z, and along x once it is
// turned by 90 degrees.
TEST_F(SceneClouds, ShapesAreTurned) {
  const auto extent_m = [&](const std::string& turned) {
    const CloudVolume shape =
        *sky_of("[[cloud]]\nshape = \"bird\"\nsize_m = 400\nthickness_m = 10\nfluff_m = 5\n" + turned)
             .clouds[0]
             .shape;
    return shape.cell_m * CloudVolume::brick_cells *
           glm::dvec3(shape.bricks[0], shape.bricks[1], shape.bricks[2]);
  };
  const glm::dvec3 flying = extent_m(""), turned = extent_m("yaw_deg = 90\n"),
                   banked = extent_m("pitch_deg = 90\n");
  EXPECT_GT(flying.z, 1.2 * flying.x);
  EXPECT_GT(turned.x, 1.2 * turned.z);
  EXPECT_GT(banked.y, 1.2 * banked.x);
}

// Fails if a cloud that is moved, or another one that is edited, reads or makes the shape of this one again;
// or if one that is edited, or whose file is written anew, keeps its old one.
TEST_F(SceneClouds, ShapesAreKeptUntilTheyChange) {
  const auto write = [&](int bricks) {
    CloudVolume volume;
    volume.cell_m = 10.0;
    volume.bricks = {1, bricks, 1};
    for (int i = 0; i < bricks; ++i) volume.brick_of.push_back(i);
    volume.density.assign(volume.brick_of.size() * CloudVolume::cells_of_brick, 1.0f);
    write_vdb(folder_.path() / "a.vdb", {volume});
  };
  write(1);
  CloudShapes shapes;
  const auto next_sky = [&](const std::string& text) {
    return prepare_clouds(scene_of(text), shapes).value();
  };
  const std::string file = "[[cloud]]\nfile = \"a.vdb\"\n", letter = "[[cloud]]\ntext = \"K\"\n";
  const world::CloudSkyParameters before = next_sky(file + letter);
  const world::CloudSkyParameters moved =
      next_sky(file + "x_m = 9\nwind_mps = [5, 0, 0]\n" + letter + "y_m = 7\n");
  EXPECT_EQ(moved.clouds[0].shape, before.clouds[0].shape);
  EXPECT_EQ(moved.particles[0], before.particles[0]);
  EXPECT_EQ(moved.clouds[1].shape, before.clouds[1].shape);
  EXPECT_EQ(moved.clouds[0].look, before.clouds[0].look);
  EXPECT_EQ(moved.clouds[0].position_m.x, 9.0);
  const world::CloudSkyParameters edited =
      next_sky(file + "target_particles = 20\n" + letter + "size_m = 300\n");
  EXPECT_EQ(edited.clouds[0].target_particles, 20);
  EXPECT_TRUE(edited.clouds[0].takes_cells_of_shape);
  EXPECT_NE(edited.clouds[1].shape, before.clouds[1].shape);
  // Another size, since clocks of file systems may not tell two writes apart.
  const auto first = next_sky(file).clouds[0].shape;
  EXPECT_EQ(next_sky(file).clouds[0].shape, first);
  write(2);
  EXPECT_NE(next_sky(file).clouds[0].shape, first);
}

// Fails if an error names a value that nobody gave, in no place, or with a fix that is no key.
TEST_F(SceneClouds, FaultsOfFormSayWhereAndWhatToChange) {
  const auto hint = [&](const std::string& text) {
    try {
      prepare_clouds(scene_of(text));
    } catch (const Error& error) {
      return error.hint();
    }
    return std::string();
  };
  const std::string scaled = "[[cloud]]\nscale = 1000\n[[cloud.ball]]\nradius_m = 10000\n";
  EXPECT_THAT(refusal(scaled), HasSubstr("a.toml:3:9: cloud.scale: scaled, cloud.ball[0].radius_m"));
  EXPECT_THAT(hint(scaled), HasSubstr("another scale"));
  const std::string bird = "[[cloud]]\nshape = \"bird\"\nsize_m = 20\n";
  EXPECT_THAT(refusal(bird), HasSubstr("a.toml:3:9: cloud.shape"));
  EXPECT_THAT(hint(bird), HasSubstr("cloud.thickness_m"));
  const std::string layer = "[[cloud_layer]]\nextent_m = 1000000\ncoverage = 0.9\n";
  EXPECT_THAT(refusal(layer), HasSubstr("a.toml:3:12: cloud_layer.extent_m"));
  EXPECT_THAT(hint(layer), HasSubstr("cloud_layer.coverage"));
  EXPECT_THAT(refusal("[[cloud]]\ndroplet_um = 2\n[[cloud]]\n"), HasSubstr("a.toml:3:14: cloud.droplet_um"));
  std::ofstream(folder_.path() / "point.obj") << "v 1 1 1\nv 1 1 1\nv 1 1 1\nf 1 2 3\n";
  const std::string point = refusal("[[cloud]]\nmesh = \"point.obj\"\n");
  EXPECT_THAT(point, HasSubstr("a.toml:3:8: cloud.mesh"));
  EXPECT_THAT(point, testing::Not(HasSubstr("nan")));
  std::ofstream(folder_.path() / "far.ply")
      << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
         "property float radius\nproperty float optical_mass\nend_header\n1e38 -1e38 0 40 5\n";
  EXPECT_THAT(refusal("[[cloud]]\nscale = 1000\nfile = \"far.ply\"\n"), HasSubstr("cloud particle 0: x"));
}

// Fails if one of two forms of a cloud is chosen in silence.
TEST_F(SceneClouds, RefusesTwoForms) {
  EXPECT_THAT(refusal("[[cloud]]\ntext = \"K\"\nmesh = \"none.obj\"\n"),
              HasSubstr("cloud.text: expected one of"));
  EXPECT_THAT(refusal("[[cloud]]\nfile = \"a.vdb\"\nshape = \"bird\"\n"),
              HasSubstr("a.toml:4:9: cloud.shape: expected one of"));
}

// Fails if keys that have no part in a cloud are passed over in silence, or others are complained of.
TEST_F(SceneClouds, TellsKeysWithoutAPart) {
  const auto unused = [&](const std::string& text) { return unused_parameters(scene_of(text)); };
  EXPECT_THAT(
      unused("[[cloud]]\nmodelling = \"hierarchical\"\nbase_m = 3\ntext = \"K\"\ntarget_particles = 9\n"
             "[[cloud.ball]]\nradius_m = 7\n[[cloud.level]]\nratio = 0.4\n"),
      testing::UnorderedElementsAre(HasSubstr("cloud.modelling: not used: cloud.text makes it"),
                                    HasSubstr("cloud.base_m: not used: cloud.text makes it"),
                                    HasSubstr("cloud.ball.radius_m: not used: cloud.text makes it"),
                                    HasSubstr("cloud.level.ratio: not used: cloud.text makes it")));
  EXPECT_THAT(unused("[[cloud]]\ntarget_particles = 9\nbase_m = 3\n[[cloud.level]]\nratio = 0.4\n"),
              testing::ElementsAre(HasSubstr("cloud.target_particles: not used: it grows on its balls")));
  EXPECT_THAT(unused("[[cloud]]\ngenus = \"stratus\"\ntarget_particles = 9\nbase_m = 3\n"),
              testing::ElementsAre(HasSubstr("cloud.base_m: not used: it is sampled")));
  EXPECT_THAT(unused("[[cloud]]\nyaw_deg = 9\n[[cloud]]\nyaw_deg = 9\nshape = \"bird\"\n"),
              testing::ElementsAre(HasSubstr("a.toml:3:11: cloud.yaw_deg: not used: none of")));
}

// Clouds go from one scene to another with their keyframes, and nothing else does.
TEST_F(SceneClouds, CloudsOfAnotherScene) {
  const Scene from = scene_of(
      "[clouds]\nseed = 3\n[[cloud]]\nx_m = { keys = [{ t = 0, value = 1 }, { t = 9, value = 5 }] }\n");
  Scene to = scene_of(
      "[sun]\nelevation_deg = { keys = [{ t = 0, value = 1 }, { t = 9, value = 5 }] "
      "}\n[[cloud]]\n[[cloud]]\nz_m = "
      "{ keys = [{ t = 0, value = 1 }, { t = 9, value = 5 }] }\n");
  EXPECT_TRUE(are_other_clouds(from, to));
  copy_clouds(from, to);
  EXPECT_FALSE(are_other_clouds(from, to));
  EXPECT_EQ(to.clouds.size(), 1u);
  EXPECT_EQ(to.cloud_settings.seed, 3u);
  EXPECT_EQ(to.tracks.size(), 2u);
  EXPECT_TRUE(to.tracks.contains("sun.elevation_deg"));
}

TEST_F(SceneClouds, SaysWhereAFileIsWrong) {
  std::ofstream(folder_.path() / "bad.vdb") << "nothing";
  std::ofstream(folder_.path() / "bad.ply") << "nothing";
  EXPECT_THAT(refusal("[[cloud]]\nfile = \"none.vdb\"\n"),
              HasSubstr("a.toml:3:8: cloud.file: expected a volume"));
  EXPECT_THAT(refusal("[[cloud]]\nfile = \"bad.vdb\"\n"), HasSubstr("expected an OpenVDB file"));
  EXPECT_THAT(refusal("[[cloud]]\nfile = \"bad.ply\"\n"), HasSubstr("a.toml:3:8: cloud.file"));
  EXPECT_THAT(refusal("[[cloud]]\nfile = \"a.toml\"\n"), HasSubstr("expected a .vdb or a .ply"));
  EXPECT_THAT(refusal("[[cloud]]\nmesh = \"none.obj\"\n"), HasSubstr("cloud.mesh: expected a mesh"));
  EXPECT_THAT(refusal("[[cloud]]\ntext = \" \"\n"), HasSubstr("cloud.text"));
  EXPECT_THAT(refusal("[[cloud]]\nheat_k = 1\nheat_damping_per_s = 0.5\n"),
              HasSubstr("cloud.heat_damping_per_s"));
}

}  // namespace
}  // namespace offing::scene

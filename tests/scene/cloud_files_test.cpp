// Volumes and particles that a scene takes from files: their cells, places and colours.

#include <array>
#include <fstream>
#include <string>

#include <glm/common.hpp>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/clouds/particles/cloud_model.h"
#include "host/io/vdb/vdb_volume.h"
#include "host/scene/file/scene_file.h"
#include "host/scene/prepare/scene_clouds.h"
#include "tests/io/temporary_folder.h"

namespace offing::scene {
namespace {

using ::testing::HasSubstr;

class CloudFiles : public ::testing::Test {
 protected:
  world::CloudSkyParameters sky_of(const std::string& text) const {
    return prepare_clouds(parse_scene("version = 1\n" + text, "a.toml", folder_.path())).value();
  }

  TemporaryFolder folder_;
};

// Fails if colours of a volume are dropped, come to other places, or count where the scene gives one. Two
// blocks, red and blue, of the file's own cells and of a field that is frayed anew.
TEST_F(CloudFiles, ColoursOfAVolumeAreTaken) {
  CloudVolume volume{.cell_m = 10.0, .bricks = {2, 1, 1}, .brick_of = {0, 1}, .density = {}};
  volume.density.assign(1024, 1.0f);
  VdbCloud file{.volume = volume, .albedo = {}};
  for (int i = 0; i < 1024; ++i) {
    file.albedo.push_back(i < 512 ? std::array{1.0f, 0.25f, 0.25f} : std::array{0.25f, 0.25f, 1.0f});
  }
  write_vdb(folder_.path() / "a.vdb", file);
  const ocl::Device device = ocl::Device::open();
  const std::string text = "[[cloud]]\nfile = \"a.vdb\"\ntarget_particles = 60\n";
  for (const char* more : {"", "sampling = \"random\"\n", "noise_blend = 0.2\n"}) {
    const auto particles = clouds::particles_at_rest(device, sky_of(text + more).clouds[0]);
    // Between the middles of the two colours' cells a field has both, which merging takes along: 0.06
    // measured.
    const float gate = *more == 'n' ? 0.1f : 0.0f;
    int reds = 0, blues = 0;
    for (const CloudParticle& particle : particles) {
      if (particle.x < 60.0f) {
        EXPECT_NEAR(particle.red, 1.0f, gate) << more;
        EXPECT_NEAR(particle.blue, 0.25f, gate) << more;
        ++reds;
      } else if (particle.x > 100.0f) {
        EXPECT_NEAR(particle.red, 0.25f, gate) << more;
        EXPECT_NEAR(particle.blue, 1.0f, gate) << more;
        ++blues;
      }
    }
    EXPECT_GT(reds, 10) << more;
    EXPECT_GT(blues, 10) << more;
  }
  for (const CloudParticle& particle :
       clouds::particles_at_rest(device, sky_of(text + "colour = [0.5, 0.5, 0.5]\n").clouds[0])) {
    ASSERT_EQ(particle.red, 0.5f);
  }
}

/// Of a volume at a place of the cloud.
float density_at(const CloudVolume& volume, const glm::dvec3& place_m) {
  const glm::ivec3 cell(glm::floor((place_m - volume.origin_m) / volume.cell_m));
  const int brick = (cell.z / 8 * volume.bricks[1] + cell.y / 8) * volume.bricks[0] + cell.x / 8;
  const std::int32_t kept = volume.brick_of.at(static_cast<std::size_t>(brick));
  if (kept < 0) return 0.0f;
  const int inside = (cell.z % 8 * 8 + cell.y % 8) * 8 + cell.x % 8;
  return volume.density[static_cast<std::size_t>(kept) * CloudVolume::cells_of_brick +
                        static_cast<std::size_t>(inside)];
}

// Fails if a file whose z axis points up lies on its side, if it or a quarter turn puts a cell or a colour
// where it does not belong, or if another turn of a volume is taken and not done. Places of the middles of
// its cells.
TEST_F(CloudFiles, AreTurned) {
  CloudVolume given{
      .origin_m = {100.0, -30.0, 40.0}, .cell_m = 10.0, .bricks = {2, 1, 3}, .brick_of = {}, .density = {}};
  VdbCloud file;
  for (int i = 0; i < 6; ++i) given.brick_of.push_back(i == 4 ? -1 : i - (i > 4));
  for (int i = 0; i < 5 * 512; ++i) {
    given.density.push_back(static_cast<float>(1 + i));
    file.albedo.push_back({static_cast<float>(i) / 2560.0f, 0.5f, 0.5f});
  }
  file.volume = given;
  write_vdb(folder_.path() / "a.vdb", file);
  const std::string cloud = "[[cloud]]\nfile = \"a.vdb\"\n";
  struct Case {
    const char* keys;
    glm::dvec3 (*place)(const glm::dvec3&);
  };
  for (const Case& one :
       {Case{"", [](const glm::dvec3& p) { return p; }},
        {"up = \"z\"\n", [](const glm::dvec3& p) { return glm::dvec3(p.x, p.z, -p.y); }},
        {"pitch_deg = -90\n", [](const glm::dvec3& p) { return glm::dvec3(p.x, p.z, -p.y); }},
        {"up = \"z\"\nyaw_deg = 90\nscale = 2\n",
         [](const glm::dvec3& p) { return 2.0 * glm::dvec3(p.y, p.z, p.x); }}}) {
    const auto shape = sky_of(cloud + one.keys).clouds[0].shape;
    ASSERT_TRUE(shape) << one.keys;
    for (int i = 0; i < 16 * 8 * 24; ++i) {
      const glm::dvec3 there = given.origin_m + 10.0 * (glm::dvec3(i % 16, i / 16 % 8, i / 128) + 0.5);
      ASSERT_EQ(density_at(*shape, one.place(there)), density_at(given, there)) << one.keys << i;
    }
    for (std::size_t i = 0; i < shape->density.size(); ++i)
      ASSERT_EQ(shape->albedo[i][0], (shape->density[i] - 1.0f) / 2560.0f) << one.keys;
  }
  try {
    sky_of(cloud + "pitch_deg = 30\n");
    ADD_FAILURE() << "a turn of 30 degrees is taken";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("a.toml:3:8: cloud.file: expected yaw_deg, pitch_deg"));
    EXPECT_THAT(error.hint(), HasSubstr("up = \"z\""));
  }
  std::ofstream(folder_.path() / "a.ply")
      << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
         "property float radius\nproperty float optical_mass\nend_header\n10 20 30 4 5\n";
  const auto particles = sky_of("[[cloud]]\nfile = \"a.ply\"\nup = \"z\"\n").particles[0];
  EXPECT_EQ(glm::vec3((*particles)[0].x, (*particles)[0].y, (*particles)[0].z),
            glm::vec3(10.0f, 30.0f, -20.0f));
}

}  // namespace
}  // namespace offing::scene

// Clouds of particles as a whole: what others take from them.
#include "host/clouds/particles/cloud_model.h"

#include <cstring>

#include <gtest/gtest.h>

#include "host/clouds/shape/cloud_density.h"
#include "host/clouds/shape/genera.h"

namespace offing::clouds {
namespace {

class CloudModelTest : public testing::Test {
 protected:
  const ocl::Device device_ = ocl::Device::open();
};

TEST_F(CloudModelTest, TheSameParametersGiveTheSameParticles) {
  for (const Genus genus : {Genus::cumulus, Genus::altocumulus}) {
    const auto one = particles_at_rest(device_, preset(genus)),
               other = particles_at_rest(device_, preset(genus));
    ASSERT_EQ(one.size(), other.size());
    EXPECT_EQ(std::memcmp(one.data(), other.data(), one.size() * sizeof(CloudParticle)), 0);
  }
}

// Fails if a recoloured particle counts as one of its look, whose light is then that of another albedo, or if
// every cloud is taken for coloured, which takes 1.6 times as long.
TEST_F(CloudModelTest, KnowsWhetherParticlesHaveTheirOwnAlbedo) {
  CloudParameters cloud = preset(Genus::cumulus);
  EXPECT_FALSE(CloudModel(device_, cloud).has_own_albedo());
  std::vector<CloudParticle> particles = particles_at_rest(device_, cloud);
  particles[7].blue = 0.5f;
  EXPECT_TRUE(CloudModel(device_, cloud, particles).has_own_albedo());
  cloud.look.albedo = {0.3, 1.0, 0.3};
  EXPECT_FALSE(CloudModel(device_, cloud).has_own_albedo());
}

// Fails if particles lie elsewhere than the field that they are sampled from: middles of mass, a cell apart
// at most.
TEST_F(CloudModelTest, ParticlesLieWhereTheDensityIs) {
  CloudParameters cloud = preset(Genus::lenticular);
  cloud.position_m = {12'345.6, 3000.0, -77.0};
  CloudModel model(device_, cloud, 3);
  EXPECT_EQ(model.count(), static_cast<std::uint32_t>(cloud.target_particles));
  const glm::dvec3 origin_m(12'000.0, 3000.0, 0.0);
  model.at(0.0, origin_m);
  glm::dvec3 sum(0.0);
  double mass = 0.0;
  for (const CloudParticle& particle : model.particles().read()) {
    EXPECT_EQ(particle.cloud, 3u);
    sum += static_cast<double>(particle.optical_mass) * glm::dvec3(particle.x, particle.y, particle.z);
    mass += static_cast<double>(particle.optical_mass);
  }
  const CloudVolume volume = density_volume(device_, cloud, 20.0, 0.0);
  glm::dvec3 volume_sum(0.0);
  double volume_mass = 0.0;
  std::size_t number = 0;
  for (int z = 0; z < volume.bricks[2]; ++z) {
    for (int y = 0; y < volume.bricks[1]; ++y) {
      for (int x = 0; x < volume.bricks[0]; ++x) {
        const std::int32_t brick = volume.brick_of[number++];
        if (brick == CloudVolume::no_brick) continue;
        for (int cell = 0; cell < 512; ++cell) {
          const glm::dvec3 place(x * 8 + cell % 8, y * 8 + cell / 8 % 8, z * 8 + cell / 64);
          const auto density = static_cast<double>(
              volume.density[static_cast<std::size_t>(brick) * 512 + static_cast<std::size_t>(cell)]);
          volume_sum += density * (volume.origin_m - origin_m + (place + 0.5) * volume.cell_m);
          volume_mass += density;
        }
      }
    }
  }
  for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR((sum / mass)[axis], (volume_sum / volume_mass)[axis], 3.0);
  // Cells of another size: 2 % for the rim.
  EXPECT_NEAR(optical_mass(volume) / mass, 1.0, 0.02);
}

// Fails if the density of a grown cloud is not that of its particles.
TEST_F(CloudModelTest, DensityOfAHierarchyIsThatOfItsParticles) {
  const CloudParameters cloud = preset(Genus::cumulus);
  double mass = 0.0;
  for (const CloudParticle& particle : particles_at_rest(device_, cloud)) {
    mass += static_cast<double>(particle.optical_mass);
  }
  const CloudVolume volume = density_volume(device_, cloud, 16.0, 60.0);
  EXPECT_NEAR(optical_mass(volume) / mass, 1.0, 1e-5);
  EXPECT_EQ(volume.extinction_per_m, cloud.look.extinction_per_m);
}

TEST_F(CloudModelTest, SeveralCloudsShareAnArray) {
  std::vector<CloudParticle> rest(2);
  for (std::size_t i = 0; i < 2; ++i) {
    rest[i].x = 1.0f + static_cast<float>(i);
    rest[i].radius = 1.0f;
  }
  const CloudModel one(device_, {}, rest, 0), other(device_, {}, rest, 1);
  const ocl::Buffer<CloudParticle> all(device_, 4, "all clouds");
  one.at(0.0, {0.0, 0.0, 0.0}, all, 0);
  other.at(0.0, {-10.0, 0.0, 0.0}, all, 2);
  const auto found = all.read();
  EXPECT_EQ(found[1].x, 2.0f);
  EXPECT_EQ(found[2].x, 11.0f);
  EXPECT_EQ(found[3].cloud, 1u);
}

TEST_F(CloudModelTest, ACloudOfNothingHasNoParticles) {
  CloudParameters nothing;
  CloudModel model(device_, nothing);
  model.at(1.0);
  EXPECT_EQ(model.count(), 0u);
  nothing.modelling = Modelling::sampled;
  EXPECT_EQ(CloudModel(device_, nothing).count(), 0u);
  EXPECT_TRUE(density_volume(device_, nothing, 10.0, 0.0).density.empty());
}

}  // namespace
}  // namespace offing::clouds

// Presets of the genera: where they are, how thick, how many particles.
#include "host/clouds/shape/genera.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "host/clouds/particles/cloud_model.h"
#include "tests/ocl/expect_error.h"

namespace offing::clouds {
namespace {

constexpr Genus genera[] = {Genus::cirrus,      Genus::stratus,      Genus::cumulus,    Genus::stratocumulus,
                            Genus::altocumulus, Genus::cumulonimbus, Genus::lenticular, Genus::funnel};

/// Where particles have all but a thousandth of their mass, along an axis: m.
struct Extent {
  double low_m = 0.0, high_m = 0.0;
};

Extent extent_of(std::vector<CloudParticle> particles, float CloudParticle::*axis) {
  std::sort(particles.begin(), particles.end(),
            [&](const CloudParticle& a, const CloudParticle& b) { return a.*axis < b.*axis; });
  double sum = 0.0, before = 0.0;
  for (const CloudParticle& particle : particles) sum += static_cast<double>(particle.optical_mass);
  Extent extent;
  for (const CloudParticle& particle : particles) {
    // Half of the mass of a ball lies within 0.49 radii of its middle.
    if (before <= 0.0005 * sum) extent.low_m = static_cast<double>(particle.*axis - 0.5f * particle.radius);
    before += static_cast<double>(particle.optical_mass);
    if (before <= 0.9995 * sum) extent.high_m = static_cast<double>(particle.*axis + 0.5f * particle.radius);
  }
  return extent;
}

// Fails if a layout is not as its range says: thickness within 30 %, width within 25 %, all but what hangs
// from a funnel above the base.
TEST(GeneraTest, AreAsHighAndThickAsTheySay) {
  const ocl::Device device = ocl::Device::open();
  for (const Genus genus : genera) {
    const GenusRange range = range_of(genus);
    const CloudParameters cloud = preset(genus);
    EXPECT_EQ(genus_named(range.name), genus);
    EXPECT_GE(cloud.position_m.y, range.lowest_base_m);
    EXPECT_LE(cloud.position_m.y, range.highest_base_m);
    const std::vector<CloudParticle> particles = particles_at_rest(device, cloud);
    EXPECT_GE(particles.size(), 500u) << range.name;
    EXPECT_LE(particles.size(), 4000u) << range.name;
    const Extent y = extent_of(particles, &CloudParticle::y), x = extent_of(particles, &CloudParticle::x);
    EXPECT_NEAR(y.high_m - y.low_m, range.thickness_m, 0.3 * range.thickness_m) << range.name;
    EXPECT_NEAR(x.high_m - x.low_m, range.width_m, 0.25 * range.width_m) << range.name;
    if (genus != Genus::funnel) {
      EXPECT_NEAR(y.low_m, 0.0, 0.15 * range.thickness_m) << range.name;
    }
  }
}

// Fails if an id is given twice, a radius or mass is not positive, or a texture is of the other set: heaps
// are crisp, all else is soft (C8), however they are modelled.
TEST(GeneraTest, ParticlesAreSound) {
  const ocl::Device device = ocl::Device::open();
  for (const Genus genus : genera) {
    const bool is_heap =
        genus == Genus::cumulus || genus == Genus::stratocumulus || genus == Genus::cumulonimbus;
    const std::vector<CloudParticle> particles = particles_at_rest(device, preset(genus));
    for (std::uint32_t i = 0; i < particles.size(); ++i) {
      const CloudParticle& particle = particles[i];
      ASSERT_EQ(particle.id, i);
      ASSERT_GT(particle.radius, 0.0f);
      ASSERT_GT(particle.optical_mass, 0.0f);
      ASSERT_EQ(particle.texture / CLOUD_TEXTURES, is_heap ? 0u : 1u) << range_of(genus).name;
    }
  }
}

TEST(GeneraTest, SeedsAndSizesDiffer) {
  const CloudParameters one = preset(Genus::cumulus, 1), other = preset(Genus::cumulus, 2),
                        large = preset(Genus::cumulus, 1, 2.0);
  EXPECT_NE(one.balls[3].centre_m, other.balls[3].centre_m);
  EXPECT_EQ(large.balls[3].radius_m, 2.0 * one.balls[3].radius_m);
  offing::test::expect_error(ErrorKind::bad_input, "\"nimbus\"", [] { genus_named("nimbus"); });
}

}  // namespace
}  // namespace offing::clouds

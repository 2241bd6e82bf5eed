// Clouds of fewer particles beside whole ones: what is kept of their mass, form, shade and light.
#include "host/clouds/particles/particle_thinning.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <map>
#include <numeric>
#include <set>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/base/error.h"
#include "host/clouds/light/particle_light.h"
#include "host/clouds/particles/cloud_model.h"
#include "host/clouds/shape/genera.h"
#include "host/clouds/shape/metaball.h"
#include "tests/clouds/example_clouds.h"

namespace offing::clouds {
namespace {

constexpr int genus_count = 8;
constexpr double kept_share = 1.0 / 16.0;

glm::dvec3 place_of(const CloudParticle& particle) {
  return {particle.x, particle.y, particle.z};
}

/// Sums over a cloud.
struct Sums {
  double mass_m2 = 0.0, cube_m3 = 0.0;
  glm::dvec3 middle_m{0.0};
  double spread_m = 0.0;  // of its mass about the middle, root mean square, each ball's own included

  explicit Sums(const std::vector<CloudParticle>& particles) {
    for (const CloudParticle& particle : particles) {
      mass_m2 += double{particle.optical_mass};
      cube_m3 += std::pow(double{particle.radius}, 3);
      middle_m += double{particle.optical_mass} * place_of(particle);
    }
    middle_m /= mass_m2;
    double square = 0.0;
    for (const CloudParticle& particle : particles) {
      const glm::dvec3 way_m = place_of(particle) - middle_m;
      square += double{particle.optical_mass} *
                (glm::dot(way_m, way_m) + ball_variance * std::pow(double{particle.radius}, 2));
    }
    spread_m = std::sqrt(square / mass_m2);
  }
};

class ParticleThinningTest : public testing::TestWithParam<int> {
 protected:
  std::vector<CloudParticle> whole() { return particles_at_rest(device_, parameters_); }

  const ocl::Device device_ = ocl::Device::open();
  const CloudParameters parameters_ = preset(static_cast<Genus>(GetParam()));
};

INSTANTIATE_TEST_SUITE_P(Genera, ParticleThinningTest, testing::Range(0, genus_count), [](const auto& genus) {
  return std::string(range_of(static_cast<Genus>(genus.param)).name);
});

// Fails if a cloud without halvings is another than it was, or a number of them is taken that there is not.
TEST_P(ParticleThinningTest, LeavesWholeCloudsAlone) {
  const auto all = whole(), same = thinned_particles(all, 0);
  ASSERT_EQ(same.size(), all.size());
  EXPECT_EQ(std::memcmp(same.data(), all.data(), all.size() * sizeof(CloudParticle)), 0);
  EXPECT_THROW(thinned_particles(all, -1), Error);
  EXPECT_THROW(thinned_particles(all, most_particle_halvings + 1), Error);
  EXPECT_TRUE(thinned_particles({}, 1).empty());
}

// Fails if a cloud gains or loses optical mass or moves, which are exact but for the rounding of floats; if
// it fills a larger volume, or spreads its mass farther or less far; or if more or fewer are left than were
// to be.
TEST_P(ParticleThinningTest, KeepsMassAndPlace) {
  const auto all = whole();
  const Sums due(all);
  for (int halvings = 1; halvings <= most_particle_halvings; ++halvings) {
    const auto left = thinned_particles(all, halvings);
    const Sums found(left);
    EXPECT_NEAR(found.mass_m2 / due.mass_m2, 1.0, 1e-6);
    EXPECT_LT(found.cube_m3 / due.cube_m3, 1.0 + 1e-6);
    EXPECT_LT(glm::distance(found.middle_m, due.middle_m), 1e-5 * due.spread_m);
    RecordProperty(fmt::format("spread_{}", halvings), std::to_string(found.spread_m / due.spread_m));
    EXPECT_NEAR(found.spread_m / due.spread_m, 1.0, 0.02) << halvings;
    const double share = std::ldexp(1.0, -halvings), number = static_cast<double>(all.size());
    const double due_count = number * (kept_share + (1.0 - kept_share) * share);
    EXPECT_NEAR(static_cast<double>(left.size()), due_count, 0.01 * number + 4.0) << halvings;
  }
}

// Fails if clouds jump as they are thinned where the wind drags their thin parts ahead: their middle, by more
// than a tenth of the way that it drags the thinnest. Joined ones count as thick as what they are of where
// radii are 2^(h/3) times as large; those that are kept whole count as thinner, and are a sixteenth.
TEST_P(ParticleThinningTest, StaysWhereTheWindDragsIt) {
  const CloudModel model(device_, parameters_, 0);
  const auto moved = [&](const CloudModel& of) {
    const ocl::Buffer<CloudParticle> target(device_, std::max<std::size_t>(of.count(), 1), "moved");
    of.at(0.0, glm::dvec3(0.0), target, 0);
    return Sums(target.read());
  };
  const Sums due = moved(model);
  const double dragged_m = parameters_.motion.drag * glm::length(parameters_.motion.wind_mps);
  for (int halvings = 1; halvings <= most_particle_halvings; ++halvings) {
    const Sums found = moved(model.thinned(device_, halvings));
    RecordProperty(fmt::format("moved_m_{}", halvings),
                   std::to_string(glm::distance(found.middle_m, due.middle_m)));
    // Noise sways neighbours alike, but for what lies between them.
    EXPECT_LT(glm::distance(found.middle_m, due.middle_m), 0.1 * dragged_m + 0.01 * due.spread_m) << halvings;
  }
}

// Fails if a quarter has particles that a half has not, if any is there twice or out of its order, or if a
// size that a level of a hierarchy has is given up wholly or kept wholly.
TEST_P(ParticleThinningTest, IsNestedAndOfAllSizes) {
  const auto all = whole();
  std::set<unsigned int> before;
  for (const CloudParticle& particle : all) before.insert(particle.id);
  for (int halvings = 1; halvings <= most_particle_halvings; ++halvings) {
    const auto left = thinned_particles(all, halvings);
    std::set<unsigned int> ids;
    for (const CloudParticle& particle : left) ids.insert(particle.id);
    EXPECT_EQ(ids.size(), left.size());
    EXPECT_TRUE(std::includes(before.begin(), before.end(), ids.begin(), ids.end())) << halvings;
    EXPECT_TRUE(std::ranges::is_sorted(left, {}, [](const CloudParticle& particle) { return particle.id; }));
    if (parameters_.modelling == Modelling::hierarchical) {
      // Seeds and two levels, each half as large as what it grows on, about.
      std::map<int, std::pair<double, double>> sizes;  // how many, and how many are left
      for (const CloudParticle& particle : all) {
        auto& [number, kept] = sizes[std::ilogb(particle.radius)];
        ++number;
        kept += ids.contains(particle.id) ? 1.0 : 0.0;
      }
      ASSERT_GE(sizes.size(), 3u);
      for (const auto& [octave, counts] : sizes)
        EXPECT_GE(counts.second / counts.first, 0.7 * std::ldexp(1.0, -halvings)) << octave;
    }
    before = ids;
  }
}

// Fails if a part of a cloud thins out for another: the mass in each quarter of it, and whether there is a
// particle wherever there was one.
TEST_P(ParticleThinningTest, IsEven) {
  const auto all = whole();
  const Sums due(all);
  const auto shares = [&](const std::vector<CloudParticle>& particles) {
    std::array<double, 4> masses{};
    for (const CloudParticle& particle : particles) {
      const glm::dvec3 way_m = place_of(particle) - due.middle_m;
      masses[(way_m.x > 0.0 ? 1u : 0u) + (way_m.z > 0.0 ? 2u : 0u)] +=
          double{particle.optical_mass} / due.mass_m2;
    }
    return masses;
  };
  for (int halvings = 1; halvings <= most_particle_halvings; ++halvings) {
    const auto left = thinned_particles(all, halvings);
    const auto before = shares(all), after = shares(left);
    for (std::size_t quarter = 0; quarter < before.size(); ++quarter)
      EXPECT_NEAR(after[quarter], before[quarter], 0.03) << quarter;
    double bare_m2 = 0.0;
    for (const CloudParticle& particle : all) {
      const bool is_covered = std::ranges::any_of(left, [&](const CloudParticle& other) {
        return glm::distance(place_of(particle), place_of(other)) < double{other.radius};
      });
      if (!is_covered) bare_m2 += double{particle.optical_mass};
    }
    RecordProperty(fmt::format("bare_{}", halvings), std::to_string(bare_m2 / due.mass_m2));
    EXPECT_LT(bare_m2 / due.mass_m2, halvings == 1 ? 0.015 : 0.03) << halvings;
  }
}

/// Of parallel rays through the square around a cloud, what of them it stops in the mean.
double stopped_share(const std::vector<CloudParticle>& particles, const glm::dvec3& middle_m, double radius_m,
                     const glm::dvec3& toward_eye) {
  constexpr int pixels = 160;
  std::vector<CloudSprite> sprites;
  for (const CloudParticle& particle : particles) {
    const double square_m2 = std::pow(double{particle.radius}, 2);
    sprites.push_back(
        {.red = 0.0f,
         .green = 0.0f,
         .blue = 0.0f,
         .optical_depth = static_cast<float>(double{particle.optical_mass} / (ball_mass * square_m2))});
  }
  const test::SpriteView view = test::view_of(particles, sprites, middle_m, radius_m, toward_eye, pixels);
  return std::accumulate(view.opacity.begin(), view.opacity.end(), 0.0) / (pixels * pixels);
}

/// Of a sphere around a cloud, with some room for wider particles.
double farthest_m(const std::vector<CloudParticle>& particles, const glm::dvec3& middle_m) {
  double farthest = 0.0;
  for (const CloudParticle& particle : particles)
    farthest =
        std::max(farthest, glm::distance(place_of(particle), middle_m) + 1.3 * double{particle.radius});
  return farthest;
}

// The mean depth along rays follows from the mass; what is stopped falls short of that where depths differ
// from ray to ray, and grows with what balls cover. Fails if it is off by more than 4 % with half of the
// particles, or 9 % with a quarter.
TEST_P(ParticleThinningTest, LetsAsMuchThrough) {
  const auto all = whole();
  const Sums sums(all);
  const double radius_m = farthest_m(all, sums.middle_m);
  for (const glm::dvec3& toward_eye :
       {glm::dvec3(1.0, 0.0, 0.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(0.6, 0.0, 0.8)}) {
    const double stopped = stopped_share(all, sums.middle_m, radius_m, toward_eye);
    for (int halvings = 1; halvings <= most_particle_halvings; ++halvings) {
      const auto left = thinned_particles(all, halvings);
      const double off = stopped_share(left, sums.middle_m, radius_m, toward_eye) / stopped - 1.0;
      RecordProperty(fmt::format("off_{}_{:.0f}_{:.0f}", halvings, 10 * toward_eye.x, 10 * toward_eye.y),
                     std::to_string(off));
      EXPECT_NEAR(off, 0.0, halvings == 1 ? 0.04 : 0.09) << halvings;
    }
  }
}

// Fails if a cloud of fewer particles sends another mean light, of what it covers: 4 % with half of them, 7 %
// with a quarter, toward eyes before, beside and behind it.
TEST_P(ParticleThinningTest, SendsTheSameLight) {
  constexpr int pixels = 96;
  const auto all = whole();
  const Sums sums(all);
  const double radius_m = farthest_m(all, sums.middle_m);
  CloudIllumination light;
  light.suns.push_back({glm::normalize(glm::dvec3(0.5, 0.6, 0.6)), glm::dvec3(100.0)});
  light.sky_kcdpm2 = glm::dvec3(4.0);
  light.ground_kcdpm2 = glm::dvec3(2.0);
  const auto mean_light = [&](const std::vector<CloudParticle>& particles, const glm::dvec3& toward_eye) {
    const ocl::Buffer<CloudParticle> on_device(device_, particles, "particles");
    ParticleLight lighting(device_);
    lighting.relight(on_device, static_cast<std::uint32_t>(particles.size()), light,
                     std::span(&parameters_.look, 1));
    ocl::Buffer<CloudSprite> sprites(device_, particles.size(), "sprites");
    lighting.see(glm::vec3(sums.middle_m + 20.0 * radius_m * toward_eye), sprites);
    const test::SpriteView view =
        test::view_of(particles, sprites.read(), sums.middle_m, radius_m, toward_eye, pixels);
    return view.intensity_kcd.y / view.covered_m2;
  };
  for (const glm::dvec3& toward_eye : {glm::normalize(glm::dvec3(0.5, 0.2, 0.6)), glm::dvec3(0.8, 0.0, -0.6),
                                       glm::dvec3(-0.6, 0.0, -0.8), glm::dvec3(0.0, -1.0, 0.0)}) {
    const double due = mean_light(all, toward_eye);
    for (int halvings = 1; halvings <= most_particle_halvings; ++halvings) {
      const double off = mean_light(thinned_particles(all, halvings), toward_eye) / due - 1.0;
      RecordProperty(fmt::format("off_{}_{:.0f}_{:.0f}", halvings, 10 * toward_eye.x, 10 * toward_eye.y),
                     std::to_string(off));
      EXPECT_NEAR(off, 0.0, halvings == 1 ? 0.04 : 0.07) << halvings;
    }
  }
}

CloudParticle ball(float x, float mass, unsigned int id) {
  return {.x = x,
          .y = 0.0f,
          .z = 0.0f,
          .radius = 10.0f,
          .optical_mass = mass,
          .red = 1.0f,
          .green = 0.5f,
          .blue = 0.25f,
          .texture = 4,
          .cloud = 0,
          .id = id,
          .turn = 1.5f};
}

// Fails if two particles do not become the one that has all of both, or if albedos alike become others by
// rounding, which would make a cloud count as coloured.
TEST(ParticleThinning, JoinsNeighbours) {
  const auto one = thinned_particles(std::vector{ball(0.0f, 100.0f, 7), ball(4.0f, 300.0f, 9)}, 1);
  ASSERT_EQ(one.size(), 1u);
  EXPECT_EQ(one[0].id, 9u) << "the heavier one";
  EXPECT_FLOAT_EQ(one[0].x, 3.0f);
  EXPECT_FLOAT_EQ(one[0].optical_mass, 400.0f);
  // 3 m^2 are the mean square of 3 m and 1 m, weighed by mass.
  EXPECT_FLOAT_EQ(one[0].radius, static_cast<float>(std::sqrt(100.0 + 3.0 / ball_variance)));
  const auto apart = thinned_particles(std::vector{ball(0.0f, 100.0f, 7), ball(20.0f, 300.0f, 9)}, 1);
  EXPECT_FLOAT_EQ(apart[0].radius, 10.0f * std::cbrt(2.0f)) << "no larger than both";
  EXPECT_EQ(one[0].red, 1.0f);
  EXPECT_EQ(one[0].green, 0.5f);
  EXPECT_EQ(one[0].blue, 0.25f);
  EXPECT_EQ(one[0].turn, 1.5f);
  std::vector<CloudParticle> painted{ball(0.0f, 100.0f, 1), ball(4.0f, 300.0f, 2)};
  painted[0].green = 0.9f;
  EXPECT_FLOAT_EQ(thinned_particles(painted, 1)[0].green, 0.6f);
  // Nothing is seen of what has no mass, wherever it is.
  const auto ghost = thinned_particles(std::vector{ball(0.0f, 0.0f, 1), ball(4.0f, 0.0f, 2)}, 1);
  ASSERT_EQ(ghost.size(), 1u);
  EXPECT_EQ(ghost[0].x, 0.0f);
}

// Fails if neighbours are not those that are joined: pairs far apart.
TEST(ParticleThinning, JoinsWhatIsNear) {
  std::vector<CloudParticle> pairs;
  for (unsigned int i = 0; i < 15; ++i) pairs.push_back(ball(1000.0f * static_cast<float>(i % 8), 100.0f, i));
  for (CloudParticle& particle : pairs) particle.y = particle.id < 8 ? 0.0f : 6.0f;
  const auto left = thinned_particles(pairs, 1);
  ASSERT_EQ(left.size(), 8u);
  for (const CloudParticle& particle : left) {
    const bool is_pair = particle.id != 7;
    EXPECT_EQ(particle.x, 1000.0f * static_cast<float>(particle.id)) << particle.id;
    EXPECT_EQ(particle.y, is_pair ? 3.0f : 0.0f) << particle.id;
  }
}

}  // namespace
}  // namespace offing::clouds

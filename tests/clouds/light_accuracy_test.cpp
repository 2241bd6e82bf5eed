// Light on clouds of every genus, and of every scene that comes with Offing, beside photons followed in
// double precision.
#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include "host/clouds/cloud_model.h"
#include "host/clouds/genera.h"
#include "host/clouds/particle_light.h"
#include "host/clouds/photon_tracer.h"
#include "host/scene/scene_clouds.h"
#include "host/scene/scene_file.h"
#include "tests/clouds/example_clouds.h"

namespace offing::clouds {
namespace {

// Directions toward eyes: the corners of an icosahedron. Light is averaged over cones around them.
constexpr int eye_count = 12;
constexpr double cone_rad = 0.3;

std::vector<glm::dvec3> toward_eyes() {
  std::vector<glm::dvec3> eyes;
  for (int axis = 0; axis < 3; ++axis) {
    for (int corner = 0; corner < 4; ++corner) {
      glm::dvec3 eye(0.0);
      eye[axis] = corner % 2 == 0 ? -1.0 : 1.0;
      eye[(axis + 1) % 3] = corner < 2 ? -std::numbers::phi : std::numbers::phi;
      eyes.push_back(glm::normalize(eye));
    }
  }
  return eyes;
}

CloudIllumination afternoon() {
  CloudIllumination light;
  light.suns.push_back({glm::normalize(glm::dvec3(0.5, 0.6, 0.6)), glm::dvec3(100.0)});
  light.sky_kcdpm2 = glm::dvec3(4.0);
  light.ground_kcdpm2 = glm::dvec3(2.0);
  return light;
}

/// The particles of a cloud, and a sphere around them.
struct ShippedCloud {
  CloudParameters parameters;
  std::vector<CloudParticle> particles;
  glm::dvec3 middle_m{0.0};
  double radius_m = 0.0, mean_particle_m = 0.0;

  ShippedCloud(const ocl::Device& device, CloudParameters shipped) : parameters(std::move(shipped)) {
    particles = particles_at_rest(device, parameters);
    glm::dvec3 low(1e9), high(-1e9);
    for (const CloudParticle& particle : particles) {
      low = glm::min(low, place_of(particle) - double{particle.radius});
      high = glm::max(high, place_of(particle) + double{particle.radius});
      mean_particle_m += particle.radius / static_cast<double>(particles.size());
    }
    middle_m = 0.5 * (low + high);
    for (const CloudParticle& particle : particles)
      radius_m = std::max(radius_m, glm::length(place_of(particle) - middle_m) + particle.radius);
  }

  static glm::dvec3 place_of(const CloudParticle& particle) { return {particle.x, particle.y, particle.z}; }
};

/// Intensities of the billboards toward the eyes, kcd: means over the cones by Radon's rule of seven points,
/// which is exact for polynomials of the fifth degree over a disc.
std::vector<double> shown(const ocl::Device& device, const ShippedCloud& cloud) {
  const ocl::Buffer<CloudParticle> particles(device, cloud.particles, "particles");
  ocl::Buffer<CloudSprite> sprites(device, cloud.particles.size(), "sprites");
  ParticleLight light(device);
  light.relight(particles, static_cast<std::uint32_t>(cloud.particles.size()), afternoon(),
                std::span(&cloud.parameters.look, 1));
  std::vector<double> intensities;
  for (const glm::dvec3& eye : toward_eyes()) {
    const glm::dvec3 aside = glm::normalize(glm::cross(eye, glm::dvec3(0.1, 0.3, 0.9))),
                     up = glm::cross(eye, aside);
    double sum_kcd = 0.0;
    for (int point = 0; point < 7; ++point) {
      const double from_middle_rad = point == 0 ? 0.0 : std::sqrt(2.0 / 3.0) * cone_rad,
                   around_rad = point * std::numbers::pi / 3.0;
      const glm::dvec3 toward =
          std::cos(from_middle_rad) * eye +
          std::sin(from_middle_rad) * (std::cos(around_rad) * aside + std::sin(around_rad) * up);
      light.see(glm::vec3(cloud.middle_m + 1e6 * toward), sprites);
      sum_kcd += (point == 0 ? 0.25 : 0.125) *
                 test::view_of(cloud.particles, sprites.read(), cloud.middle_m, cloud.radius_m, toward, 96)
                     .intensity_kcd.y;
    }
    intensities.push_back(sum_kcd);
  }
  return intensities;
}

/// Spearman's rank correlation. Two values that the reference has within 10 % of each other count as ordered
/// as there.
double rank_correlation(const std::vector<double>& found, const std::vector<double>& reference) {
  const std::size_t count = found.size();
  std::vector<double> found_ranks(count, 0.0), ranks(count, 0.0);
  for (std::size_t i = 0; i < count; ++i) {
    for (std::size_t j = 0; j < count; ++j) {
      const bool is_above = reference[i] > reference[j];
      const bool is_near = std::abs(reference[i] - reference[j]) < 0.1 * std::max(reference[i], reference[j]);
      ranks[i] += is_above ? 1.0 : 0.0;
      found_ranks[i] += (is_near ? is_above : found[i] > found[j]) ? 1.0 : 0.0;
    }
  }
  const auto about_mean = [count](std::vector<double> values) {
    const double mean = std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(count);
    for (double& value : values) value -= mean;
    return values;
  };
  const std::vector<double> a = about_mean(found_ranks), b = about_mean(ranks);
  const auto product = [](const std::vector<double>& u, const std::vector<double>& v) {
    return std::inner_product(u.begin(), u.end(), v.begin(), 0.0);
  };
  return product(a, b) / std::sqrt(product(a, a) * product(b, b));
}

struct Kind {
  std::string name;
  int photons;             ///< of each light: standard errors are below 1 %
  std::string scene = {};  ///< that has the cloud; of the preset with that name otherwise
  std::size_t index = 0;   ///< in the scene, layers last

  CloudParameters cloud() const {
    if (scene.empty()) return preset(genus_named(name), 1);
    const auto sky = scene::prepare_clouds(scene::load_scene(OFFING_SCENES "/" + scene + ".toml"));
    return sky.value().clouds.at(index);
  }
};

class LightAccuracyTest : public testing::TestWithParam<Kind> {};

// Fails if a cloud is too bright or too dark from somewhere, or from the wrong side: the light that
// its billboards send toward twelve eyes, within 15 % of the reference, whose standard error is 1 % at most;
// and in the right order.
TEST_P(LightAccuracyTest, BillboardsShowWhatPhotonsDo) {
  const int photons = GetParam().photons;
  const ocl::Device device = ocl::Device::open();
  const ShippedCloud cloud(device, GetParam().cloud());
  const std::vector<double> found = shown(device, cloud);
  // Half as many more cells a radius change what photons find by less than 1 %.
  const VolumeMedium medium(
      test::volume_of(cloud.particles, std::max(cloud.mean_particle_m / 3.5, cloud.radius_m / 150.0)));
  const std::vector<TracedIntensity> traced = traced_intensities(
      medium, cloud.parameters.look, afternoon(), toward_eyes(), cone_rad, {.samples = photons, .seed = 7});
  std::vector<double> reference;
  double worst = 0.0;
  for (int eye = 0; eye < eye_count; ++eye) {
    const auto i = static_cast<std::size_t>(eye);
    reference.push_back(traced[i].kcd.y);
    EXPECT_LE(traced[i].relative_error, 0.01) << eye;
    EXPECT_NEAR(found[i] / reference[i], 1.0, 0.15) << "toward eye " << eye;
    worst = std::max(worst, std::abs(found[i] / reference[i] - 1.0));
  }
  RecordProperty("worst", fmt::format("{:.3f}", worst));
  EXPECT_GE(rank_correlation(found, reference), 0.9);
}

const std::vector<Kind> kinds{
    {"cumulus", 4'300'000},
    {"stratus", 1'600'000},
    {"cirrus", 600'000},
    {"stratocumulus", 1'300'000},
    {"altocumulus", 650'000},
    {"lenticular", 1'600'000},
    {"funnel", 1'900'000},
    {"cumulonimbus", 4'200'000},
    {"snowman", 3'900'000, "shapes", 0},
    {"person", 3'800'000, "shapes", 1},
    {"letter", 4'400'000, "shapes", 2},
    {"bird", 4'200'000, "shapes", 3},
    {"stratus_first", 1'600'000, "stratus", 0},
    {"cirrus_first", 600'000, "cirrus", 0},
    {"cirrus_second", 600'000, "cirrus", 1},
    {"cirrus_third", 600'000, "cirrus", 2},
    {"cirrus_fourth", 600'000, "cirrus", 3},
    {"cirrus_fifth", 600'000, "cirrus", 4},
    {"dusk_cumulus_second", 4'400'000, "dusk", 1},
    {"dusk_cumulus_third", 4'100'000, "dusk", 2},
    {"dusk_altocumulus", 650'000, "dusk", 3},
    {"sky_lenticular", 1'600'000, "sky", 0},
    {"sky_cumulonimbus", 4'200'000, "sky", 1},
    {"sky_cumulus", 3'200'000, "sky", 2},
};

INSTANTIATE_TEST_SUITE_P(Shipped, LightAccuracyTest, testing::ValuesIn(kinds),
                         [](const auto& kind) { return kind.param.name; });

}  // namespace
}  // namespace offing::clouds
